//===-- test/hard-cases/Judges.cpp - what holds of results ------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Judges.h"
#include <algorithm>
#include <cstdint>

using namespace hardcases;

namespace {

using L = long double;

L dot(const double *a, const double *b) { return L(a[0]) * b[0] + L(a[1]) * b[1] + L(a[2]) * b[2]; }
L lengthOf(const double *a) { return std::sqrt(dot(a, a)); }
bool within(double x, double low, double high) { return x >= low && x <= high; }
L wrongUnless(bool holds) { return holds ? 0 : L(infinite); }
L orInfinite(L error) { return std::isnan(error) ? L(infinite) : error; }

} // namespace

//===-- Directions ----------------------------------------------------------------------------===//

L hardcases::judgeNormalize(const Example &e) {
  bool isNaN = false, isInfinite = false;
  for (int k = 0; k < 3; ++k) {
    isNaN |= std::isnan(e.in[k]);
    isInfinite |= std::isinf(e.in[k]);
  }
  if (isNaN)
    return wrongUnless(std::isnan(e.out[0]) || std::isnan(e.out[1]) || std::isnan(e.out[2]));
  L length = lengthOf(e.in), error = 0;
  for (int k = 0; k < 3; ++k) {
    L right = isInfinite    ? (std::isinf(e.in[k]) ? (e.in[k] > 0 ? 1 : -1) : 0)
              : length == 0 ? 0
                            : e.in[k] / length;
    error = std::max(error, orInfinite(std::fabs(e.out[k] - right)));
  }
  return error;
}

bool hardcases::unitDotHolds(const Example &e) {
  // The angle that one unit in the last place of a cosine of 1 stands for.
  double least = 4 * std::sqrt(e.format.eps());
  return within(e.out[0], 0, least) && within(e.out[1], 0, least) && within(e.out[2], 0.99, 1);
}

bool hardcases::faceforwardHolds(const Example &e) {
  const double *n = e.in, *i = e.in + 3, *reference = e.in + 6;
  L side = dot(i, reference);
  for (int k = 0; k < 3; ++k)
    if (e.out[k] != (side > 0 ? -n[k] : n[k]))
      return false;
  return true;
}

L hardcases::judgeReflect(const Example &e) {
  const double *I = e.in, *N = e.in + 3;
  L length = lengthOf(N), along = dot(I, N) / length, error = 0;
  for (int k = 0; k < 3; ++k) {
    L right = I[k] - 2 * along * (N[k] / length);
    error = std::max(error, orInfinite(std::fabs(e.out[k] - right)));
  }
  return error / (4 * std::fabs(length - 1) + 2 * (length - 1) * (length - 1) +
                  4e-7L * std::ldexp(1.0L, 24 - e.format.digits()));
}

L hardcases::judgeReflectLength(const Example &e) {
  L before = lengthOf(e.in), after = lengthOf(e.out);
  return orInfinite(std::fabs(after - before) / (2 * e.format.eps() * before));
}

