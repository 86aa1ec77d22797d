// shinymetal.sl: a metal that mirrors its surroundings.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard surface "shinymetal": a metal whose mirror image comes from the environment map
// `texturename`, or from rays where none is named.

surface shinymetal(float Ka = 1, Ks = 1, Kr = 1, roughness = 0.1; string texturename = "") {
  normal Nf = faceforward(normalize(N), I);
  vector V = -normalize(I);
  vector mirrored = reflect(-V, Nf);
  color surroundings;
  if (texturename != "")
    surroundings = color environment(texturename, vtransform("world", mirrored));
  else
    surroundings = trace(P, mirrored);
  Oi = Os;
  Ci = Os * Cs * (Ka * ambient() + Ks * specular(Nf, V, roughness) + Kr * surroundings);
}
