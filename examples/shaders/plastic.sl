// plastic.sl: a diffuse body under a clear gloss.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard surface "plastic": the highlight has a colour of its own.

surface plastic(float Ka = 1, Kd = 0.5, Ks = 0.5, roughness = 0.1; color specularcolor = 1) {
  normal Nf = faceforward(normalize(N), I);
  vector V = -normalize(I);
  Oi = Os;
  Ci = Os * (Cs * (Ka * ambient() + Kd * diffuse(Nf)) +
             specularcolor * Ks * specular(Nf, V, roughness));
}
