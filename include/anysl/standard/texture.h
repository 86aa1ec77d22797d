//===-- anysl/standard/texture.h - pictures out of files --------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The operators work out where a lookup is and how wide its filter, and hand that to the runtime:
// to be included where it has defined, in an unnamed namespace,
//
//     void lookUpTexture(ANYSL_TEXTURE_PARAMETERS);     // of standard/texture-call.h
//
// A filter's axes are the edges of a parallelogram. With four corners given they come from these,
// else from the derivatives of the coordinates, which are 0 where numbers carry none. The result
// carries no derivatives.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_TEXTURE_H
#define ANYSL_STANDARD_TEXTURE_H

#include <anysl/standard/texture-call.h>

namespace anysl {

/// A filter: where it is, its two axes, and how much it is widened.
struct TextureFilter {
  float x, y, z, xByU, yByU, zByU, xByV, yByV, zByV, sblur, tblur;
};

/// What a lookup asks for, besides.
struct TextureOptions {
  const anysl_string *name, *filter, *swrap, *twrap;
  float channel, fill, bias, samples;
};

inline float plain(const anysl_float &x) { return float(numberOf(x)); }

/// How far a coordinate goes in one step of u (of v).
inline float stepByU(const anysl_float &x, const anysl_float &du) {
  return float(derivativeU(x) * valueOf(du));
}
inline float stepByV(const anysl_float &x, const anysl_float &dv) {
  return float(derivativeV(x) * valueOf(dv));
}

/// The axes of a filter that fills the quadrilateral of four corners, given row by row or one after
/// the other around it: then the two edges that are called rows run against each other.
struct CornerAxes {
  Vec<float> center, byU, byV;

  CornerAxes(const Vec<float> &a, const Vec<float> &b, const Vec<float> &c, const Vec<float> &d) {
    Vec<float> rows = (b - a) + (d - c), around = (b - a) + (c - d);
    bool inRows = dot(rows, rows) >= dot(around, around);
    auto half = [](float x) { return 0.5f * x; };
    auto quarter = [](float x) { return 0.25f * x; };
    byU = each([&](float x, float y) { return half(inRows ? x : y); }, rows, around);
    byV = each(half, (c + d) - (a + b));
    center = each(quarter, (a + b) + (c + d));
  }
};

/// Each number gets an address of its own, for the runtime's function to read lanes there.
inline void lookUp(const anysl_context *context, uint32_t query, anysl_string name,
                   anysl_string filter, anysl_string swrap, anysl_string twrap, float channel,
                   float fill, float bias, float samples, float x, float y, float z, float xByU,
                   float yByU, float zByU, float xByV, float yByV, float zByV, float sblur,
                   float tblur, float &r, float &g, float &b) {
  lookUpTexture(context->args, context->point, query, &name, &filter, &swrap, &twrap, &channel,
                &fill, &bias, &samples, &x, &y, &z, &xByU, &yByU, &zByU, &xByV, &yByV, &zByV,
                &sblur, &tblur, &r, &g, &b);
}

inline void lookUp(const anysl_context *context, uint32_t query, const TextureOptions &o,
                   const TextureFilter &f, float &r, float &g, float &b) {
  lookUp(context, query, *o.name, *o.filter, *o.swrap, *o.twrap, o.channel, o.fill, o.bias,
         o.samples, f.x, f.y, f.z, f.xByU, f.yByU, f.zByU, f.xByV, f.yByV, f.zByV, f.sblur, f.tblur,
         r, g, b);
}

inline Vec<float> plain(const anysl_vector &v) { return {plain(v.x), plain(v.y), plain(v.z)}; }

/// The filter of a place, from its derivatives.
inline TextureFilter filterAt(const anysl_float &x, const anysl_float &y, const anysl_float &z,
                              const anysl_float &du, const anysl_float &dv) {
  return {plain(x),
          plain(y),
          plain(z),
          stepByU(x, du),
          stepByU(y, du),
          stepByU(z, du),
          stepByV(x, dv),
          stepByV(y, dv),
          stepByV(z, dv),
          0,
          0};
}

inline TextureFilter filterOver(const CornerAxes &axes) {
  return {axes.center.x, axes.center.y, axes.center.z, axes.byU.x, axes.byU.y, axes.byU.z,
          axes.byV.x,    axes.byV.y,    axes.byV.z,    0,          0};
}

/// swidth and twidth of coordinates s and t.
inline void scaleCoordinates(TextureFilter &filter, float swidth, float twidth) {
  filter.xByU *= swidth, filter.xByV *= swidth;
  filter.yByU *= twidth, filter.yByV *= twidth;
}

/// swidth and twidth of a direction or point, which has no s and t: of the axis along u, and along
/// v.
inline void scaleAxes(TextureFilter &filter, float swidth, float twidth) {
  filter.xByU *= swidth, filter.yByU *= swidth, filter.zByU *= swidth;
  filter.xByV *= twidth, filter.yByV *= twidth, filter.zByV *= twidth;
}

} // namespace anysl

