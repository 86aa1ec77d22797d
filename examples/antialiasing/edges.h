// edges.h: square waves, filtered over the width of a pixel.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// A wave of period 1 is 1 for the first `duty` of each period and 0 for the rest. Its average over [x - w/2, x + w/2] is the
// difference of its integral at the two ends, divided by w: a box filter in closed form, at any width (the pulse train of
// Apodaca and Gritz, Advanced RenderMan, 2000, chapter 11).

#ifndef EDGES_H
#define EDGES_H

float integral(float x, duty) {
  float whole = floor(x);
  return whole * duty + min(x - whole, duty);
}

float wave(float x, duty) {
#ifdef ALIASED
  return 1 - step(duty, x - floor(x));
#else
  float w = max(filterwidth(x), 1e-6);
  return (integral(x + w / 2, duty) - integral(x - w / 2, duty)) / w;
#endif
}

// How much of a detail of size 1 survives under a filter as wide as x changes: all of it up to half its size, none beyond.
float detail(float x) {
#ifdef ALIASED
  return 1;
#else
  return 1 - smoothstep(0.5, 1, filterwidth(x));
#endif
}

#endif
