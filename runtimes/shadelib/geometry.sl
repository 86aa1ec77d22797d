// Directions, distances and what happens to light at a surface.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

float distance(point a, b) { return length(a - b); }

// A choice, never a product with a sign: the length stays exactly N's, and where I lies in the surface the result
// is N.
vector faceforward(vector N, I, Nref) { return I . Nref > 0 ? -N : N; }

vector reflect(vector I, N) { return I - 2 * (I . N) * N; }

// Snell's law for I and N of unit length, N facing against I, eta = outside / inside. The square of the cosine
// inside is 1 - eta^2 (1 - c^2), written such that nothing cancels where eta is near 1 or the angle near
// grazing. It is negative where all light is reflected; an infinite eta makes it NaN, which is total as well.
vector refract(vector I, N; float eta) {
  float c = I . N;
  float k = (1 - eta) * (1 + eta) + (eta * c) * (eta * c);
  return k >= 0 ? eta * I - (eta * c + sqrt(k)) * N : vector(0, 0, 0);
}

// Fresnel's equations for unpolarised light at a dielectric. A quotient of zeros is 0 (see <anysl/domain.h>), so
// eta = 1 reflects nothing even at grazing; the least eta keeps a missing medium (eta = 0) reflecting all.
void fresnel(vector I, N; float eta; output float Kr, Kt; output vector R, T) {
  float n = max(abs(eta), 1e-30);
  float c = abs(I . N);
  float k = (1 - n) * (1 + n) + (n * c) * (n * c);
  float share = 1;
  if (k >= 0) {
    float inside = sqrt(k);
    float perpendicular = (n * c - inside) / (n * c + inside);
    float parallel = (c - n * inside) / (c + n * inside);
    share = 0.5 * (perpendicular * perpendicular + parallel * parallel);
  }
  Kr = share;
  Kt = 1 - share;
  R = reflect(I, N);
  T = refract(I, N, n);
}

// Rodrigues' formula about the axis from P1 to P2. Without an axis the point stays.
point rotate(point Q; float angle; point P1, P2) {
  vector axis = normalize(P2 - P1), v = Q - P1;
  float c = cos(angle), s = sin(angle);
  vector turned = c * v + s * (axis ^ v) + (1 - c) * (axis . v) * axis;
  return P1 == P2 ? Q : P1 + turned;
}

// The nearest point of the segment lies at t of its length.
float ptlined(point Q, P0, P1) {
  vector segment = P1 - P0, v = Q - P0;
  float t = clamp((v . segment) / (segment . segment), 0, 1);
  return length(v - t * segment);
}
