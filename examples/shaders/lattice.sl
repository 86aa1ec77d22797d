// lattice.sl: a lit, shiny lattice with soft edges, through whose holes light passes.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// How opaque it is depends on nothing that light does, so that shadow rays can ask for that alone
// (Attribute "visibility" "transmission" ["shader"]; docs/effects.md).
//
//   Ka Kd Kr   weights of ambient, diffuse and mirrored light
//   frequency  how many bars go across from s or t = 0 to 1
//   width      share of a bar, between 0 and 1
//   veil       opacity of the holes

surface lattice(float Ka = 1, Kd = 0.7, Kr = 0.2, frequency = 8, width = 0.4, veil = 0.1;) {
  normal Nf = faceforward(normalize(N), I);
  color mirrored = 0;
  if (Kr > 0)
    mirrored = Kr * trace(P, reflect(normalize(I), Nf));

  // How far the nearest bar's middle is, as a share of their distance: 0 to 0.5.
  float across = abs(mod(s * frequency, 1) - 0.5);
  float along = abs(mod(t * frequency, 1) - 0.5);
  float edge = width / 2;
  float bar = 1 - smoothstep(0.8 * edge, edge, min(across, along));

  Oi = Os * mix(veil, 1, bar);
  Ci = Oi * (Cs * (Ka * ambient() + Kd * diffuse(Nf)) + mirrored);
}
