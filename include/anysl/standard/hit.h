//===-- anysl/standard/hit.h - what rays meet first -------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// To be included where a runtime has defined, in an unnamed namespace,
//
//     void findHit(ANYSL_HIT_PARAMETERS);     // of standard/hit-call.h
//
// What is found carries no derivatives.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_HIT_H
#define ANYSL_STANDARD_HIT_H

#include <anysl/standard/hit-call.h>
#include <anysl/standard/message.h>

namespace anysl {

/// The distance of what no ray meets.
inline constexpr double nothingMet = 1e30;

/// Each number and text gets an address of its own, for the runtime's function to read and write
/// lanes there.
inline bool findHit(const anysl_context *context, AnyslHitShading shades, const anysl_point &P,
                    const anysl_vector &R, const anysl_float &within, anysl_string kind,
                    anysl_string subset, anysl_string sides, anysl_float &distance, anysl_normal &N,
                    anysl_normal &Ng, anysl_color &color, anysl_color &opacity) {
  float px = float(numberOf(P.x)), py = float(numberOf(P.y)), pz = float(numberOf(P.z));
  float rx = float(numberOf(R.x)), ry = float(numberOf(R.y)), rz = float(numberOf(R.z));
  float reach = float(numberOf(within));
  float t, nx, ny, nz, gx, gy, gz, r, g, b, opaqueR, opaqueG, opaqueB;
  withKnownChange(context, P, R, [&](auto... change) {
    ::findHit(context->args, context->point, shades, &kind, &subset, &sides, &px, &py, &pz, &rx,
              &ry, &rz, &reach, &t, &nx, &ny, &nz, &gx, &gy, &gz, &r, &g, &b, &opaqueR, &opaqueG,
              &opaqueB, change...);
  });
  bool isHit = t >= 0;
  distance = select(isHit, anysl_float(t), anysl_float(nothingMet));
  N = {anysl_float(nx), anysl_float(ny), anysl_float(nz)};
  Ng = {anysl_float(gx), anysl_float(gy), anysl_float(gz)};
  color = {anysl_float(r), anysl_float(g), anysl_float(b)};
  opacity = {anysl_float(opaqueR), anysl_float(opaqueG), anysl_float(opaqueB)};
  return isHit;
}

} // namespace anysl

bool anysl_trace_hit(anysl_context *context, const anysl_point *P, const anysl_vector *R,
                     const anysl_float *reach, const anysl_string *kind, const anysl_string *subset,
                     const anysl_string *sides, anysl_float *distance, anysl_normal *N,
                     anysl_normal *Ng) {
  anysl_color color, opacity;
  return anysl::findHit(context, ANYSL_SHADE_NOTHING, *P, *R, *reach, *kind, *subset, *sides,
                        *distance, *N, *Ng, color, opacity);
}

bool anysl_trace_shade(anysl_context *context, const anysl_point *P, const anysl_vector *R,
                       const anysl_float *reach, const anysl_string *kind,
                       const anysl_string *subset, const anysl_string *sides, anysl_float *distance,
                       anysl_normal *N, anysl_normal *Ng, anysl_color *color,
                       anysl_color *opacity) {
  return anysl::findHit(context, ANYSL_SHADE_FIRST, *P, *R, *reach, *kind, *subset, *sides,
                        *distance, *N, *Ng, *color, *opacity);
}

void anysl_trace_light(anysl_color *color, anysl_context *context, const anysl_point *P,
                       const anysl_vector *R, const anysl_float *reach, const anysl_string *kind,
                       const anysl_string *subset, const anysl_string *sides,
                       anysl_color *opacity) {
  anysl_float distance;
  anysl_normal N, Ng;
  anysl::findHit(context, ANYSL_SHADE_ALL, *P, *R, *reach, *kind, *subset, *sides, distance, N, Ng,
                 *color, *opacity);
}

void anysl_transmission_among(anysl_color *color, anysl_context *context, const anysl_point *P,
                              const anysl_vector *R, const anysl_float *reach,
                              const anysl_string *subset, const anysl_string *sides) {
  anysl_float distance;
  anysl_normal N, Ng;
  anysl_color light, opacity;
  anysl::findHit(context, ANYSL_SHADE_ALL, *P, *R, *reach, "transmission", *subset, *sides,
                 distance, N, Ng, light, opacity);
  *color = {anysl_float(1) - opacity.r, anysl_float(1) - opacity.g, anysl_float(1) - opacity.b};
}

namespace anysl {

/// The service `trace_hit` for one point, with questions about the surface; what is found lies in
/// `result`: the distance, N, Ng, the colour and the opacity. `change` is how the ray
/// changes, where numbers carry derivatives.
[[gnu::noinline]] inline void askForValues(const AnyslShadeArgs *args, uint32_t point, float px,
                                           float py, float pz, float rx, float ry, float rz,
                                           float reach, const char *kind, const char *subset,
                                           const char *sides, const float *change, const char *what,
                                           anysl_float *numbers, uint32_t numberCount,
                                           anysl_string *texts, uint32_t textCount, float *result) {
  withMessage(what, numbers, numberCount, texts, textCount, [&](AnyslMessage &message) {
    float *r = result;
    AnyslRayDerivatives derivatives = rayDerivatives(change);
    askForHits(args, point, ANYSL_SHADE_FIRST, &kind, &subset, &sides, &px, &py, &pz, &rx, &ry, &rz,
               &reach, r, r + 1, r + 2, r + 3, r + 4, r + 5, r + 6, r + 7, r + 8, r + 9, r + 10,
               r + 11, r + 12, raysCarryDerivatives() ? &derivatives : nullptr, 1, 1, &message);
    takeBack(message, numbers, texts);
  });
}

} // namespace anysl

bool anysl_trace_values(anysl_context *context, const anysl_point *P, const anysl_vector *R,
                        const anysl_float *reach, const anysl_string *kind,
                        const anysl_string *subset, const anysl_string *sides,
                        const anysl_string *what, anysl_float *numbers, uint32_t numberCount,
                        anysl_string *texts, uint32_t textCount, anysl_float *distance,
                        anysl_normal *N, anysl_normal *Ng, anysl_color *color,
                        anysl_color *opacity) {
  using namespace anysl;
  float found[13], change[rayChangeCount];
  if constexpr (hasDerivatives<anysl_float>)
    copyRayChange(context, *P, *R, change);
  askForValues(context->args, context->point, float(numberOf(P->x)), float(numberOf(P->y)),
               float(numberOf(P->z)), float(numberOf(R->x)), float(numberOf(R->y)),
               float(numberOf(R->z)), float(numberOf(*reach)), *kind, *subset, *sides, change,
               *what, numbers, numberCount, texts, textCount, found);
  bool isHit = found[0] >= 0;
  *distance = select(isHit, anysl_float(found[0]), anysl_float(nothingMet));
  *N = {anysl_float(found[1]), anysl_float(found[2]), anysl_float(found[3])};
  *Ng = {anysl_float(found[4]), anysl_float(found[5]), anysl_float(found[6])};
  *color = {anysl_float(found[7]), anysl_float(found[8]), anysl_float(found[9])};
  *opacity = {anysl_float(found[10]), anysl_float(found[11]), anysl_float(found[12])};
  return isHit;
}

#endif // ANYSL_STANDARD_HIT_H
