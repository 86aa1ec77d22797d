//===-- runtimes/real/mp/functions.cpp - arithmetic of Mp, by MPFR ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// MPFR works on an Mp's own digits through its custom interface. A shader that is linked with such
// numbers needs libmpfr where it is linked and where it runs; the pragma tells the object file.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/real.h>

// A test uses these beside another real.
#include <anysl/mp.h>
#include <mpfr.h>

#ifdef ANYSL_IS_BITCODE
#pragma comment(lib, "libmpfr.so.6")
#endif

using anysl::Mp;

static_assert(sizeof(mp_limb_t) == sizeof(uint64_t) && sizeof(mpfr_exp_t) == sizeof(int64_t));

extern "C" {
extern const uint32_t anysl_real_precision_limit = Mp::limbCount * 64;
/// Weak, so that its value here does not become a part of the code before the linker has set it.
__attribute__((weak)) extern const uint32_t anysl_real_precision = 200;
}

namespace {

/// Code stays small where these stay calls.
#define ANYSL_MP_FUNCTION __attribute__((noinline))

/// A number as MPFR sees it.
struct Operand {
  mpfr_t value;

  explicit Operand(const Mp &x) {
    int kind = x.kind == Mp::Zero       ? MPFR_ZERO_KIND
               : x.kind == Mp::Finite   ? MPFR_REGULAR_KIND
               : x.kind == Mp::Infinite ? MPFR_INF_KIND
                                        : MPFR_NAN_KIND;
    mpfr_custom_init_set(value, x.isNegative ? -kind : kind, x.exponent,
                         mpfr_prec_t(anysl_real_precision), const_cast<uint64_t *>(x.limbs));
  }
};

/// A number that MPFR fills in.
struct Result {
  mpfr_t value;
  Mp &target;

  explicit Result(Mp *result) : target(*result) {
    mpfr_custom_init_set(value, MPFR_NAN_KIND, 0, mpfr_prec_t(anysl_real_precision), target.limbs);
  }
  ~Result() {
    target.kind = mpfr_nan_p(value)    ? Mp::NotANumber
                  : mpfr_inf_p(value)  ? Mp::Infinite
                  : mpfr_zero_p(value) ? Mp::Zero
                                       : Mp::Finite;
    target.isNegative = mpfr_signbit(value) != 0;
    target.exponent = target.kind == Mp::Finite ? mpfr_get_exp(value) : 0;
  }
};

int mpfr_inversesqrt(mpfr_t result, const mpfr_t x, mpfr_rnd_t mode) {
  return mpfr_rec_sqrt(result, x, mode);
}
int mpfr_reciprocal(mpfr_t result, const mpfr_t x, mpfr_rnd_t mode) {
  return mpfr_ui_div(result, 1, x, mode);
}
int mpfr_divide(mpfr_t result, const mpfr_t x, const mpfr_t y, mpfr_rnd_t mode) {
  return mpfr_div(result, x, y, mode);
}

} // namespace

//===-- Conversion and comparison -------------------------------------------------------------===//

ANYSL_MP_FUNCTION void anysl_mp_from_double(Mp *result, double x) {
  mpfr_set_d(Result(result).value, x, MPFR_RNDN);
}

ANYSL_MP_FUNCTION double anysl_mp_to_double(const Mp *x) {
  return mpfr_get_d(Operand(*x).value, MPFR_RNDN);
}

ANYSL_MP_FUNCTION int64_t anysl_mp_to_integer(const Mp *x) {
  return mpfr_get_si(Operand(*x).value, MPFR_RNDZ);
}

ANYSL_MP_FUNCTION int32_t anysl_mp_compare(const Mp *a, const Mp *b) {
  if (isNaN(*a) || isNaN(*b))
    return 2;
  int order = mpfr_cmp(Operand(*a).value, Operand(*b).value);
  return (order > 0) - (order < 0);
}

//===-- Arithmetic and functions --------------------------------------------------------------===//

ANYSL_MP_FUNCTION void anysl_mp_fma(Mp *result, const Mp *a, const Mp *b, const Mp *c) {
  mpfr_fma(Result(result).value, Operand(*a).value, Operand(*b).value, Operand(*c).value,
           MPFR_RNDN);
}

/// As many digits as x has hold what these give.
ANYSL_MP_FUNCTION void anysl_mp_floor(Mp *result, const Mp *x) {
  mpfr_floor(Result(result).value, Operand(*x).value);
}
ANYSL_MP_FUNCTION void anysl_mp_ceil(Mp *result, const Mp *x) {
  mpfr_ceil(Result(result).value, Operand(*x).value);
}

ANYSL_MP_FUNCTION void anysl_mp_next_below(Mp *result, const Mp *x) {
  Result below(result);
  Operand operand(*x);
  mpfr_set(below.value, operand.value, MPFR_RNDN);
  mpfr_nextbelow(below.value);
}

#define MATH_UNARY(name, ...)                                                                      \
  ANYSL_MP_FUNCTION void anysl_mp_##name(Mp *result, const Mp *x) {                                \
    mpfr_##name(Result(result).value, Operand(*x).value, MPFR_RNDN);                               \
  }
#define MATH_BINARY(name, ...)                                                                     \
  ANYSL_MP_FUNCTION void anysl_mp_##name(Mp *result, const Mp *x, const Mp *y) {                   \
    mpfr_##name(Result(result).value, Operand(*x).value, Operand(*y).value, MPFR_RNDN);            \
  }
MATH_BINARY(add)
MATH_BINARY(sub)
MATH_BINARY(mul)
#include <anysl/MathFunctions.def>
