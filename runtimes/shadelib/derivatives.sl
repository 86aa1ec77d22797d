// What follows from how a value changes with u and v. du and dv say how far the next point lies.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

float Deriv(float a, x) { return Du(a) / Du(x) + Dv(a) / Dv(x); }
color Deriv(color a; float x) { return Du(a) / color(Du(x)) + Dv(a) / color(Dv(x)); }
vector Deriv(vector a; float x) { return Du(a) / vector(Du(x)) + Dv(a) / vector(Dv(x)); }

float area(point p) { return length((Du(p) * du) ^ (Dv(p) * dv)); }

// The directions are of unit length before they are multiplied, so their size does not matter, and the square of the
// product is that of the angle's sine; below 1e-6 its direction is rounding. The surface's own derivatives say on which
// side of it normals are.
normal calculatenormal(point p) {
  vector across = normalize(Du(p)) ^ normalize(Dv(p));
  vector n = normalize((dPdu ^ dPdv) . Ng < 0 ? -across : across);
  if (across . across < 1e-12)
    n = normalize(N . N > 0 ? N : Ng);
  return n;
}

// How wide a filter is hardly changes from point to point, and what is filtered should not need second derivatives.
float filterwidth(float x) { return __detach(abs(Du(x) * du) + abs(Dv(x) * dv)); }
float filterwidth(point p) { return __detach(sqrt(area(p))); }

// The distance from the edge, in widths; beyond half a width, and so without any width, it is a step.
float filterstep(float edge, x) {
  float width = filterwidth(x), distance = x - edge;
  return 2 * abs(distance) < width ? distance / width + 0.5 : step(edge, x);
}

// The integral of exp(-2 t^2) up to t, over that from -1 to 1. The error function is that of Hastings' rational
// approximation (Abramowitz and Stegun, 7.1.26), within 1.5e-7.
float gaussianStep(float t) {
  float x = 1.4142135623730951 * abs(t), k = 1 / (1 + 0.3275911 * x);
  float tail = k * (0.254829592 + k * (-0.284496736 + k * (1.421413741 + k * (-1.453152027 + k * 1.061405429)))) * exp(-x * x);
  float half = (1 - tail) * 0.5238346131357222;
  return t < 0 ? 0.5 - half : 0.5 + half;
}

// The integral of Catmull and Rom's kernel up to t >= 0.
float catmullRomStep(float t) {
  float t2 = t * t;
  return t < 1 ? 0.5 + t - 0.8333333333333334 * t2 * t + 0.375 * t2 * t2
               : 0.3333333333333333 + 2 * t - 2 * t2 + 0.8333333333333334 * t2 * t - 0.125 * t2 * t2;
}

// The filters by number: 0 box, 1 triangle, 2 gaussian, 3 catmull-rom. They are as wide as samplers of the interface have them: one width to each side for the triangle and the Gaussian
// bell, two for Catmull and Rom's.
float filtered(float edge, x, width, filter) {
  float t = (x - edge) / width, reach = 0.5, share = t + 0.5;
  if (filter == 1) {
    reach = 1;
    share = t < 0 ? 0.5 * (1 + t) * (1 + t) : 1 - 0.5 * (1 - t) * (1 - t);
  } else if (filter == 2) {
    reach = 1;
    share = gaussianStep(t);
  } else if (filter == 3) {
    reach = 2;
    share = t < 0 ? 1 - catmullRomStep(-t) : catmullRomStep(t);
  }
  return abs(x - edge) < reach * width ? share : step(edge, x);
}

float __filterstep(float edge, x, factor, filter) {
  return filtered(edge, x, factor * filterwidth(x), filter);
}
float __filterstep(float edge, s0, s1, factor, filter) {
  return filtered(edge, 0.5 * (s0 + s1), factor * abs(s1 - s0), filter);
}
