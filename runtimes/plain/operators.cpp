//===-- runtimes/plain/operators.cpp - operators without guards -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Each is the formula by which textbooks define it, and nothing else.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/runtime.h>

using namespace anysl;

namespace {

constexpr auto quotient = [](const anysl_float &a, const anysl_float &b) {
  return math::divide(a, b);
};

anysl_float insideSquared(const anysl_float &c, const anysl_float &eta) {
  return 1 - eta * eta * (1 - c * c);
}

anysl_vector refracted(const anysl_vector &I, const anysl_vector &N, const anysl_float &eta,
                       const anysl_float &c, const anysl_float &k) {
  anysl_vector through = I * eta - N * (eta * c + math::sqrt(k)), none = {0, 0, 0};
  return each([&](const anysl_float &a, const anysl_float &b) { return select(k < 0, b, a); },
              through, none);
}

} // namespace

void anysl_div_float(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = quotient(*a, *b);
}
void anysl_div_color(anysl_color *result, const anysl_color *a, const anysl_color *b) {
  *result = each(quotient, *a, *b);
}
void anysl_div_vector(anysl_vector *result, const anysl_vector *a, const anysl_vector *b) {
  *result = each(quotient, *a, *b);
}

void anysl_sqrt(anysl_float *result, const anysl_float *x) { *result = math::sqrt(*x); }
void anysl_inversesqrt(anysl_float *result, const anysl_float *x) {
  *result = math::inversesqrt(*x);
}
void anysl_exp(anysl_float *result, const anysl_float *x) { *result = math::exp(*x); }
void anysl_log(anysl_float *result, const anysl_float *x) { *result = math::log(*x); }
void anysl_asin(anysl_float *result, const anysl_float *x) { *result = math::asin(*x); }
void anysl_acos(anysl_float *result, const anysl_float *x) { *result = math::acos(*x); }
void anysl_pow(anysl_float *result, const anysl_float *x, const anysl_float *y) {
  *result = math::pow(*x, *y);
}

void anysl_mod(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = *a - *b * floorOf(math::divide(*a, *b));
}

void anysl_smoothstep(anysl_float *result, const anysl_float *low, const anysl_float *high,
                      const anysl_float *x) {
  anysl_float t = math::divide(*x - *low, *high - *low);
  t = select(t < 0, anysl_float(0), t);
  t = select(t > 1, anysl_float(1), t);
  *result = t * t * (3 - 2 * t);
}

void anysl_length(anysl_float *result, const anysl_vector *v) { *result = math::sqrt(dot(*v, *v)); }
void anysl_normalize(anysl_vector *result, const anysl_vector *v) {
  *result = *v * math::divide(anysl_float(1), math::sqrt(dot(*v, *v)));
}

void anysl_refract(anysl_vector *result, const anysl_vector *I, const anysl_vector *N,
                   const anysl_float *eta) {
  anysl_float c = dot(*I, *N);
  *result = refracted(*I, *N, *eta, c, insideSquared(c, *eta));
}

void anysl_fresnel(const anysl_vector *I, const anysl_vector *N, const anysl_float *eta,
                   anysl_float *Kr, anysl_float *Kt, anysl_vector *R, anysl_vector *T) {
  anysl_float c = dot(*I, *N), k = insideSquared(c, *eta);
  anysl_float outside = absOf(c), inside = math::sqrt(k);
  anysl_float perpendicular = quotient(*eta * outside - inside, *eta * outside + inside);
  anysl_float parallel = quotient(outside - *eta * inside, outside + *eta * inside);
  anysl_float share = anysl_float(0.5) * (perpendicular * perpendicular + parallel * parallel);
  share = select(k < 0, anysl_float(1), share);
  anysl_vector reflected = *I - *N * (2 * c), through = refracted(*I, *N, *eta, c, k);
  *Kr = share;
  *Kt = 1 - share;
  *R = reflected;
  *T = through;
}