namespace {

/// Fresnel's equations for c = |I.N| and the given eta; infinite Kr where all light is reflected.
L trueShare(const Example &e, bool &isTotal) {
  L c = std::fabs(dot(e.in, e.in + 3)), n = e.in[6];
  L k = (1 - n) * (1 + n) + n * c * (n * c);
  isTotal = k < 0;
  if (isTotal)
    return 1;
  L inside = std::sqrt(k), s = (n * c - inside) / (n * c + inside),
    p = (c - n * inside) / (c + n * inside);
  return (s * s + p * p) / 2;
}

bool isZero(const double *v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

} // namespace

L hardcases::judgeFresnel(const Example &e) {
  bool isTotal;
  L share = trueShare(e, isTotal), kr = e.out[0], kt = e.out[1];
  if (isZero(e.out + 5) != isTotal || !within(e.out[0], 0, 1) ||
      std::fabs(kr + kt - 1) > 2 * e.format.eps())
    return infinite;
  return std::fabs(kr - share);
}

bool hardcases::extremeFresnelHolds(const Example &e) {
  double eta = std::fabs(e.in[6]), c = std::fabs(double(dot(e.in, e.in + 3))), kr = e.out[0];
  if (!within(kr, 0, 1) || std::fabs(kr + e.out[1] - 1) > 2 * e.format.eps())
    return false;
  if (eta == 1)
    return kr < 1e-5;
  if (eta < 1e-20 || eta > 1e20 || c == 0)
    return kr > 1 - 1e-5;
  return true;
}

L hardcases::judgeRefract(const Example &e) {
  const double *I = e.in, *N = e.in + 3, *T = e.out;
  bool isTotal;
  trueShare(e, isTotal);
  if (isTotal)
    return wrongUnless(isZero(T));
  L eta = e.in[6], error = 0;
  if (eta == 1)
    for (int k = 0; k < 3; ++k)
      error = std::max(error, std::fabs(L(T[k]) - I[k]));
  // Snell's law: what lies across N is eta times as much behind.
  for (int k = 0; k < 3; ++k) {
    L across = T[k] - dot(T, N) * N[k], before = I[k] - dot(I, N) * N[k];
    error = std::max(error, orInfinite(std::fabs(across - eta * before)));
  }
  return error;
}

L hardcases::judgeBasis(const Example &e) {
  const double *z = e.in, *x = e.out, *y = e.out + 3;
  return orInfinite(std::max({std::fabs(dot(x, y)), std::fabs(dot(x, z)), std::fabs(dot(y, z)),
                              std::fabs(lengthOf(x) - 1), std::fabs(lengthOf(y) - 1)}));
}

//===-- Numbers -------------------------------------------------------------------------------===//

L hardcases::judgeMod(const Example &e) {
  double a = e.in[0], b = e.in[1], r = e.out[0];
  if (b == 0)
    return wrongUnless(r == 0);
  if (b > 0 ? !(r >= 0 && r < b) : !(r <= 0 && r > b))
    return infinite;
  // Where the quotient has more digits than the format, only the range is promised.
  if (std::fabs(a / b) >= std::ldexp(1.0, e.format.digits()) ||
      std::fabs(b) < e.format.smallestNormal())
    return 0;
  L right = std::fmod(L(a), L(b)), difference = std::fabs(r - (right * b < 0 ? right + b : right));
  return std::min(difference, std::fabs(std::fabs(L(b)) - difference)) / e.format.ulp(b);
}

L hardcases::judgePow(const Example &e) {
  double x = e.in[0], y = e.in[1], r = e.out[0];
  if (y == 0)
    return wrongUnless(r == 1);
  if (y == 1)
    return wrongUnless(r == x);
  if (y == 2)
    return wrongUnless(r == (e.format.isDouble ? x * x : double(float(x) * float(x))));
  if ((x < 0 && y != std::floor(y)) || (x == 0 && y < 0))
    return wrongUnless(r == 0);
  L right = std::pow(L(x), L(y)), largest = e.format.largest();
  right = std::clamp(right, -largest, largest);
  return orInfinite(std::fabs(r - right) /
                    std::max(std::fabs(right), L(e.format.smallestNormal())));
}

bool hardcases::atan2SignsHold(const Example &e) {
  double right = std::atan2(e.in[0], e.in[1]);
  return std::fabs(e.out[0] - right) < 1e-3 && std::signbit(e.out[0]) == std::signbit(right);
}

bool hardcases::divideHolds(const Example &e) {
  double a = e.in[0], b = e.in[1], r = e.out[0];
  if (std::fabs(b) < e.format.smallestNormal())
    return r == 0;
  return r == (e.format.isDouble ? a / b : double(float(a) / float(b)));
}

bool hardcases::idleDivisionHolds(const Example &e) {
  double a = e.in[0], b = e.in[1];
  double quotient = b == 0 ? 0 : std::floor(a / b);
  return e.out[0] == quotient && e.out[2] == 10 * (1 + std::clamp(quotient, 0.0, 3.0)) &&
         e.out[1] == (b == 0 ? 0 : a - b * quotient);
}

bool hardcases::loopHolds(const Example &e) {
  double t = e.in[0], to = e.in[1], step = e.in[2], rounds = 0;
  auto add = [&](double a, double b) {
    return e.format.isDouble ? a + b : double(float(a) + float(b));
  };
  for (; t < to && rounds < 100; ++rounds)
    t = add(t, step);
  return e.out[0] == rounds && (e.out[1] == t || (std::isnan(t) && std::isnan(e.out[1])));
}

bool hardcases::denormalsHold(const Example &e) {
  double x = e.in[0];
  return e.out[0] == e.format.round(0.5 * x) && e.out[1] == x + x && e.out[2] == (x == 0) &&
         std::fabs(e.out[3] - std::sqrt(x)) <= 4 * e.format.eps() * std::sqrt(x);
}

bool hardcases::guardsHold(const Example &e) {
  double x = e.in[0];
  auto sum = [&](double a, double b) {
    return e.format.isDouble ? a + b : double(float(a) + float(b));
  };
  double difference = sum(sum(x, 1), -x);
  return e.out[0] == std::isnan(x) && e.out[1] == std::isinf(x) &&
         (e.out[2] == difference || (std::isnan(difference) && std::isnan(e.out[2])));
}

//===-- Noise ---------------------------------------------------------------------------------===//

namespace {

uint32_t mixed(uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ x >> 16;
}

constexpr uint32_t golden = 0x9e3779b9u, axisKeys[3] = {0x8da6b343u, 0xd8163841u, 0xcb1ab31fu};

L fade(L t) { return t * t * t * (t * (t * 6 - 15) + 10); }

uint32_t latticeKey(L floored, int axis) { return uint32_t(int64_t(floored)) * axisKeys[axis]; }

/// Gradient noise as runtimes/real/operators/noise.cpp describes it, all in long double.
L trueNoise1(L x) {
  L low = std::floor(x), t = x - low;
  auto corner = [](uint32_t key, L offset) {
    uint32_t h = mixed(golden + key) * golden;
    return offset * L(int32_t(h) >> 8) * 0x1p-23L * 2;
  };
  L a = corner(latticeKey(low, 0), t), b = corner(latticeKey(low, 0) + axisKeys[0], t - 1);
  return (a + fade(t) * (b - a)) * 0.499999L + 0.5L;
}

L trueNoise3(const double *p) {
  L low[3], t[3], sum = 0;
  for (int k = 0; k < 3; ++k)
    low[k] = std::floor(L(p[k])), t[k] = p[k] - low[k];
  for (int corner = 0; corner < 8; ++corner) {
    uint32_t key = golden;
    L weight = 1, offset[3];
    for (int k = 0; k < 3; ++k) {
      int far = corner >> k & 1;
      key += latticeKey(low[k], k) + (far ? axisKeys[k] : 0);
      offset[k] = t[k] - far;
      weight *= far ? fade(t[k]) : 1 - fade(t[k]);
    }
    uint32_t h = mixed(key), edge = h & 15;
    L u = edge < 8 ? offset[0] : offset[1];
    L v = edge < 4 ? offset[1] : (edge & 13) == 12 ? offset[0] : offset[2];
    sum += weight * ((h & 1 ? -u : u) + (h & 2 ? -v : v));
  }
  return sum * 0.482460L + 0.5L;
}

} // namespace

L hardcases::judgeNoise(const Example &e) {
  bool isHuge = false;
  for (int k = 0; k < 3; ++k)
    isHuge |= std::fabs(e.in[k]) > 1e9;
  if (!within(e.out[0], 0, 1) || !within(e.out[1], 0, 1))
    return infinite;
  if (isHuge)
    return 0;
  return std::max(std::fabs(e.out[0] - trueNoise1(e.in[0])),
                  std::fabs(e.out[1] - trueNoise3(e.in)));
}

bool hardcases::noiseCellHolds(const Example &e) {
  bool isFine = within(e.out[1], 0, 1) && e.out[1] < 1;
  return isFine && (std::isnan(e.in[0]) ? std::isnan(e.out[0]) : within(e.out[0], 0, 1));
}

bool hardcases::cellnoiseHolds(const Example &e) {
  return e.out[0] == e.out[1] && e.out[0] != e.out[2] && e.out[0] != e.out[3];
}

bool hardcases::pnoiseHolds(const Example &e) {
  return within(e.out[0], 0, 1) && e.out[0] == e.out[1];
}

//===-- Light and colour ----------------------------------------------------------------------===//

bool hardcases::specularHolds(const Example &e) {
  return within(e.out[0], 0, 1) && within(e.out[1], 0, 1);
}

template <bool hasHue>
L hardcases::judgeColor(const Example &e) {
  L error = 0;
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(e.out[k]))
      return infinite;
    error = std::max(error, orInfinite(std::fabs(L(e.out[k + 3]) - e.in[k])));
  }
  bool isGrey = e.in[0] == e.in[1] && e.in[1] == e.in[2];
  if (hasHue && isGrey && (e.out[0] != 0 || e.out[1] != 0))
    return infinite;
  return error;
}
template L hardcases::judgeColor<true>(const Example &);
template L hardcases::judgeColor<false>(const Example &);

