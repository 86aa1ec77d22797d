// ambientlight.sl: light from everywhere.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard light "ambientlight". It never says where its light goes, which is what
// makes a light one that only ambient() sees.

light ambientlight(float intensity = 1; color lightcolor = 1) {
  Cl = intensity * lightcolor;
}
