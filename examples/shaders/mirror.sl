// mirror.sl: a perfect mirror.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The light that arrives from the mirrored direction, and nothing else.

surface mirror() {
  vector dir = reflect(I, N);
  Ci = trace(P, dir);
  Oi = 1;
}
