// picture.sl: a picture from a file, repeated.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// texture() filters over the footprint that the derivatives of its coordinates span. With a width of 0 it looks at points.

surface picture(string map = ""; float frequency = 1;) {
  Oi = Os;
#ifdef ALIASED
  Ci = Oi * color texture(map, s * frequency, t * frequency, "width", 0, "blur", 0);
#else
  Ci = Oi * color texture(map, s * frequency, t * frequency);
#endif
}