//===-- Flat pictures -------------------------------------------------------------------------===//

#define ANYSL_TEXTURE_FIELDS                                                                       \
  const anysl_float *channel, const anysl_string *filter, const anysl_string *swrap,               \
      const anysl_string *twrap, const anysl_float *fill, const anysl_float *sblur,                \
      const anysl_float *tblur, const anysl_float *swidth, const anysl_float *twidth

namespace anysl {

inline void lookUpFlat(const anysl_context *context, uint32_t channels, TextureFilter place,
                       const anysl_string *name, ANYSL_TEXTURE_FIELDS, float &r, float &g,
                       float &b) {
  scaleCoordinates(place, plain(*swidth), plain(*twidth));
  place.sblur = plain(*sblur), place.tblur = plain(*tblur);
  TextureOptions options = {name, filter, swrap, twrap, plain(*channel), plain(*fill), 0, 0};
  lookUp(context, textureQuery(flatTexture, channels), options, place, r, g, b);
}

} // namespace anysl

void anysl_texture_float(anysl_float *result, anysl_context *context, const anysl_string *name,
                         const anysl_float *s, const anysl_float *t, const anysl_float *du,
                         const anysl_float *dv, ANYSL_TEXTURE_FIELDS) {
  using namespace anysl;
  float r, g, b;
  lookUpFlat(context, 1, filterAt(*s, *t, anysl_float(0), *du, *dv), name, channel, filter, swrap,
             twrap, fill, sblur, tblur, swidth, twidth, r, g, b);
  *result = anysl_float(r);
}

void anysl_texture_color(anysl_color *result, anysl_context *context, const anysl_string *name,
                         const anysl_float *s, const anysl_float *t, const anysl_float *du,
                         const anysl_float *dv, ANYSL_TEXTURE_FIELDS) {
  using namespace anysl;
  float r, g, b;
  lookUpFlat(context, 3, filterAt(*s, *t, anysl_float(0), *du, *dv), name, channel, filter, swrap,
             twrap, fill, sblur, tblur, swidth, twidth, r, g, b);
  *result = {anysl_float(r), anysl_float(g), anysl_float(b)};
}

void anysl_texture_corners_float(anysl_float *result, anysl_context *context,
                                 const anysl_string *name, const anysl_float *s1,
                                 const anysl_float *t1, const anysl_float *s2,
                                 const anysl_float *t2, const anysl_float *s3,
                                 const anysl_float *t3, const anysl_float *s4,
                                 const anysl_float *t4, ANYSL_TEXTURE_FIELDS) {
  using namespace anysl;
  float r, g, b;
  lookUpFlat(context, 1,
             filterOver({{plain(*s1), plain(*t1), 0},
                         {plain(*s2), plain(*t2), 0},
                         {plain(*s3), plain(*t3), 0},
                         {plain(*s4), plain(*t4), 0}}),
             name, channel, filter, swrap, twrap, fill, sblur, tblur, swidth, twidth, r, g, b);
  *result = anysl_float(r);
}

void anysl_texture_corners_color(anysl_color *result, anysl_context *context,
                                 const anysl_string *name, const anysl_float *s1,
                                 const anysl_float *t1, const anysl_float *s2,
                                 const anysl_float *t2, const anysl_float *s3,
                                 const anysl_float *t3, const anysl_float *s4,
                                 const anysl_float *t4, ANYSL_TEXTURE_FIELDS) {
  using namespace anysl;
  float r, g, b;
  lookUpFlat(context, 3,
             filterOver({{plain(*s1), plain(*t1), 0},
                         {plain(*s2), plain(*t2), 0},
                         {plain(*s3), plain(*t3), 0},
                         {plain(*s4), plain(*t4), 0}}),
             name, channel, filter, swrap, twrap, fill, sblur, tblur, swidth, twidth, r, g, b);
  *result = {anysl_float(r), anysl_float(g), anysl_float(b)};
}

#undef ANYSL_TEXTURE_FIELDS

//===-- Environments --------------------------------------------------------------------------===//

#define ANYSL_ENVIRONMENT_FIELDS                                                                   \
  const anysl_float *channel, const anysl_string *filter, const anysl_float *fill,                 \
      const anysl_float *sblur, const anysl_float *tblur, const anysl_float *swidth,               \
      const anysl_float *twidth

