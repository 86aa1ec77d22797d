// What the renderer says about itself, and what follows from it.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

float raylevel() {
  float level = 0;
  rayinfo("depth", level);
  return level;
}

// Without clipping planes this is the distance from the eye's plane.
float depth(point p) {
  float planes[2] = {0, 1};
  option("Clipping", planes);
  return (zcomp(transform("camera", p)) - planes[0]) / (planes[1] - planes[0]);
}

matrix mtransform(matrix space, m) { return m * space; }
