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
// changes as the coordinates do by what the picture's slope is there; that the filter changes with
// the place, too, and that the slope does, is left out. What a shadow map says has no derivatives:
// it counts samples.
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

/// What a channel is, and how it changes with the place.
struct TextureValue {
  float value, byX, byY, byZ;
};
struct TextureValues {
  TextureValue r, g, b;
};

/// A channel as a number, at the place where it was looked up. Where that carries derivatives of
/// derivatives, those of the slope count as unknown.
template <typename Real>
inline Real numberAt(const TextureValue &t, const Vec<Real> &place) {
  if constexpr (hasDerivatives<Real>) {
    using Slope = decltype(place.x.value);
    auto slope = [](float by) {
      if constexpr (hasDerivatives<Slope>)
        return withDerivatives<Slope>(by, anysl_unknown_derivative(), anysl_unknown_derivative());
      else
        return Slope(by);
    };
    Vec<Slope> values(place.x.value, place.y.value, place.z.value);
    return chain(numberAt(t, values), slope(t.byX), place.x, slope(t.byY), place.y, slope(t.byZ),
                 place.z);
  } else {
    return Real(t.value);
  }
}

/// The channels as a colour.
template <typename Real>
inline Rgb<Real> colorAt(const TextureValues &t, const Vec<Real> &place) {
  return {numberAt(t.r, place), numberAt(t.g, place), numberAt(t.b, place)};
}

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
inline TextureValues lookUp(const anysl_context *context, uint32_t query, anysl_string name,
                            anysl_string filter, anysl_string swrap, anysl_string twrap,
                            float channel, float fill, float bias, float samples, float x, float y,
                            float z, float xByU, float yByU, float zByU, float xByV, float yByV,
                            float zByV, float sblur, float tblur) {
  float r, g, b, rByX = 0, rByY = 0, rByZ = 0, gByX = 0, gByY = 0, gByZ = 0, bByX = 0, bByY = 0,
                 bByZ = 0;
  if constexpr (hasDerivatives<anysl_float>)
    query |= anysl_derivative_texture(slopesQuery ANYSL_SLOPE_ADDRESSES);
  lookUpTexture(context->args, context->point, query, &name, &filter, &swrap, &twrap, &channel,
                &fill, &bias, &samples, &x, &y, &z, &xByU, &yByU, &zByU, &xByV, &yByV, &zByV,
                &sblur, &tblur, &r, &g, &b ANYSL_SLOPE_ADDRESSES);
  return {{r, rByX, rByY, rByZ}, {g, gByX, gByY, gByZ}, {b, bByX, bByY, bByZ}};
}

inline TextureValues lookUp(const anysl_context *context, uint32_t query, const TextureOptions &o,
                            const TextureFilter &f) {
  return lookUp(context, query, *o.name, *o.filter, *o.swrap, *o.twrap, o.channel, o.fill, o.bias,
                o.samples, f.x, f.y, f.z, f.xByU, f.yByU, f.zByU, f.xByV, f.yByV, f.zByV, f.sblur,
                f.tblur);
}

inline Vec<float> plain(const anysl_vector &v) { return {plain(v.x), plain(v.y), plain(v.z)}; }

/// A place, with derivatives, and the filter there.
struct FilteredPlace {
  Vec<anysl_float> place;
  TextureFilter filter;
};

/// The filter of a place, from its derivatives.
inline FilteredPlace filterAt(const Vec<anysl_float> &p, const anysl_float &du,
                              const anysl_float &dv) {
  return {p,
          {plain(p.x), plain(p.y), plain(p.z), stepByU(p.x, du), stepByU(p.y, du), stepByU(p.z, du),
           stepByV(p.x, dv), stepByV(p.y, dv), stepByV(p.z, dv), 0, 0}};
}

