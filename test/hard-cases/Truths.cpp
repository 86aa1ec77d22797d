//===-- test/hard-cases/Truths.cpp - closed forms in long double ------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Judges.h"
#include <algorithm>

using namespace hardcases;

namespace {

constexpr long double pi = 3.14159265358979323846264338327950288L;
using L = long double;

/// Compares all results by `distance(result, right)`. NaN and infinity are right where the truth
/// is.
template <typename Distance>
Judge compare(Truth truth, int outputs, Distance distance) {
  return [=](const Example &e) {
    L in[32], right[32], worst = 0;
    std::copy_n(e.in, 32, in);
    truth(in, right);
    for (int i = 0; i < outputs; ++i) {
      L out = e.out[i];
      if ((std::isnan(right[i]) && std::isnan(out)) || right[i] == out)
        continue;
      L error = distance(out, right[i], e.format);
      worst = std::isnan(error) ? infinite : std::max(worst, error);
    }
    return worst;
  };
}

} // namespace

Judge hardcases::inUlps(Truth truth, int outputs) {
  return compare(truth, outputs, [](L out, L right, const Format &f) {
    return std::fabs(out - right) / f.ulp(right);
  });
}
Judge hardcases::byDifference(Truth truth, int outputs) {
  return compare(truth, outputs,
                 [](L out, L right, const Format &) { return std::fabs(out - right); });
}
Judge hardcases::byRatio(Truth truth, int outputs) {
  return compare(truth, outputs, [](L out, L right, const Format &f) {
    return std::fabs(out - right) / std::max(std::fabs(right), L(f.smallestNormal()));
  });
}
Judge hardcases::ifTrue(bool (*holds)(const Example &)) {
  return [holds](const Example &e) { return holds(e) ? 0.0L : L(infinite); };
}

void hardcases::trueLength(const L *in, L *out) {
  out[0] = out[1] = std::sqrt(in[0] * in[0] + in[1] * in[1] + in[2] * in[2]);
}

void hardcases::trueAcosAsin(const L *in, L *out) {
  L x = std::clamp(in[0], -1.0L, 1.0L);
  out[0] = std::acos(x);
  out[1] = std::asin(x);
}

void hardcases::trueAngle(const L *in, L *out) {
  // Half the angle from the sides of the triangle (Kahan), another formula than the shader's.
  L difference = 0, sum = 0;
  for (int k = 0; k < 3; ++k) {
    difference += (in[k] - in[k + 3]) * (in[k] - in[k + 3]);
    sum += (in[k] + in[k + 3]) * (in[k] + in[k + 3]);
  }
  out[0] = 2 * std::atan2(std::sqrt(difference), std::sqrt(sum));
}

void hardcases::trueAtan2(const L *in, L *out) { out[0] = std::atan2(in[0], in[1]); }

void hardcases::trueSmoothstep(const L *in, L *out) {
  L low = in[0], high = in[1], x = in[2], t = (x - low) / (high - low);
  out[0] = x < low ? 0 : x >= high ? 1 : t * t * (3 - 2 * t);
}

void hardcases::trueSpline(const L *in, L *out) {
  // Catmull and Rom's curve through b, c, d of five knots; straight lines between four.
  const L *knot = in + 1;
  L x = std::clamp(in[0], 0.0L, 1.0L);
  int segment = std::min(int(x * 2), 1);
  L t = x * 2 - segment;
  const L *k = knot + segment;
  out[0] = 0.5L * (2 * k[1] + t * (k[2] - k[0]) + t * t * (2 * k[0] - 5 * k[1] + 4 * k[2] - k[3]) +
                   t * t * t * (3 * k[1] - k[0] - 3 * k[2] + k[3]));
  // Of four knots the middle two count.
  out[1] = knot[1] + x * (knot[2] - knot[1]);
}

void hardcases::trueUnity(const L *in, L *out) { std::fill_n(out, 4, in[1]); }

