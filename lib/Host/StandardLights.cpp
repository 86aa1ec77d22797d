//===-- lib/Host/StandardLights.cpp - lights of the standard kinds ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Such lights are evaluated where shaders ask for them (<anysl/standard/lights.h>). Here is what
// only comes up where a surface asks for a light's parameters or sends it values: they are those of
// the shaders of their names, if the renderer has kept them (AnyslLight::shader).
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include "lib/Host/Message.h"
#include <cmath>
#include <string_view>

using namespace anysl::host;

namespace {

/// A parameter of a standard light: where it lies, and the kinds that have it, as bits 1 << kind.
struct Place {
  std::string_view name;
  uint32_t type; ///< AnyslType
  uint32_t kinds;
  float *(*of)(AnyslStandardLight &);
};

constexpr uint32_t distant = 1u << ANYSL_LIGHT_DISTANT, point = 1u << ANYSL_LIGHT_POINT,
                   spot = 1u << ANYSL_LIGHT_SPOT;

constexpr Place places[] = {
    {"intensity", ANYSL_FLOAT, distant | point | spot,
     [](AnyslStandardLight &v) { return &v.intensity; }},
    {"lightcolor", ANYSL_COLOR, distant | point | spot,
     [](AnyslStandardLight &v) { return v.color; }},
    {"from", ANYSL_POINT, distant | point | spot, [](AnyslStandardLight &v) { return v.from; }},
    {"to", ANYSL_POINT, distant | spot, [](AnyslStandardLight &v) { return v.to; }},
    {"coneangle", ANYSL_FLOAT, spot, [](AnyslStandardLight &v) { return &v.cone_angle; }},
    {"conedeltaangle", ANYSL_FLOAT, spot,
     [](AnyslStandardLight &v) { return &v.cone_delta_angle; }},
    {"beamdistribution", ANYSL_FLOAT, spot,
     [](AnyslStandardLight &v) { return &v.beam_distribution; }}};

const Place *placeOf(std::string_view name, const AnyslLight &light) {
  for (const Place &place : places)
    if (place.name == name && place.kinds >> light.kind & 1)
      return &place;
  return nullptr;
}

/// The light's parameters, with what is sent in place of its own.
AnyslStandardLight valuesOf(const AnyslLight &light, const AnyslMessage *sent) {
  auto values = *static_cast<const AnyslStandardLight *>(light.shader);
  if (!sent)
    return values;
  for (const ValuePlace &value : placesOf(*sent)) {
    const Place *place = placeOf(value.name, light);
    if (!place || value.shape.isArray)
      continue;
    AnyslCell given[16], cells[3];
    readElement(*sent, value, 0, given);
    AnyslQuery variable = {};
    variable.type = place->type;
    if (anysl_answer(&variable, value.shape.type(), 0, given, cells))
      for (uint32_t c = 0; c < anysl_type_components(place->type); ++c)
        place->of(values)[c] = float(cells[c].number);
  }
  return values;
}

double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

} // namespace

int anysl::host::standardLightValue(const AnyslLight &light, const AnyslQuery &query,
                                    AnyslCell *value, const AnyslMessage *sent) {
  std::string_view name = query.name;
  uint32_t flag = name == "__nondiffuse"    ? ANYSL_LIGHT_NONDIFFUSE
                  : name == "__nonspecular" ? ANYSL_LIGHT_NONSPECULAR
                                            : 0;
  AnyslCell cells[3] = {};
  uint32_t type = ANYSL_FLOAT;
  const Place *place = placeOf(name, light);
  if (flag) {
    cells[0].number = (light.flags & flag) != 0;
  } else if (name == "__category") {
    type = ANYSL_STRING;
    cells[0].string = light.category ? light.category : "";
  } else if (place && light.shader) {
    AnyslStandardLight values = valuesOf(light, sent);
    type = place->type;
    for (uint32_t c = 0; c < anysl_type_components(type); ++c)
      cells[c].number = double(place->of(values)[c]);
  } else if (name == "from" && light.kind != ANYSL_LIGHT_DISTANT) {
    type = ANYSL_POINT;
    for (int c = 0; c < 3; ++c)
      cells[c].number = double(light.from[c]);
  } else {
    return 0;
  }
  return anysl_answer(&query, type, 0, cells, value);
}

/// The formulas of <anysl/standard/lights.h>, in double, at one point.
void anysl::host::sampleStandardSent(const AnyslLight &light, const double *P,
                                     const AnyslMessage &sent, double *result) {
  AnyslLight other;
  AnyslStandardLight values = valuesOf(light, &sent);
  if (anysl_light_standard(light.kind, &values, &other))
    return; // it shines from a point to that same point: not at all
  double L[3], axis[3];
  for (int c = 0; c < 3; ++c) {
    axis[c] = double(other.direction[c]);
    L[c] = light.kind == ANYSL_LIGHT_DISTANT ? -axis[c] : double(other.from[c]) - P[c];
  }
  double strength = 1, squares = dot(L, L);
  if (light.kind != ANYSL_LIGHT_DISTANT)
    strength = squares > 0 ? 1 / squares : 0;
  if (light.kind == ANYSL_LIGHT_SPOT) {
    double outer = double(other.cos_outer), inner = double(other.cos_inner);
    double cosine = squares > 0 ? -dot(L, axis) / std::sqrt(squares) : 0;
    if (!(cosine > outer))
      return;
    double t = cosine < inner ? (cosine - outer) / (inner - outer) : 1;
    strength *= std::pow(cosine, double(other.beam)) * t * t * (3 - 2 * t);
  }
  for (int c = 0; c < 3; ++c) {
    result[c] = L[c];
    result[3 + c] = double(other.color[c]) * strength;
  }
}
