// reflectonly.sl: shows the mirrored direction as a colour.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// One operator and no renderer service: the smallest shader that computes something.

surface reflectonly() {
  vector dir = reflect(normalize(I), faceforward(normalize(N), I));
  Ci = color(0.5 + 0.5 * xcomp(dir), 0.5 + 0.5 * ycomp(dir), 0.5 + 0.5 * zcomp(dir));
  Oi = 1;
}
