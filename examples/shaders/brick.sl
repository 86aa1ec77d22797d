// brick.sl: a wall of bricks in running bond.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Rows of bricks over s and t, every second one shifted by half a brick; each brick has a shade of its own.

surface brick(float Ka = 1, Kd = 1; float width = 0.25, height = 0.08, gap = 0.012;
              color clay = color(0.55, 0.2, 0.12), mortar = color(0.6, 0.58, 0.55);
              float variation = 0.35) {
  normal Nf = faceforward(normalize(N), I);
  float row = floor(t / (height + gap));
  float shift = mod(row, 2) * 0.5;
  float along = s / (width + gap) + shift;
  float column = floor(along);
  float ss = (along - column) * (width + gap);
  float tt = t - row * (height + gap);

  // 1 inside of the brick, 0 in the mortar, with edges as soft as a third of the gap.
  float soft = gap / 3;
  float inside = smoothstep(0, soft, ss) * (1 - smoothstep(width - soft, width, ss)) *
                 smoothstep(0, soft, tt) * (1 - smoothstep(height - soft, height, tt));
  float shade = 1 + variation * (float cellnoise(column, row) - 0.5);
  float stain = 0.85 + 0.3 * float noise(s * 60, t * 60);
  color base = mix(mortar, clay * shade, inside) * stain;
  Oi = Os;
  Ci = Os * Cs * base * (Ka * ambient() + Kd * diffuse(Nf));
}
