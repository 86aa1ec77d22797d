// background.sl: one colour behind the picture.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// For Imager: shows through as far as the picture is transparent.

imager background(color bgcolor = 1; color background = 1) {
  Ci += (1 - Oi) * bgcolor * background;
  Oi = 1;
  alpha = 1;
}
