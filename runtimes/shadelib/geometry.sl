// Directions and distances. Refraction, which needs more digits than `float` has, is in runtimes/real.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

float distance(point a, b) { return length(a - b); }

// A choice, never a product with a sign: the length stays exactly N's, and where I lies in the surface the result
// is N.
vector faceforward(vector N, I, Nref) { return I . Nref > 0 ? -N : N; }

vector reflect(vector I, N) { return I - 2 * (I . N) * N; }

// Rodrigues' formula about the axis from P1 to P2. Without an axis the point stays.
point rotate(point Q; float angle; point P1, P2) {
  vector axis = normalize(P2 - P1), v = Q - P1;
  float c = cos(angle), s = sin(angle);
  vector turned = c * v + s * (axis ^ v) + (1 - c) * (axis . v) * axis;
  return P1 == P2 ? Q : P1 + turned;
}

// The nearest point of the segment lies at t of its length.
float ptlined(point P0, P1, Q) {
  vector segment = P1 - P0, v = Q - P0;
  float t = clamp((v . segment) / (segment . segment), 0, 1);
  return length(v - t * segment);
}
