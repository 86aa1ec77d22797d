// distantlight.sl: parallel light, as from the sun.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard light "distantlight".

light distantlight(float intensity = 1; color lightcolor = 1;
                   point from = point "shader" (0, 0, 0), to = point "shader" (0, 0, 1);
                   float __nondiffuse = 0, __nonspecular = 0; string __category = "") {
  solar ((to - from) / length(to - from), 0)
    Cl = intensity * lightcolor;
}
