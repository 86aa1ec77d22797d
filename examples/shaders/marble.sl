// marble.sl: white stone with turbulent veins.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Veins are where a sum of octaves of noise is near zero: |2 noise - 1| has creases there, and octave after octave
// adds half the height at twice the frequency.

// Sum of creased noise, in about [0, 1].
float turbulence(point p; uniform float octaves) {
  float sum = 0, height = 0.5;
  point q = p;
  uniform float i;
  for (i = 0; i < octaves; i += 1) {
    sum += height * abs(2 * noise(q) - 1);
    q *= 2;
    height *= 0.5;
  }
  return sum;
}

surface marble(float Ka = 1, Kd = 0.7, Ks = 0.4, roughness = 0.06; color specularcolor = 1;
               float frequency = 2; float octaves = 6; float sharpness = 20;
               color stone = color(0.88, 0.87, 0.83), vein = color(0.18, 0.19, 0.25)) {
  normal Nf = faceforward(normalize(N), I);
  vector V = -normalize(I);
  point PP = transform("shader", P) * frequency;
  float t1 = turbulence(PP, octaves);
  float bands = sin(xcomp(PP) * PI + 6 * t1);
  float veined = exp(-sharpness * bands * bands) * smoothstep(0.1, 0.5, t1);
  color base = Cs * mix(stone * (0.9 + 0.2 * noise(3 * PP)), vein, veined);
  Oi = Os;
  Ci = Os * (base * (Ka * ambient() + Kd * diffuse(Nf)) +
             specularcolor * Ks * specular(Nf, V, roughness));
}
