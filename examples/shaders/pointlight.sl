// pointlight.sl: a small light that shines in all directions.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard light "pointlight": it fades with the square of the distance.

light pointlight(float intensity = 1; color lightcolor = 1; point from = point "shader" (0, 0, 0);
                 float __nondiffuse = 0, __nonspecular = 0; string __category = "") {
  illuminate (from)
    Cl = intensity * lightcolor * (1 / (L . L));
}