/// The filter over four corners.
inline FilteredPlace filterOver(const Vec<anysl_float> &a, const Vec<anysl_float> &b,
                                const Vec<anysl_float> &c, const Vec<anysl_float> &d) {
  CornerAxes axes(plain(a), plain(b), plain(c), plain(d));
  return {each([](const anysl_float &x) { return anysl_float(0.25f) * x; }, (a + b) + (c + d)),
          {axes.center.x, axes.center.y, axes.center.z, axes.byU.x, axes.byU.y, axes.byU.z,
           axes.byV.x, axes.byV.y, axes.byV.z, 0, 0}};
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

inline TextureValues lookUpFlat(const anysl_context *context, uint32_t channels,
                                TextureFilter filterThere, const anysl_string *name,
                                ANYSL_TEXTURE_FIELDS) {
  scaleCoordinates(filterThere, plain(*swidth), plain(*twidth));
  filterThere.sblur = plain(*sblur), filterThere.tblur = plain(*tblur);
  return lookUp(context, textureQuery(flatTexture, channels),
                {name, filter, swrap, twrap, plain(*channel), plain(*fill), 0, 0}, filterThere);
}

inline FilteredPlace flatOver(const anysl_float &s1, const anysl_float &t1, const anysl_float &s2,
                              const anysl_float &t2, const anysl_float &s3, const anysl_float &t3,
                              const anysl_float &s4, const anysl_float &t4) {
  return filterOver({s1, t1, 0}, {s2, t2, 0}, {s3, t3, 0}, {s4, t4, 0});
}

} // namespace anysl

#define ANYSL_TEXTURE_NAMES name, channel, filter, swrap, twrap, fill, sblur, tblur, swidth, twidth

void anysl_texture_float(anysl_float *result, anysl_context *context, const anysl_string *name,
                         const anysl_float *s, const anysl_float *t, const anysl_float *du,
                         const anysl_float *dv, ANYSL_TEXTURE_FIELDS) {
  using namespace anysl;
  FilteredPlace at = filterAt({*s, *t, 0}, *du, *dv);
  *result = numberAt(lookUpFlat(context, 1, at.filter, ANYSL_TEXTURE_NAMES).r, at.place);
}

void anysl_texture_color(anysl_color *result, anysl_context *context, const anysl_string *name,
                         const anysl_float *s, const anysl_float *t, const anysl_float *du,
                         const anysl_float *dv, ANYSL_TEXTURE_FIELDS) {
  using namespace anysl;
  FilteredPlace at = filterAt({*s, *t, 0}, *du, *dv);
  *result = colorAt(lookUpFlat(context, 3, at.filter, ANYSL_TEXTURE_NAMES), at.place);
}

void anysl_texture_corners_float(anysl_float *result, anysl_context *context,
                                 const anysl_string *name, const anysl_float *s1,
                                 const anysl_float *t1, const anysl_float *s2,
                                 const anysl_float *t2, const anysl_float *s3,
                                 const anysl_float *t3, const anysl_float *s4,
                                 const anysl_float *t4, ANYSL_TEXTURE_FIELDS) {
  using namespace anysl;
  FilteredPlace at = flatOver(*s1, *t1, *s2, *t2, *s3, *t3, *s4, *t4);
  *result = numberAt(lookUpFlat(context, 1, at.filter, ANYSL_TEXTURE_NAMES).r, at.place);
}

void anysl_texture_corners_color(anysl_color *result, anysl_context *context,
                                 const anysl_string *name, const anysl_float *s1,
                                 const anysl_float *t1, const anysl_float *s2,
                                 const anysl_float *t2, const anysl_float *s3,
                                 const anysl_float *t3, const anysl_float *s4,
                                 const anysl_float *t4, ANYSL_TEXTURE_FIELDS) {
  using namespace anysl;
  FilteredPlace at = flatOver(*s1, *t1, *s2, *t2, *s3, *t3, *s4, *t4);
  *result = colorAt(lookUpFlat(context, 3, at.filter, ANYSL_TEXTURE_NAMES), at.place);
}

#undef ANYSL_TEXTURE_NAMES
#undef ANYSL_TEXTURE_FIELDS

//===-- Environments --------------------------------------------------------------------------===//

#define ANYSL_ENVIRONMENT_FIELDS                                                                   \
  const anysl_float *channel, const anysl_string *filter, const anysl_float *fill,                 \
      const anysl_float *sblur, const anysl_float *tblur, const anysl_float *swidth,               \
      const anysl_float *twidth

namespace anysl {

inline TextureValues lookUpEnvironment(const anysl_context *context, uint32_t channels,
                                       TextureFilter filterThere, const anysl_string *name,
                                       ANYSL_ENVIRONMENT_FIELDS) {
  scaleAxes(filterThere, plain(*swidth), plain(*twidth));
  filterThere.sblur = plain(*sblur), filterThere.tblur = plain(*tblur);
  anysl_string none = "";
  return lookUp(context, textureQuery(environmentTexture, channels),
                {name, filter, &none, &none, plain(*channel), plain(*fill), 0, 0}, filterThere);
}

} // namespace anysl