//===-- Derivatives ---------------------------------------------------------------------------===//

L hardcases::judgeNormalField(const Example &e) {
  L area, in[6];
  std::copy_n(e.in, 6, in);
  trueArea(in, &area);
  if (!std::isfinite(e.out[0]) ||
      std::fabs(e.out[0] - area) > 1e-5L * area + e.format.smallestNormal())
    return infinite;
  const double *a = e.in, *b = e.in + 3, *n = e.in + 6, *ng = e.in + 9, *m = e.out + 1;
  L cross[3] = {L(a[1]) * b[2] - L(a[2]) * b[1], L(a[2]) * b[0] - L(a[0]) * b[2],
                L(a[0]) * b[1] - L(a[1]) * b[0]};
  L size = std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  L sine = size > 0 ? size / (lengthOf(a) * lengthOf(b)) : 0;
  // Without a plane, the direction of N, else that of Ng; the truth's plane has to be clearly
  // there.
  const double *fallback = isZero(n) ? ng : n;
  L error = 0, fallbackLength = lengthOf(fallback);
  for (int k = 0; k < 3; ++k) {
    L right = sine > 1e-4 ? cross[k] / size : fallbackLength > 0 ? fallback[k] / fallbackLength : 0;
    error = std::max(error, orInfinite(std::fabs(m[k] - right)));
  }
  return error * std::min(1.0L, sine > 1e-4 ? sine : 1.0L);
}

bool hardcases::filterWidthHolds(const Example &e) {
  double slope = std::fabs(e.in[2]), width = slope * 0.0625, distance = e.in[1] - e.in[0];
  if (!within(e.out[0], 0, 1))
    return false;
  if (width == 0 || 2 * std::fabs(distance) >= width)
    return e.out[0] == e.out[1];
  return std::fabs(e.out[0] - (distance / width + 0.5)) < 1e-4;
}