namespace anysl {

inline void lookUpEnvironment(const anysl_context *context, uint32_t channels, TextureFilter place,
                              const anysl_string *name, ANYSL_ENVIRONMENT_FIELDS, float &r,
                              float &g, float &b) {
  scaleAxes(place, plain(*swidth), plain(*twidth));
  place.sblur = plain(*sblur), place.tblur = plain(*tblur);
  anysl_string none = "";
  TextureOptions options = {name, filter, &none, &none, plain(*channel), plain(*fill), 0, 0};
  lookUp(context, textureQuery(environmentTexture, channels), options, place, r, g, b);
}

} // namespace anysl

void anysl_environment_float(anysl_float *result, anysl_context *context, const anysl_string *name,
                             const anysl_vector *R, const anysl_float *du, const anysl_float *dv,
                             ANYSL_ENVIRONMENT_FIELDS) {
  using namespace anysl;
  float r, g, b;
  lookUpEnvironment(context, 1, filterAt(R->x, R->y, R->z, *du, *dv), name, channel, filter, fill,
                    sblur, tblur, swidth, twidth, r, g, b);
  *result = anysl_float(r);
}

void anysl_environment_color(anysl_color *result, anysl_context *context, const anysl_string *name,
                             const anysl_vector *R, const anysl_float *du, const anysl_float *dv,
                             ANYSL_ENVIRONMENT_FIELDS) {
  using namespace anysl;
  float r, g, b;
  lookUpEnvironment(context, 3, filterAt(R->x, R->y, R->z, *du, *dv), name, channel, filter, fill,
                    sblur, tblur, swidth, twidth, r, g, b);
  *result = {anysl_float(r), anysl_float(g), anysl_float(b)};
}

void anysl_environment_corners_float(anysl_float *result, anysl_context *context,
                                     const anysl_string *name, const anysl_vector *R1,
                                     const anysl_vector *R2, const anysl_vector *R3,
                                     const anysl_vector *R4, ANYSL_ENVIRONMENT_FIELDS) {
  using namespace anysl;
  float r, g, b;
  lookUpEnvironment(context, 1, filterOver({plain(*R1), plain(*R2), plain(*R3), plain(*R4)}), name,
                    channel, filter, fill, sblur, tblur, swidth, twidth, r, g, b);
  *result = anysl_float(r);
}

void anysl_environment_corners_color(anysl_color *result, anysl_context *context,
                                     const anysl_string *name, const anysl_vector *R1,
                                     const anysl_vector *R2, const anysl_vector *R3,
                                     const anysl_vector *R4, ANYSL_ENVIRONMENT_FIELDS) {
  using namespace anysl;
  float r, g, b;
  lookUpEnvironment(context, 3, filterOver({plain(*R1), plain(*R2), plain(*R3), plain(*R4)}), name,
                    channel, filter, fill, sblur, tblur, swidth, twidth, r, g, b);
  *result = {anysl_float(r), anysl_float(g), anysl_float(b)};
}

#undef ANYSL_ENVIRONMENT_FIELDS

//===-- Shadow maps ---------------------------------------------------------------------------===//

#define ANYSL_SHADOW_FIELDS                                                                        \
  const anysl_float *bias, const anysl_float *samples, const anysl_float *sblur,                   \
      const anysl_float *tblur, const anysl_float *swidth, const anysl_float *twidth

namespace anysl {

inline void lookUpShadow(const anysl_context *context, TextureFilter place,
                         const anysl_string *name, ANYSL_SHADOW_FIELDS, anysl_float &result) {
  scaleAxes(place, plain(*swidth), plain(*twidth));
  place.sblur = plain(*sblur), place.tblur = plain(*tblur);
  anysl_string none = "";
  float shadow, g, b;
  TextureOptions options = {name, &none, &none, &none, 0, 0, plain(*bias), plain(*samples)};
  lookUp(context, textureQuery(shadowTexture, 1), options, place, shadow, g, b);
  result = anysl_float(shadow);
}

} // namespace anysl

void anysl_shadow(anysl_float *result, anysl_context *context, const anysl_string *name,
                  const anysl_point *P, const anysl_float *du, const anysl_float *dv,
                  ANYSL_SHADOW_FIELDS) {
  using namespace anysl;
  lookUpShadow(context, filterAt(P->x, P->y, P->z, *du, *dv), name, bias, samples, sblur, tblur,
               swidth, twidth, *result);
}

void anysl_shadow_corners(anysl_float *result, anysl_context *context, const anysl_string *name,
                          const anysl_point *P1, const anysl_point *P2, const anysl_point *P3,
                          const anysl_point *P4, ANYSL_SHADOW_FIELDS) {
  using namespace anysl;
  lookUpShadow(context, filterOver({plain(*P1), plain(*P2), plain(*P3), plain(*P4)}), name, bias,
               samples, sblur, tblur, swidth, twidth, *result);
}
#undef ANYSL_SHADOW_FIELDS

#endif // ANYSL_STANDARD_TEXTURE_H
