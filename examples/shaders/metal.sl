// metal.sl: a rough metal that reflects the lights only.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard surface "metal": highlights have the colour of the surface.

surface metal(float Ka = 1, Ks = 1, roughness = 0.1) {
  normal Nf = faceforward(normalize(N), I);
  vector V = -normalize(I);
  Oi = Os;
  Ci = Os * Cs * (Ka * ambient() + Ks * specular(Nf, V, roughness));
}
