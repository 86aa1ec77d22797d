// glass.sl: clear or frosted glass with traced reflection and refraction.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Fresnel's equations share the light between a reflected and a refracted ray, each scaled by a weight of its own and
// traced where it matters. With blur > 0 both become averages over samples x samples rays, jittered over a
// square across the ideal direction, which looks like glass with a rough surface.
//
//   Ka Kd Ks          weights of ambient, diffuse and specular light
//   Kr Kt             weights of reflection and refraction
//   roughness         of the lights' highlights
//   blur              half the side of the square of directions, for rays of unit length; 0: sharp
//   eta               index of refraction of the inside against the outside
//   specularcolor     tint of reflection and highlights
//   transmitcolor     tint of refraction
//   samples           rays along each side of the square

// Two vectors of unit length that are orthogonal to a direction and to each other.
void orthonormals(vector dir; output vector across, up) {
  vector other = abs(xcomp(dir)) < 0.5 ? vector(1, 0, 0) : vector(0, 1, 0);
  across = normalize(dir ^ other);
  up = across ^ dir;
}

// A number in [-1, 1] in cell i of `count` cells of equal width, anywhere in the cell.
float jittered(float i, count) {
  return 2 * (i + float random()) / count - 1;
}

surface glass(float Ka = 0.2, Kd = 0, Ks = 0.5, Kr = 1, Kt = 1, roughness = 0.05, blur = 0, eta = 1.5;
              color specularcolor = 1, transmitcolor = 1;
              float samples = 1) {
  vector IN = normalize(I);
  normal Nf = faceforward(normalize(N), I);
  vector Rfdir, Rrdir; // directions of reflection and refraction
  vector across, up;
  float kr, kt;
  uniform float i, j;

  // A ray that meets the back of the surface comes from inside of the glass.
  fresnel(IN, Nf, (I . N < 0) ? 1.0 / eta : eta, kr, kt, Rfdir, Rrdir);
  kr *= Kr;
  kt *= Kt;

  color ev = 0; // reflected
  if (kr > 0.001) {
    Rfdir = normalize(Rfdir);
    if (blur > 0) {
      orthonormals(Rfdir, across, up);
      color sum = 0;
      for (i = 0; i < samples; i += 1) {
        for (j = 0; j < samples; j += 1) {
          vector R = Rfdir + blur * jittered(i, samples) * across +
                     blur * jittered(j, samples) * up;
          // A jittered ray must not dive below the surface.
          if (R . Nf < 0)
            R -= 2 * (R . Nf) * vector Nf;
          sum += color trace(P, R);
        }
      }
      ev = sum / (samples * samples);
    } else {
      ev = trace(P, Rfdir);
    }
    ev *= kr;
  }

  color cr = 0; // refracted
  if (kt > 0.001) {
    Rrdir = normalize(Rrdir);
    if (blur > 0) {
      orthonormals(Rrdir, across, up);
      color sum = 0;
      for (i = 0; i < samples; i += 1) {
        for (j = 0; j < samples; j += 1) {
          vector R = Rrdir + blur * jittered(i, samples) * across +
                     blur * jittered(j, samples) * up;
          if (R . Nf > 0)
            R -= 2 * (R . Nf) * vector Nf;
          sum += color trace(P, R);
        }
      }
      cr = sum / (samples * samples);
    } else {
      cr = trace(P, Rrdir);
    }
    cr *= kt;
  }

  Oi = 1;
  Ci = Cs * (Ka * ambient() + Kd * diffuse(Nf)) +
       specularcolor * (ev + Ks * specular(Nf, -IN, roughness)) +
       transmitcolor * cr;
}
