// bumpy.sl: bumps from a picture.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard displacement "bumpy": each point moves along its normal, as far as the picture is
// bright there, times Km.

displacement bumpy(float Km = 1; string texturename = "") {
  if (texturename != "") {
    P += Km * float texture(texturename) * normalize(N);
    N = calculatenormal(P);
  }
}
