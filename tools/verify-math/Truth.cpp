//===-- tools/verify-math/Truth.cpp -----------------------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/verify-math/Truth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace anysl::verify {

namespace {

//===-- The functions of the C library and of MPFR, by the table's names ----//

double c_inversesqrt(double x, double) { return 1 / std::sqrt(x); }
double c_reciprocal(double x, double) { return 1 / x; }
double c_divide(double x, double y) { return x / y; }
#define C_UNARY(name)                                                                              \
  double c_##name(double x, double) { return std::name(x); }                                       \
  void m_##name(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr) { mpfr_##name(r, x, MPFR_RNDN); }
#define C_BINARY(name)                                                                             \
  double c_##name(double x, double y) { return std::name(x, y); }                                  \
  void m_##name(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr y) { mpfr_##name(r, x, y, MPFR_RNDN); }
C_UNARY(sin)
C_UNARY(cos)
C_UNARY(tan)
C_UNARY(asin)
C_UNARY(acos)
C_UNARY(atan)
C_UNARY(sinh)
C_UNARY(cosh)
C_UNARY(tanh)
C_UNARY(exp)
C_UNARY(exp2)
C_UNARY(log)
C_UNARY(log2)
C_UNARY(log10)
C_UNARY(cbrt)
C_UNARY(sqrt)
C_BINARY(atan2)
C_BINARY(pow)
C_BINARY(hypot)
void m_inversesqrt(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr) {
  mpfr_rec_sqrt(r, x, MPFR_RNDN);
  if (mpfr_zero_p(x)) // MPFR answers +inf for −0, against 1/sqrt(x)
    mpfr_set_inf(r, mpfr_signbit(x) ? -1 : 1);
}
void m_reciprocal(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr) { mpfr_ui_div(r, 1, x, MPFR_RNDN); }
void m_divide(mpfr_ptr r, mpfr_srcptr x, mpfr_srcptr y) { mpfr_div(r, x, y, MPFR_RNDN); }

constexpr Function Table[] = {
#define MATH_UNARY(name, low, high, bits) {#name, 1, {low, 0}, {high, 0}, bits, c_##name, m_##name},
#define MATH_BINARY(name, lowX, highX, lowY, highY, bits)                                          \
  {#name, 2, {lowX, lowY}, {highX, highY}, bits, c_##name, m_##name},
#include <anysl/MathFunctions.def>
};

//===-- Rounding ------------------------------------------------------------//

/// Numbers of MPFR, kept since making them costs more than most functions.
struct Workspace {
  mpfr_t x, y, result, difference;
  Workspace() { mpfr_inits2(128, x, y, result, difference, nullptr); }
  ~Workspace() { mpfr_clears(x, y, result, difference, nullptr); }
};
Workspace &workspace() {
  static thread_local Workspace w;
  return w;
}

/// How far the C library's double may be off, in units of its last place: glibc documents at most 4
/// for these functions.
constexpr int DoubtUlps = 8;

/// Whether a value that near `value` could round to a float other than float(value) does.
bool isDoubtful(double value) {
  if (value == 0 || !std::isfinite(value))
    return false;
  auto bits = std::bit_cast<uint64_t>(value);
  double below = std::bit_cast<double>(bits - DoubtUlps),
         above = std::bit_cast<double>(bits + DoubtUlps);
  return float(below) != float(above);
}

float roundExactly(const Function &f, float x, float y) {
  Workspace &w = workspace();
  mpfr_set_flt(w.x, x, MPFR_RNDN);
  mpfr_set_flt(w.y, y, MPFR_RNDN);
  for (mpfr_prec_t bits = 128;; bits *= 2) {
    mpfr_set_prec(w.result, bits);
    f.exact(w.result, w.x, w.y);
    // The value is within one unit of the last bit: rounding is certain if both ends agree; an
    // exact middle, which only algebraic functions and pow have, stays at any precision.
    if (mpfr_regular_p(w.result) && bits < 1024) {
      mpfr_set_prec(w.difference, bits);
      mpfr_set(w.difference, w.result, MPFR_RNDN);
      mpfr_nextbelow(w.difference);
      float below = mpfr_get_flt(w.difference, MPFR_RNDN);
      mpfr_nextabove(w.difference);
      mpfr_nextabove(w.difference);
      if (below != mpfr_get_flt(w.difference, MPFR_RNDN))
        continue;
    }
    float rounded = mpfr_get_flt(w.result, MPFR_RNDN);
    mpfr_set_prec(w.result, 128);
    mpfr_set_prec(w.difference, 128);
    return rounded;
  }
}

template <class T>
double ulpOf(double value) {
  using Limits = std::numeric_limits<T>;
  int exponent;
  std::frexp(value, &exponent);
  exponent = std::max(exponent, Limits::min_exponent);
  return std::ldexp(1.0, std::min(exponent, Limits::max_exponent) - Limits::digits);
}

} // namespace

std::span<const Function> functions() { return Table; }

const Function *findFunction(std::string_view name) {
  for (const Function &f : Table)
    if (f.name == name)
      return &f;
  return nullptr;
}

Truth truthOf(const Function &f, float x, float y) {
  double value = f.approximate(x, y);
  return {value, isDoubtful(value) ? roundExactly(f, x, y) : float(value)};
}

double errorInUlp(Truth truth, float got) {
  constexpr double Wrong = std::numeric_limits<double>::infinity(), Top = 0x1p128;
  if (std::isnan(truth.value) || std::isnan(got))
    return std::isnan(truth.value) && std::isnan(got) ? 0 : Wrong;
  if (std::signbit(truth.value) != std::signbit(got))
    return got == 0 || truth.value == 0 ? Wrong
                                        : std::fabs(got - truth.value) / ulpOf<float>(truth.value);
  if (std::isinf(truth.value))
    return std::isinf(got) ? 0 : Wrong;
  double value = std::fabs(got), wanted = std::fabs(truth.value);
  if (std::isinf(got)) {
    value = Top;
    wanted = std::min(wanted, Top);
  }
  return std::fabs(value - wanted) / ulpOf<float>(wanted);
}

double errorInUlp(const Function &f, double x, double y, double got) {
  constexpr double Wrong = std::numeric_limits<double>::infinity();
  Workspace &w = workspace();
  mpfr_set_d(w.x, x, MPFR_RNDN);
  mpfr_set_d(w.y, y, MPFR_RNDN);
  f.exact(w.result, w.x, w.y);
  bool nan = mpfr_nan_p(w.result);
  if (nan || std::isnan(got))
    return nan && std::isnan(got) ? 0 : Wrong;
  if (mpfr_inf_p(w.result) || (mpfr_zero_p(w.result) && got == 0))
    return got == mpfr_get_d(w.result, MPFR_RNDN) &&
                   bool(mpfr_signbit(w.result)) == std::signbit(got)
               ? 0
               : Wrong;
  if (bool(mpfr_signbit(w.result)) != std::signbit(got))
    return Wrong;
  double wanted = mpfr_get_d(w.result, MPFR_RNDN);
  if (std::isinf(got))
    mpfr_set_si_2exp(w.difference, got > 0 ? 1 : -1, 1024, MPFR_RNDN);
  else
    mpfr_set_d(w.difference, got, MPFR_RNDN);
  if (std::isinf(got) && std::isinf(wanted))
    return 0;
  mpfr_sub(w.difference, w.difference, w.result, MPFR_RNDN);
  double ulp = std::isinf(wanted) ? 0x1p971 : ulpOf<double>(wanted);
  mpfr_div_d(w.difference, w.difference, ulp, MPFR_RNDN);
  return std::fabs(mpfr_get_d(w.difference, MPFR_RNDN));
}

} // namespace anysl::verify
