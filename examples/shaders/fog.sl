// fog.sl: the fog of the RenderMan Interface.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// For Atmosphere: light fades to the fog's colour with the distance it goes.

volume fog(float distance = 1; color background = 0) {
  float d = 1 - exp(-length(I) / distance);
  Ci = mix(Ci, background, d);
  Oi = mix(Oi, color 1, d);
}
