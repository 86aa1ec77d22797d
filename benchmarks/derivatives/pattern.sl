// pattern.sl: a veined stone, in the forms that are compared.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// FORM is one of
//   PLAIN        nobody asks for a derivative
//   FILTERSTEP   one edge is as soft as a pixel is wide; the rest is PLAIN
//   CARRIED      the shader asks how its whole colour changes from point to point
//   DIFFERENCES  the same question, answered by shading the neighbours as well

#define PLAIN 0
#define FILTERSTEP 1
#define CARRIED 2
#define DIFFERENCES 3

float turbulence(point p) {
  float i, sum = 0, frequency = 1;
  for (i = 0; i < 4; i += 1) {
    sum += abs(float noise(p * frequency) - 0.5) / frequency;
    frequency *= 2;
  }
  return sum;
}

color stone(point p; float x; vector toLight) {
  float vein = pow(0.5 + 0.5 * sin(6 * xcomp(p) + 9 * turbulence(p * 4)), 3);
  color base = mix(color(0.2, 0.24, 0.35), color(0.95, 0.92, 0.85), vein);
#if FORM == FILTERSTEP
  base *= 0.5 + 0.5 * filterstep(0.5, mod(x * 8, 1));
#else
  base *= 0.5 + 0.5 * step(0.5, mod(x * 8, 1));
#endif
  float facing = max(normalize(p) . toLight, 0);
  return base * (0.1 + facing) + pow(facing, 20);
}

surface pattern() {
  vector toLight = normalize(vector(0.6, -0.48, -0.64));
  color c = stone(P, s, toLight);
#if FORM == CARRIED
  color across = Du(c) * du, along = Dv(c) * dv;
#elif FORM == DIFFERENCES
  color across = stone(P + dPdu * du, s + du, toLight) - c;
  color along = stone(P + dPdv * dv, s, toLight) - c;
#else
  color across = 0, along = 0;
#endif
  Ci = c + 0.5 * (across + along);
  Oi = 1;
}
