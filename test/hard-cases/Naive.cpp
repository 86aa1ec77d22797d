//===-- test/hard-cases/Naive.cpp - the obvious code for each row -----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Naive.h"
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace {

struct V {
  float x, y, z;
};
V at(const float *p) { return {p[0], p[1], p[2]}; }
void put(float *out, V v) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }
V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
V operator*(float s, V a) { return {s * a.x, s * a.y, s * a.z}; }
float dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
float length(V a) { return std::sqrt(dot(a, a)); }
V normalize(V a) { return (1 / length(a)) * a; }
float sign(float x) { return float((x > 0) - (x < 0)); }
float square(float x) { return x * x; }

// A number that no lane of integers holds becomes what x86 makes of it.
int truncated(float x) { return x >= -2147483648.0f && x < 2147483648.0f ? int(x) : INT32_MIN; }

uint32_t mixed(uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}
float cell(float x) {
  return float(mixed(0x9e3779b9u + uint32_t(truncated(x)) * 0x8da6b343u) >> 8) * 0x1p-24f;
}
float noise(float x) {
  int low = truncated(x);
  float t = x - float(low), s = t * t * t * (t * (t * 6 - 15) + 10);
  auto corner = [](int i, float offset) {
    return offset *
           float(int32_t(mixed(0x9e3779b9u + uint32_t(i) * 0x8da6b343u) * 0x9e3779b9u) >> 8) *
           0x1p-22f;
  };
  float a = corner(low, t), b = corner(int(uint32_t(low) + 1), t - 1);
  return (a + s * (b - a)) * 0.499999f + 0.5f;
}

} // namespace

