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

/// Whether rays that shaders trace carry derivatives, where numbers do: as `--ray-derivatives` has
/// it. Where they do not, nothing that leads to a ray alone has any.
extern "C" __attribute__((weak)) const bool anysl_rays_carry_derivatives = false;

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

inline bool raysCarryDerivatives() {
  return hasDerivatives<anysl_float> && anysl_rays_carry_derivatives;
}

/// Calls use(ANYSL_CHANGE_ARGUMENTS). Each number gets an address of its own; where rays carry
/// no derivatives, all are 0.
template <typename Use>
inline auto withRayChange(const anysl_context *context, const anysl_point &P, const anysl_vector &R,
                          const Use &use) {
  auto carried = [](const auto &x) { return anysl_rays_carry_derivatives ? float(x) : 0.0f; };
  float pxu = carried(derivativeU(P.x)), pyu = carried(derivativeU(P.y)),
        pzu = carried(derivativeU(P.z));
  float pxv = carried(derivativeV(P.x)), pyv = carried(derivativeV(P.y)),
        pzv = carried(derivativeV(P.z));
  float rxu = carried(derivativeU(R.x)), ryu = carried(derivativeU(R.y)),
        rzu = carried(derivativeU(R.z));
  float rxv = carried(derivativeV(R.x)), ryv = carried(derivativeV(R.y)),
        rzv = carried(derivativeV(R.z));
  float du = carried(stepOfU(context)), dv = carried(stepOfV(context));
  return use(&pxu, &pyu, &pzu, &pxv, &pyv, &pzv, &rxu, &ryu, &rzu, &rxv, &ryv, &rzv, &du, &dv);
}

/// The same where numbers carry derivatives, else use(): what a function's parameters are.
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
