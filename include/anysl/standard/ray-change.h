//===-- anysl/standard/ray-change.h - how a shader's rays change from point to point ----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What a ray's origin and direction carry of derivatives is what transporting a ray differential
// through the shader's mirror or lens gives (Igehy, Tracing Ray Differentials, 1999), whatever the
// shader computes the direction by. The renderer gets it as AnyslRayDerivatives.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_RAY_CHANGE_H
#define ANYSL_STANDARD_RAY_CHANGE_H

#include <anysl/standard/context.h>

/// By address, as in standard/hit-call.h.
#define ANYSL_CHANGE_PARAMETERS                                                                    \
  const float *pxu, const float *pyu, const float *pzu, const float *pxv, const float *pyv,        \
      const float *pzv, const float *rxu, const float *ryu, const float *rzu, const float *rxv,    \
      const float *ryv, const float *rzv, const float *du, const float *dv
#define ANYSL_CHANGE_ARGUMENTS pxu, pyu, pzu, pxv, pyv, pzv, rxu, ryu, rzu, rxv, ryv, rzv, du, dv
#define ANYSL_CHANGE_LETTERS "l4l4l4l4l4l4l4l4l4l4l4l4l4l4"

namespace anysl {

inline AnyslRayDerivatives rayDerivatives(ANYSL_CHANGE_PARAMETERS) {
  return {sizeof(AnyslRayDerivatives),
          {pxu, pyu, pzu},
          {pxv, pyv, pzv},
          {rxu, ryu, rzu},
          {rxv, ryv, rzv},
          du,
          dv};
}

/// Calls use(ANYSL_CHANGE_ARGUMENTS). Each number gets an address of its own.
template <typename Use>
inline auto withRayChange(const anysl_context *context, const anysl_point &P, const anysl_vector &R,
                          const Use &use) {
  float pxu = float(derivativeU(P.x)), pyu = float(derivativeU(P.y)), pzu = float(derivativeU(P.z));
  float pxv = float(derivativeV(P.x)), pyv = float(derivativeV(P.y)), pzv = float(derivativeV(P.z));
  float rxu = float(derivativeU(R.x)), ryu = float(derivativeU(R.y)), rzu = float(derivativeU(R.z));
  float rxv = float(derivativeV(R.x)), ryv = float(derivativeV(R.y)), rzv = float(derivativeV(R.z));
  float du = float(stepOfU(context)), dv = float(stepOfV(context));
  return use(&pxu, &pyu, &pzu, &pxv, &pyv, &pzv, &rxu, &ryu, &rzu, &rxv, &ryv, &rzv, &du, &dv);
}

/// The same where numbers carry derivatives, else use().
template <typename Use>
inline void withKnownChange(const anysl_context *context, const anysl_point &P,
                            const anysl_vector &R, const Use &use) {
  if constexpr (hasDerivatives<anysl_float>)
    withRayChange(context, P, R, use);
  else
    use();
}

/// The same as an array, for functions that have no wide form.
inline constexpr int rayChangeCount = 14;
inline void copyRayChange(const anysl_context *context, const anysl_point &P, const anysl_vector &R,
                          float *change) {
  withRayChange(context, P, R, [&](auto... numbers) { ((*change++ = *numbers), ...); });
}
inline AnyslRayDerivatives rayDerivatives(const float *c) {
  return rayDerivatives(c, c + 1, c + 2, c + 3, c + 4, c + 5, c + 6, c + 7, c + 8, c + 9, c + 10,
                        c + 11, c + 12, c + 13);
}

} // namespace anysl

#endif // ANYSL_STANDARD_RAY_CHANGE_H