namespace hardcases {

void naiveLength(const float *in, float *out) { out[0] = out[1] = length(at(in)); }
void naiveNormalize(const float *in, float *out) { put(out, normalize(at(in))); }
void naiveUnitDot(const float *in, float *out) {
  V n = normalize(at(in));
  float c = dot(n, n);
  out[0] = std::acos(c);
  out[1] = std::sqrt(1 - c * c);
  out[2] = std::pow(c, 1e6f);
}
void naiveFaceforward(const float *in, float *out) {
  put(out, sign(-dot(at(in + 3), at(in + 6))) * at(in));
}
void naiveReflect(const float *in, float *out) {
  V I = at(in), N = at(in + 3);
  put(out, I - 2 * dot(I, N) * N);
}
void naiveFresnel(const float *in, float *out) {
  V I = at(in), N = at(in + 3), zero = {0, 0, 0};
  float eta = in[6], c = dot(I, N), k = 1 - eta * eta * (1 - c * c);
  put(out + 2, I - 2 * c * N);
  if (k < 0) {
    out[0] = 1, out[1] = 0;
    put(out + 5, zero);
    return;
  }
  float inside = std::sqrt(k), outside = std::fabs(c);
  float s = (eta * outside - inside) / (eta * outside + inside);
  float p = (outside - eta * inside) / (outside + eta * inside);
  out[0] = 0.5f * (s * s + p * p);
  out[1] = 1 - out[0];
  put(out + 5, eta * I - (eta * c + inside) * N);
}
void naiveRefract(const float *in, float *out) {
  V I = at(in), N = at(in + 3);
  float eta = in[6], c = dot(I, N), k = 1 - eta * eta * (1 - c * c);
  V zero = {0, 0, 0};
  put(out, k < 0 ? zero : eta * I - (eta * c + std::sqrt(k)) * N);
}
void naiveSmoothstep(const float *in, float *out) {
  float t = (in[2] - in[0]) / (in[1] - in[0]);
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  out[0] = t * t * (3 - 2 * t);
}
void naiveMod(const float *in, float *out) { out[0] = in[0] - in[1] * std::floor(in[0] / in[1]); }
void naivePow(const float *in, float *out) { out[0] = std::exp(in[1] * std::log(in[0])); }
void naiveLog(const float *in, float *out) { out[0] = std::log(in[0]); }
void naiveAcos(const float *in, float *out) {
  out[0] = std::acos(in[0]), out[1] = std::asin(in[0]);
}
void naiveAngle(const float *in, float *out) { out[0] = std::acos(dot(at(in), at(in + 3))); }
void naiveAtan2(const float *in, float *out) {
  float y = in[0], x = in[1];
  out[0] = std::atan(y / x) + (x < 0 ? (y < 0 ? -3.14159265f : 3.14159265f) : 0);
}
void naiveSqrt(const float *in, float *out) {
  out[0] = std::sqrt(in[0]), out[1] = 1 / std::sqrt(in[0]);
}
void naiveSpline(const float *in, float *out) {
  float x = in[0] * 2;
  int segment = truncated(x);
  float t = x - float(segment), k[4];
  for (int i = 0; i < 4; ++i) // what lies past the end is anything
    k[i] = segment + i >= 0 && segment + i < 5 ? in[1 + segment + i] : NAN;
  out[0] = 0.5f * (2 * k[1] + t * (k[2] - k[0]) + t * t * (2 * k[0] - 5 * k[1] + 4 * k[2] - k[3]) +
                   t * t * t * (3 * k[1] - k[0] - 3 * k[2] + k[3]));
  out[1] = in[2] + in[0] * (in[3] - in[2]);
}
void naiveSplineUnity(const float *in, float *out) {
  // The bases' weights at the caller's own t, which is not held to its segment.
  float x = in[0] * 2, t = x - float(truncated(x)), k = in[1], r = 1 - t;
  out[0] = 0.5f * (2 * k + t * (k - k) + t * t * (2 * k - 5 * k + 4 * k - k) +
                   t * t * t * (3 * k - k - 3 * k + k));
  out[1] = r * r * r * k + 3 * r * r * t * k + 3 * r * t * t * k + t * t * t * k;
  out[2] = (r * r * r * k + (3 * t * t * t - 6 * t * t + 4) * k +
            (-3 * t * t * t + 3 * t * t + 3 * t + 1) * k + t * t * t * k) /
           6;
  out[3] = k + t * (k - k);
}
void naiveNoise(const float *in, float *out) { out[0] = out[1] = noise(in[0]); }
void naiveNoiseCell(const float *in, float *out) { out[0] = noise(in[0]), out[1] = cell(in[0]); }
void naiveCellnoise(const float *in, float *out) {
  float low = std::floor(in[0]);
  out[0] = cell(in[0]), out[1] = cell(low), out[2] = cell(low - 1), out[3] = cell(low + 1);
}
void naivePnoise(const float *in, float *out) {
  int period = truncated(in[1]), low = truncated(std::floor(in[0]));
  // Division by zero traps; here it is NaN that stands for it.
  out[0] = period == 0 ? NAN : noise(float(low % period) + in[0] - float(low));
  out[1] = noise(in[0] - std::floor(in[0]));
}
void naiveSpecular(const float *in, float *out) {
  V l = normalize(at(in)), v = normalize(at(in + 3)), n = {0, 0, 1}, up = {0, 0, 1};
  out[0] = std::pow(std::max(0.0f, dot(n, normalize(l + v))), 1 / in[6]);
  V mirrored = 2 * dot(v, up) * up - v;
  out[1] = std::pow(std::max(0.0f, dot(mirrored, l)), 1 / in[6]);
}
void naiveMicrofacet(const float *in, float *out) {
  float a2 = in[3] * in[3], c = in[2], k = c * c * (a2 - 1) + 1;
  out[0] = a2 / (3.14159265f * k * k);
}
void naiveDivideIdle(const float *in, float *out) {
  int a = truncated(in[0]), b = truncated(in[1]);
  bool isFine = b != 0 && !(a == INT32_MIN && b == -1);
  out[0] = isFine ? float(a / b) : NAN;
  out[1] = isFine ? float(a % b) : NAN;
  out[2] = isFine ? 10 * (1 + std::clamp(out[0], 0.0f, 3.0f)) : NAN;
}
void naiveMerge(const float *in, float *out) {
  float m = in[0] > 0;
  out[0] = m * (1 + in[1]) + (1 - m) * (2 + in[2]);
}
void naiveLoop(const float *in, float *out) {
  float t = in[0], rounds = 0;
  do {
    if (t >= in[1])
      break;
    t += in[2];
    rounds += 1;
  } while (rounds < 100);
  out[0] = rounds, out[1] = t;
}
void naiveDenormal(const float *in, float *out) {
  // With denormals flushed, as some start-up code asks for.
  float x = std::fabs(in[0]) < 0x1p-126f ? 0 : in[0], half = 0.5f * x;
  out[0] = half < 0x1p-126f ? 0 : half;
  out[1] = x + x, out[2] = x == 0, out[3] = std::sqrt(x);
}
void naiveGuards(const float *in, float *out) {
  // What -ffinite-math-only and -fassociative-math make of them.
  (void)in;
  out[0] = 0, out[1] = 0, out[2] = 1;
}
void naiveBasis(const float *in, float *out) {
  // Frisvad 2012, of which Duff et al. 2017 tell the failure.
  V n = at(in);
  float a = 1 / (1 + n.z), b = -n.x * n.y * a;
  put(out, {1 - n.x * n.x * a, b, -n.x});
  put(out + 3, {b, 1 - n.y * n.y * a, -n.y});
}
void naiveTone(const float *in, float *out) {
  out[0] = std::pow(in[0], 1 / 2.2f);
  out[1] = 1 - std::exp(-in[0]);
}

//===-- Colours -------------------------------------------------------------------------------===//

namespace {
float hue(V c, float largest, float range) {
  float h = largest == c.x   ? (c.y - c.z) / range
            : largest == c.y ? 2 + (c.z - c.x) / range
                             : 4 + (c.x - c.y) / range;
  return h / 6 - std::floor(h / 6);
}
V saturated(float h) {
  auto ramp = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
  h *= 6;
  return {ramp(std::fabs(h - 3) - 1), ramp(2 - std::fabs(h - 2)), ramp(2 - std::fabs(h - 4))};
}
void matrixThereAndBack(const float *in, float *out, const float (&m)[9], const float (&back)[9]) {
  for (int r = 0; r < 3; ++r)
    out[r] = m[3 * r] * in[0] + m[3 * r + 1] * in[1] + m[3 * r + 2] * in[2];
  for (int r = 0; r < 3; ++r)
    out[3 + r] = back[3 * r] * out[0] + back[3 * r + 1] * out[1] + back[3 * r + 2] * out[2];
}
// The digits that textbooks print.
constexpr float toXyz[9] = {0.4125f, 0.3576f, 0.1804f, 0.2127f, 0.7152f,
                            0.0722f, 0.0193f, 0.1192f, 0.9503f};
constexpr float fromXyz[9] = {3.2405f, -1.5371f, -0.4985f, -0.9693f, 1.8760f,
                              0.0416f, 0.0556f,  -0.2040f, 1.0572f};
} // namespace

void naiveHsv(const float *in, float *out) {
  V c = at(in);
  float largest = std::max({c.x, c.y, c.z}), range = largest - std::min({c.x, c.y, c.z});
  put(out, {hue(c, largest, range), range / largest, largest});
  V s = saturated(out[0]);
  for (int k = 0; k < 3; ++k)
    out[3 + k] = out[2] * (1 - out[1] + out[1] * (&s.x)[k]);
}
void naiveHsl(const float *in, float *out) {
  V c = at(in);
  float largest = std::max({c.x, c.y, c.z}), smallest = std::min({c.x, c.y, c.z});
  float range = largest - smallest, light = (largest + smallest) / 2;
  put(out, {hue(c, largest, range), range / (1 - std::fabs(2 * light - 1)), light});
  V s = saturated(out[0]);
  for (int k = 0; k < 3; ++k)
    out[3 + k] = light + out[1] * (1 - std::fabs(2 * light - 1)) * ((&s.x)[k] - 0.5f);
}
void naiveXyz(const float *in, float *out) { matrixThereAndBack(in, out, toXyz, fromXyz); }
void naiveYiq(const float *in, float *out) {
  matrixThereAndBack(in, out,
                     {0.299f, 0.587f, 0.114f, 0.596f, -0.274f, -0.322f, 0.211f, -0.523f, 0.312f},
                     {1, 0.956f, 0.621f, 1, -0.272f, -0.647f, 1, -1.107f, 1.704f});
}
void naiveXyY(const float *in, float *out) {
  float xyz[6];
  matrixThereAndBack(in, xyz, toXyz, fromXyz);
  float sum = xyz[0] + xyz[1] + xyz[2];
  put(out, {xyz[0] / sum, xyz[1] / sum, xyz[1]});
  float scale = out[2] / out[1], again[3] = {out[0] * scale, out[2], (1 - out[0] - out[1]) * scale};
  for (int r = 0; r < 3; ++r)
    out[3 + r] =
        fromXyz[3 * r] * again[0] + fromXyz[3 * r + 1] * again[1] + fromXyz[3 * r + 2] * again[2];
}
void naiveFilterstep(const float *in, float *out) {
  float low = std::min(in[1], in[2]), high = std::max(in[1], in[2]);
  out[0] = std::clamp((high - in[0]) / (high - low), 0.0f, 1.0f);
  out[1] = std::clamp((in[1] - in[0]) / (in[1] - in[1]), 0.0f, 1.0f);
}
void naiveDivide(const float *in, float *out) { out[0] = in[0] / in[1]; }
void naiveGamma(const float *in, float *out) {
  for (int i = 0; i < 2; ++i)
    out[i] = in[i] <= 0.0031308f ? 12.92f * in[i] : 1.055f * std::pow(in[i], 1 / 2.4f) - 0.055f;
}

//===-- Derivatives ---------------------------------------------------------------------------===//

void naiveArea(const float *in, float *out) {
  V n = cross(at(in), at(in + 3));
  out[0] = length(n) / 256;
  put(out + 1, normalize(n));
}
void naiveEdgeSlopes(const float *in, float *out) {
  float x = in[0];
  out[0] = 0.5f / std::sqrt(x);
  out[1] = -0.5f / (x * std::sqrt(x));
  out[2] = 1 / x;
  out[3] = -1 / std::sqrt(1 - x * x);
}
void naivePowerSlopes(const float *in, float *out) {
  out[0] = in[1] * std::pow(in[0], in[1] - 1);
  out[1] = std::pow(in[0], in[1]) * std::log(in[0]);
}
void naiveLengthSlopes(const float *in, float *out) {
  float l = length(at(in));
  V n = (1 / l) * at(in);
  out[0] = n.x;
  put(out + 1, {(1 - n.x * n.x) / l, -n.x * n.y / l, -n.x * n.z / l});
}
void naiveAtan2Slopes(const float *in, float *out) {
  float y = in[0], x = in[1], r = y / x;
  out[0] = 1 / x / (1 + r * r);
  out[1] = -y / square(x) / (1 + r * r);
}
void naiveKinks(const float *in, float *out) {
  // Differences over a step of 1e-3, as renderers without derivatives take them.
  float x = in[0], y = in[1], h = 1e-3f;
  auto slope = [&](auto f) { return (f(x + h) - f(x)) / h; };
  out[0] = slope([](float a) { return std::fabs(a); });
  out[1] = slope([&](float a) { return std::min(a, y); });
  out[2] = slope([&](float a) { return std::max(a, y); });
  out[3] = slope([&](float a) { return std::max(0.0f, std::min(a, y)); });
  out[4] = slope([&](float a) { return a < y ? 0.0f : 1.0f; }) +
           slope([](float a) { return std::ceil(a); });
  out[5] = slope([](float a) { return std::floor(a); });
  out[6] = slope([&](float a) { return a - y * std::floor(a / y); });
}
void naiveFilterwidth(const float *in, float *out) {
  float width = std::fabs(in[2]) * 0.0625f;
  out[0] = std::clamp((in[1] - in[0]) / width + 0.5f, 0.0f, 1.0f);
  out[1] = in[1] < in[0] ? 0 : 1;
}

//===-- Renderers -----------------------------------------------------------------------------===//

void naiveQuadric(const float *in, float *out) {
  // a (x² + y²) + b z² + c z + d along the ray, by the formula that schools teach.
  V o = at(in), q = at(in + 3);
  float b = 0, c = 0, d = -1;
  switch (int(in[6])) {
  case 0:
    b = 1;
    break;
  case 1:
    b = -1, c = 2;
    break;
  case 4:
    c = -1, d = 0;
    break;
  case 3:
    b = -0.52f, c = -0.62f, d = -0.4925f;
    break;
  }
  float A = q.x * q.x + q.y * q.y + b * q.z * q.z;
  float B = 2 * (o.x * q.x + o.y * q.y + b * o.z * q.z) + c * q.z;
  float C = o.x * o.x + o.y * o.y + b * o.z * o.z + c * o.z + d, D = B * B - 4 * A * C;
  float t0 = (-B - std::sqrt(D)) / (2 * A), t1 = (-B + std::sqrt(D)) / (2 * A);
  out[0] = D < 0 ? -1 : std::min(t0, t1);
  out[1] = D < 0 ? -1 : std::max(t0, t1);
}
void naiveFarCamera(const float *in, float *out) {
  // The point before the sphere's middle, in the world's coordinates, and then the difference to
  // the eye.
  V offset = at(in + 3), surface = offset - (in[6] / length(offset)) * offset;
  put(out, (at(in) + surface) - at(in));
}

} // namespace hardcases
