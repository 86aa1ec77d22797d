//===-- tools/anysl-render/Lights.cpp - the standard lights and the sky -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Lights.h"

#include <algorithm>
#include <numbers>

using namespace anysl::render;

namespace {

/// A light's parameters with the standard's defaults.
struct LightValues {
  double intensity = 1;
  Vec3d color{1, 1, 1};
  Vec3d from{0, 0, 0}, to{0, 0, 1};
  double coneAngle = 30 * (std::numbers::pi / 180);
  double coneDeltaAngle = 5 * (std::numbers::pi / 180);
  double beamDistribution = 2;
  double nonDiffuse = 0, nonSpecular = 0;
};

LightValues readValues(const LightUse &light, Warnings &warnings) {
  LightValues values;
  const std::pair<const char *, double *> floats[] = {
      {"intensity", &values.intensity},           {"coneangle", &values.coneAngle},
      {"conedeltaangle", &values.coneDeltaAngle}, {"beamdistribution", &values.beamDistribution},
      {"__nondiffuse", &values.nonDiffuse},       {"__nonspecular", &values.nonSpecular}};
  const std::pair<const char *, Vec3d *> triples[] = {
      {"lightcolor", &values.color}, {"from", &values.from}, {"to", &values.to}};
  for (const Parameter &parameter : light.parameters) {
    size_t wanted = 0;
    for (auto [name, target] : floats)
      if (parameter.name == name) {
        wanted = 1;
        if (parameter.numbers.size() == 1)
          *target = parameter.numbers[0];
      }
    for (auto [name, target] : triples)
      if (parameter.name == name) {
        wanted = 3;
        if (parameter.numbers.size() == 3)
          *target = {parameter.numbers[0], parameter.numbers[1], parameter.numbers[2]};
      }
    if (wanted == 0)
      warnings.warn(parameter.where, light.name + " has no parameter \"" + parameter.name + "\"");
    else if (parameter.numbers.size() != wanted)
      throw UserError(parameter.where, "\"" + parameter.name + "\" needs " +
                                           std::to_string(wanted) +
                                           (wanted == 1 ? " number" : " numbers"));
  }
  return values;
}

void store(float *target, Vec3d value) {
  for (int i = 0; i < 3; ++i)
    target[i] = float(value[i]);
}

} // namespace

LightSet anysl::render::makeLightSet(const SceneDescription &scene,
                                     const std::vector<uint32_t> &indices, Warnings &warnings) {
  LightSet set;
  for (uint32_t index : indices) {
    const LightUse &use = scene.lights[index];
    bool distant = use.name == "distantlight", point = use.name == "pointlight";
    bool ambient = use.name == "ambientlight";
    if (!distant && !point && !ambient && use.name != "spotlight") {
      warnings.warn(use.where, "light \"" + use.name +
                                   "\" is none of ambientlight, distantlight, pointlight and "
                                   "spotlight; it is left out");
      continue;
    }
    LightValues values = readValues(use, warnings);
    Vec3d color = values.color * values.intensity;
    if (ambient) {
      for (int i = 0; i < 3; ++i)
        set.ambient[i] += float(color[i]);
      continue;
    }
    AnyslLight light = {};
    light.kind = distant ? ANYSL_LIGHT_DISTANT : point ? ANYSL_LIGHT_POINT : ANYSL_LIGHT_SPOT;
    light.flags = (use.castsShadow ? ANYSL_LIGHT_CASTS_SHADOW : 0) |
                  (values.nonDiffuse != 0 ? ANYSL_LIGHT_NONDIFFUSE : 0) |
                  (values.nonSpecular != 0 ? ANYSL_LIGHT_NONSPECULAR : 0);
    Vec3d from = use.lightToCamera.point(values.from), to = use.lightToCamera.point(values.to);
    Vec3d direction = normalized(to - from);
    if (!point && direction == Vec3d())
      throw UserError(use.where, use.name + ": \"from\" and \"to\" are the same point");
    store(light.color, color);
    store(light.from, from);
    store(light.direction, direction);
    light.cos_outer = float(std::cos(values.coneAngle));
    light.cos_inner = float(std::cos(std::max(0.0, values.coneAngle - values.coneDeltaAngle)));
    light.beam = float(values.beamDistribution);
    set.lights.push_back(light);
  }
  return set;
}

Background::Background(const SceneDescription &scene)
    : visible(scene.background.visible), up(normalized(scene.worldToCamera.vector({0, 1, 0}))),
      zenith(scene.background.zenith), horizon(scene.background.horizon),
      ground(scene.background.ground) {}

Vec3f Background::color(Vec3f direction) const {
  if (!visible)
    return Vec3f();
  // Most of the change lies near the horizon, as it does outdoors.
  float height = std::clamp(dot(direction, up), -1.0f, 1.0f);
  float share = std::sqrt(std::fabs(height));
  return lerp(horizon, height >= 0 ? zenith : ground,
              height >= 0 ? share : std::min(1.0f, 3 * share));
}
