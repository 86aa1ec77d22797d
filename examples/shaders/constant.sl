// constant.sl: the surface's own colour, whatever the light.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard surface "constant".

surface constant() {
  Oi = Os;
  Ci = Os * Cs;
}
