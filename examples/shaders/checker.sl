// checker.sl: a chequered floor.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Squares of `size` in the shader's own x and z, matte, with an optional mirror reflection that Fresnel's law would
// make strongest at grazing angles; here Schlick's approximation stands for it.

surface checker(float Ka = 1, Kd = 0.9, Kr = 0; float size = 1;
                color light = color(0.85, 0.83, 0.78), dark = color(0.12, 0.12, 0.15);
                string space = "shader") {
  normal Nf = faceforward(normalize(N), I);
  vector V = -normalize(I);
  point PP = transform(space, P);
  // A little off the integers, so that a floor at y = 0 does not flicker between two rows.
  float column = floor(xcomp(PP) / size + 1e-4);
  float row = floor(zcomp(PP) / size + 1e-4);
  color base = mod(column + row, 2) < 0.5 ? light : dark;

  Oi = Os;
  Ci = base * (Ka * ambient() + Kd * diffuse(Nf));
  if (Kr > 0) {
    float grazing = pow(1 - max(V . Nf, 0), 5);
    float share = Kr * (0.04 + 0.96 * grazing);
    Ci = Ci * (1 - share) + share * color trace(P, reflect(-V, Nf));
  }
  Ci *= Os;
}
