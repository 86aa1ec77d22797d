// matte.sl: an ideal diffuse surface.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard surface "matte": Ka weighs the ambient light, Kd the diffuse reflection.

surface matte(float Ka = 1, Kd = 1) {
  normal Nf = faceforward(normalize(N), I);
  Oi = Os;
  Ci = Os * Cs * (Ka * ambient() + Kd * diffuse(Nf));
}
