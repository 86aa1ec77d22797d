// paintedplastic.sl: plastic with stripes painted on it.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard surface "paintedplastic" takes its paint from a texture; here it is computed:
// `stripes` bands across s, with edges softened over a tenth of their width.

surface paintedplastic(float Ka = 1, Kd = 0.5, Ks = 0.5, roughness = 0.1; color specularcolor = 1;
                       color paint = color(0.7, 0.1, 0.1); float stripes = 8) {
  normal Nf = faceforward(normalize(N), I);
  vector V = -normalize(I);
  float phase = mod(s * stripes, 1);
  float edge = 0.1;
  float painted = smoothstep(0, edge, phase) - smoothstep(0.5, 0.5 + edge, phase);
  color body = Cs * mix(color(1), paint, painted);
  Oi = Os;
  Ci = Os * (body * (Ka * ambient() + Kd * diffuse(Nf)) +
             specularcolor * Ks * specular(Nf, V, roughness));
}