#define ANYSL_ENVIRONMENT_NAMES name, channel, filter, fill, sblur, tblur, swidth, twidth

void anysl_environment_float(anysl_float *result, anysl_context *context, const anysl_string *name,
                             const anysl_vector *R, const anysl_float *du, const anysl_float *dv,
                             ANYSL_ENVIRONMENT_FIELDS) {
  using namespace anysl;
  FilteredPlace at = filterAt(*R, *du, *dv);
  *result = numberAt(lookUpEnvironment(context, 1, at.filter, ANYSL_ENVIRONMENT_NAMES).r, at.place);
}

void anysl_environment_color(anysl_color *result, anysl_context *context, const anysl_string *name,
                             const anysl_vector *R, const anysl_float *du, const anysl_float *dv,
                             ANYSL_ENVIRONMENT_FIELDS) {
  using namespace anysl;
  FilteredPlace at = filterAt(*R, *du, *dv);
  *result = colorAt(lookUpEnvironment(context, 3, at.filter, ANYSL_ENVIRONMENT_NAMES), at.place);
}

void anysl_environment_corners_float(anysl_float *result, anysl_context *context,
                                     const anysl_string *name, const anysl_vector *R1,
                                     const anysl_vector *R2, const anysl_vector *R3,
                                     const anysl_vector *R4, ANYSL_ENVIRONMENT_FIELDS) {
  using namespace anysl;
  FilteredPlace at = filterOver(*R1, *R2, *R3, *R4);
  *result = numberAt(lookUpEnvironment(context, 1, at.filter, ANYSL_ENVIRONMENT_NAMES).r, at.place);
}

void anysl_environment_corners_color(anysl_color *result, anysl_context *context,
                                     const anysl_string *name, const anysl_vector *R1,
                                     const anysl_vector *R2, const anysl_vector *R3,
                                     const anysl_vector *R4, ANYSL_ENVIRONMENT_FIELDS) {
  using namespace anysl;
  FilteredPlace at = filterOver(*R1, *R2, *R3, *R4);
  *result = colorAt(lookUpEnvironment(context, 3, at.filter, ANYSL_ENVIRONMENT_NAMES), at.place);
}

#undef ANYSL_ENVIRONMENT_NAMES
#undef ANYSL_ENVIRONMENT_FIELDS

//===-- Shadow maps ---------------------------------------------------------------------------===//

#define ANYSL_SHADOW_FIELDS                                                                        \
  const anysl_float *bias, const anysl_float *samples, const anysl_float *sblur,                   \
      const anysl_float *tblur, const anysl_float *swidth, const anysl_float *twidth

namespace anysl {

inline anysl_float lookUpShadow(const anysl_context *context, TextureFilter filterThere,
                                const anysl_string *name, ANYSL_SHADOW_FIELDS) {
  scaleAxes(filterThere, plain(*swidth), plain(*twidth));
  filterThere.sblur = plain(*sblur), filterThere.tblur = plain(*tblur);
  anysl_string none = "";
  TextureOptions options = {name, &none, &none, &none, 0, 0, plain(*bias), plain(*samples)};
  return lookUp(context, textureQuery(shadowTexture, 1), options, filterThere).r.value;
}

} // namespace anysl

void anysl_shadow(anysl_float *result, anysl_context *context, const anysl_string *name,
                  const anysl_point *P, const anysl_float *du, const anysl_float *dv,
                  ANYSL_SHADOW_FIELDS) {
  using namespace anysl;
  *result = lookUpShadow(context, filterAt(*P, *du, *dv).filter, name, bias, samples, sblur, tblur,
                         swidth, twidth);
}

void anysl_shadow_corners(anysl_float *result, anysl_context *context, const anysl_string *name,
                          const anysl_point *P1, const anysl_point *P2, const anysl_point *P3,
                          const anysl_point *P4, ANYSL_SHADOW_FIELDS) {
  using namespace anysl;
  *result = lookUpShadow(context, filterOver(*P1, *P2, *P3, *P4).filter, name, bias, samples, sblur,
                         tblur, swidth, twidth);
}

#undef ANYSL_SHADOW_FIELDS

#endif // ANYSL_STANDARD_TEXTURE_H
