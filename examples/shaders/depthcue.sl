// depthcue.sl: the depth cue of the RenderMan Interface.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// For Atmosphere: light fades to the background between two depths, which are 0 at the near clipping plane and 1 at the
// far one.

volume depthcue(float mindistance = 0, maxdistance = 1; color background = 0) {
  float d = clamp((depth(P) - mindistance) / (maxdistance - mindistance), 0, 1);
  Ci = mix(Ci, background, d);
  Oi = mix(Oi, color 1, d);
}
