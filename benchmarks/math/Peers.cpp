//===-- benchmarks/math/Peers.cpp - other people's functions at one width ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Compiled twice: for AVX2 with ANYSL_WIDTH 8 and for AVX-512 with ANYSL_WIDTH 16.
//
//===------------------------------------------------------------------------------------------===//

#include "benchmarks/math/Peers.h"

#include <OpenImageIO/fmath.h>
#include <immintrin.h>
#include <sleef.h>

#if ANYSL_WIDTH == 16
using Vector = __m512;
#define SLEEF(name, tier) Sleef_##name##f16_##tier##avx512f
#define MVEC1(name) _ZGVeN16v_##name##f
#define MVEC2(name) _ZGVeN16vv_##name##f
#define PEERS peers16
#else
using Vector = __m256;
#define SLEEF(name, tier) Sleef_##name##f8_##tier##avx2
#define MVEC1(name) _ZGVdN8v_##name##f
#define MVEC2(name) _ZGVdN8vv_##name##f
#define PEERS peers8
#endif

#define MVEC1_ALL(F)                                                                               \
  F(sin)                                                                                           \
  F(cos)                                                                                           \
  F(tan)                                                                                           \
  F(asin) F(acos) F(atan) F(sinh) F(cosh) F(tanh) F(exp) F(exp2) F(log) F(log2) F(log10) F(cbrt)
#define MVEC2_ALL(F) F(atan2) F(pow) F(hypot)

extern "C" {
#define DECLARE(name) Vector MVEC1(name)(Vector);
MVEC1_ALL(DECLARE)
#undef DECLARE
#define DECLARE(name) Vector MVEC2(name)(Vector, Vector);
MVEC2_ALL(DECLARE)
}

namespace anysl::bench {

namespace {

Vector load(const float *p) { return *reinterpret_cast<const Vector *>(p); }

template <auto F>
void unary(const float *x, const float *, float *r, size_t n) {
  for (size_t i = 0; i < n; i += ANYSL_WIDTH)
    *reinterpret_cast<Vector *>(r + i) = F(load(x + i));
}
template <auto F>
void binary(const float *x, const float *y, float *r, size_t n) {
  for (size_t i = 0; i < n; i += ANYSL_WIDTH)
    *reinterpret_cast<Vector *>(r + i) = F(load(x + i), load(y + i));
}

} // namespace

std::vector<Peer> PEERS() {
  std::vector<Peer> peers;
#define ADD(name) peers.push_back({#name, "libmvec", unary<MVEC1(name)>});
  MVEC1_ALL(ADD)
#undef ADD
#define ADD(name) peers.push_back({#name, "libmvec", binary<MVEC2(name)>});
  MVEC2_ALL(ADD)
#undef ADD

#define ADD(name, tier) peers.push_back({#name, "SLEEF " #tier, unary<SLEEF(name, tier)>});
#define ADD_BOTH(name) ADD(name, u10) ADD(name, u35)
  ADD_BOTH(sin)
  ADD_BOTH(cos)
  ADD_BOTH(tan)
  ADD_BOTH(asin)
  ADD_BOTH(acos)
  ADD_BOTH(atan)
  ADD_BOTH(sinh)
  ADD_BOTH(cosh)
  ADD_BOTH(tanh)
  ADD_BOTH(exp2)
  ADD_BOTH(log)
  ADD_BOTH(log2)
  ADD_BOTH(cbrt)
  ADD(exp, u10)
  ADD(log10, u10)
#undef ADD
#define ADD(name, tier) peers.push_back({#name, "SLEEF " #tier, binary<SLEEF(name, tier)>});
  ADD_BOTH(atan2)
  ADD(pow, u10)
  ADD(hypot, u05)
  ADD(hypot, u35)
#undef ADD

  // OpenImageIO's functions are scalar code that the compiler widens.
#define ADD(name, call)                                                                            \
  peers.push_back({#name, "OpenImageIO", [](const float *x, const float *, float *r, size_t n) {   \
                     for (size_t i = 0; i < n; ++i)                                                \
                       r[i] = OIIO::call(x[i]);                                                    \
                   }});
  ADD(sin, fast_sin)
  ADD(cos, fast_cos)
  ADD(tan, fast_tan)
  ADD(asin, fast_asin)
  ADD(acos, fast_acos)
  ADD(atan, fast_atan)
  ADD(sinh, fast_sinh)
  ADD(cosh, fast_cosh)
  ADD(tanh, fast_tanh)
  ADD(exp, fast_exp)
  ADD(exp2, fast_exp2)
  ADD(log, fast_log)
  ADD(log2, fast_log2)
  ADD(log10, fast_log10)
  ADD(cbrt, fast_cbrt)
#undef ADD
#define ADD(name, call)                                                                            \
  peers.push_back({#name, "OpenImageIO", [](const float *x, const float *y, float *r, size_t n) {  \
                     for (size_t i = 0; i < n; ++i)                                                \
                       r[i] = OIIO::call(x[i], y[i]);                                              \
                   }});
  ADD(atan2, fast_atan2)
  ADD(pow, fast_safe_pow)
#undef ADD
  return peers;
}

} // namespace anysl::bench