void hardcases::trueMicrofacet(const L *in, L *out) {
  // GGX of the angle itself: alpha² / (pi cos⁴ (alpha² + tan²)²).
  L c2 = in[2] * in[2], tan2 = (in[0] * in[0] + in[1] * in[1]) / c2, a2 = in[3] * in[3];
  out[0] = a2 / (pi * c2 * c2 * (a2 + tan2) * (a2 + tan2));
}

void hardcases::trueRoots(const L *in, L *out) {
  out[0] = in[0] < 0 ? 0 : std::sqrt(in[0]);
  out[1] = in[0] <= 0 ? 0 : 1 / std::sqrt(in[0]);
}

void hardcases::trueLog(const L *in, L *out) { out[0] = in[0] <= 0 ? 0 : std::log(in[0]); }

void hardcases::trueTone(const L *in, L *out) {
  // A negative number has no power of 1/2.2; the largest number bounds what would be infinite.
  out[0] = in[0] <= 0 ? 0 : std::pow(in[0], 1 / 2.2L);
  out[1] = 1 - std::exp(-std::max(in[0], 0.0L));
}

void hardcases::trueFilterstep(const L *in, L *out) {
  L edge = in[0], low = std::min(in[1], in[2]), high = std::max(in[1], in[2]);
  out[0] = edge <= low ? 1 : edge > high ? 0 : (high - edge) / (high - low);
  out[1] = in[1] < edge ? 0 : 1;
}

void hardcases::trueMerge(const L *in, L *out) { out[0] = in[0] > 0 ? 1 + in[1] : 2 + in[2]; }

void hardcases::trueGather(const L *in, L *out) {
  L i = std::isnan(in[0]) ? 0 : std::floor(in[0]);
  out[0] = std::ldexp(1.0L, int(std::clamp(i, 0.0L, 4.0L))) + 32;
  out[1] = std::ldexp(1.0L, int(std::clamp(i, 0.0L, 2.0L)));
}

void hardcases::trueArea(const L *in, L *out) {
  // Du = a, Dv = b, and the next point lies 1/16 away in u and v.
  const L *a = in, *b = in + 3;
  L n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  out[0] = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 256;
}

void hardcases::trueEdgeSlopes(const L *in, L *out) {
  L x = in[0];
  out[0] = x <= 0 ? 0 : 0.5L / std::sqrt(x);
  out[1] = x <= 0 ? 0 : -0.5L / (x * std::sqrt(x));
  out[2] = x <= 0 ? 0 : 1 / x;
  out[3] = std::fabs(x) >= 1 ? 0 : -1 / std::sqrt((1 - x) * (1 + x));
}

void hardcases::truePowerSlopes(const L *in, L *out) {
  L x = in[0], y = in[1];
  bool isDefined = x > 0 || (x < 0 && y == std::floor(y));
  out[0] = x == 0 ? (y == 1 ? 1 : 0) : isDefined ? y * std::pow(x, y - 1) : 0;
  out[1] = x <= 0 ? 0 : std::pow(x, y) * std::log(x);
}

void hardcases::trueLengthSlopes(const L *in, L *out) {
  L length = std::sqrt(in[0] * in[0] + in[1] * in[1] + in[2] * in[2]);
  L n[3] = {};
  for (int k = 0; k < 3; ++k)
    n[k] = length > 0 ? in[k] / length : 0;
  out[0] = n[0];
  for (int k = 0; k < 3; ++k)
    out[k + 1] = length > 0 ? ((k == 0) - n[0] * n[k]) / length : 0;
}

void hardcases::trueAtan2Slopes(const L *in, L *out) {
  L y = in[0], x = in[1], square = x * x + y * y;
  out[0] = square > 0 ? x / square : 0;
  out[1] = square > 0 ? -y / square : 0;
}

void hardcases::trueKinks(const L *in, L *out) {
  // docs/derivatives.md: abs and mod from above, min and max of equal operands as of the first.
  L x = in[0], y = in[1];
  out[0] = x < 0 ? -1 : 1;
  out[1] = x <= y;
  out[2] = x >= y;
  // Below 0 the constant; else the smaller of x and y.
  out[3] = x < 0 ? 0 : x <= y;
  out[4] = out[5] = 0;
  out[6] = y == 0 ? 0 : 1;
}
