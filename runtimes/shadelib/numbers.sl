// Functions of numbers, and the same component by component.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

float radians(float x) { return x * 0.017453292519943295; }

float degrees(float x) { return x * 57.29577951308232; }

float sign(float x) { return x < 0 ? -1 : (x > 0 ? 1 : 0); }

// Not floor(x + 0.5): the sum of 0.49999997 and 0.5 rounds to 1.
float round(float x) {
  float below = floor(x);
  return x - below >= 0.5 ? below + 1 : below;
}

float log(float x, base) { return log(x) / log(base); }

float step(float low, x) { return x < low ? 0 : 1; }

// Where the edges coincide or are reversed, only the step at `low` is left. Halving first keeps the difference of
// huge edges finite; `max(0, t)` takes 0 for the NaN that infinite edges give.
float smoothstep(float low, high, x) {
  float t = (0.5 * x - 0.5 * low) / (0.5 * high - 0.5 * low);
  t = min(1, max(0, t));
  return x < low ? 0 : (x >= high ? 1 : t * t * (3 - 2 * t));
}

// The share of [s0, s1] above the edge. For s0 = s1 this is step(edge, s0).
float filterstep(float edge, s0, s1) {
  float low = min(s0, s1), high = max(s0, s1);
  return edge <= low ? 1 : (edge > high ? 0 : (high - edge) / (high - low));
}

// The low limit counts first, as the RenderMan Interface says. Where it is above the high one, min(max(x, low), high)
// would give the high one for all x: a loop that steps by clamp(step, smallest, end - t) would then stand still at its end.
float clamp(float x, low, high) { return x < low ? low : min(x, high); }
color clamp(color x, low, high) {
  return color(clamp(x[0], low[0], high[0]), clamp(x[1], low[1], high[1]), clamp(x[2], low[2], high[2]));
}
vector clamp(vector x, low, high) {
  return vector(clamp(x[0], low[0], high[0]), clamp(x[1], low[1], high[1]), clamp(x[2], low[2], high[2]));
}

float mix(float a, b, x) { return (1 - x) * a + x * b; }
color mix(color a, b; float x) { return (1 - x) * a + x * b; }
vector mix(vector a, b; float x) { return (1 - x) * a + x * b; }
