//===-- tools/anysl-render/Lights.cpp - the standard lights and the sky -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Lights.h"

#include "StandardLights.h"
#include "tools/anysl-render/AreaLights.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

namespace demand = anysl::demand;
namespace stc = anysl::stc;
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
  const char *category = nullptr;
};

} // namespace

bool anysl::render::isStandardLight(const std::string &name, const ShaderCache &cache) {
  for (const auto &[standardName, source] : standardLights) {
    if (name != standardName)
      continue;
    std::optional<std::filesystem::path> file = cache.find(name);
    if (!file)
      return true;
    std::ifstream stream(*file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {}) == source;
  }
  return false;
}

std::string anysl::render::kindOfShader(const std::string &light) {
  bool isTaken = light == demand::ambientLight || demand::standardKind(light) != ANYSL_LIGHT_SHADER;
  return isTaken ? light + " of the scene's own" : light;
}

namespace {

LightValues readValues(const LightUse &light, Warnings &warnings) {
  LightValues values;
  const std::pair<const char *, double *> floats[] = {
      {"intensity", &values.intensity},           {"coneangle", &values.coneAngle},
      {"conedeltaangle", &values.coneDeltaAngle}, {"beamdistribution", &values.beamDistribution},
      {"__nondiffuse", &values.nonDiffuse},       {"__nonspecular", &values.nonSpecular}};
  const std::pair<const char *, Vec3d *> triples[] = {
      {"lightcolor", &values.color}, {"from", &values.from}, {"to", &values.to}};
  for (const Parameter &parameter : light.parameters) {
    if (parameter.name == "__category" && parameter.strings.size() == 1) {
      values.category = parameter.strings[0].c_str();
      continue;
    }
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

SceneLights::SceneLights(const SceneDescription &scene, const ShaderCache &cache,
                         Warnings &warnings)
    : scene(scene) {
  useOf.resize(scene.lights.size());
  standard.resize(scene.lights.size());
  samples.resize(scene.lights.size());
  const Camera camera(scene.camera);
  for (uint32_t index : demand::usedLights(scene)) {
    const LightUse &light = scene.lights[index];
    for (uint32_t number : light.shapes) {
      const Shape &shape = scene.shapes[number];
      auto its = areaSamples(shape, scene.appearances[shape.appearance], camera);
      samples[index].insert(samples[index].end(), its.begin(), its.end());
    }
    standard[index] = isStandardLight(light.name, cache);
    if (standard[index])
      continue;
    if (!cache.find(light.name)) {
      warnings.warn(light.where,
                    "light shader \"" + light.name + "\" is not found; the light is left out");
      continue;
    }
    uses.push_back(useShader(index));
  }
}

const ShaderUse *SceneLights::useShader(uint32_t index) {
  const LightUse &light = scene.lights[index];
  useOf[index] = std::make_unique<ShaderUse>(
      ShaderUse{ShaderKind::Light, light.name, light.parameters, light.lightToCamera, light.where});
  return useOf[index].get();
}

std::vector<const ShaderUse *> SceneLights::runStandard(const ShaderCache &cache) {
  std::vector<const ShaderUse *> added;
  for (uint32_t index = 0; index < standard.size(); ++index) {
    // The standard's shaders shine from where their parameters say, those of areas from all over.
    if (!standard[index] || !scene.lights[index].shapes.empty() ||
        !cache.find(scene.lights[index].name))
      continue;
    added.push_back(useShader(index));
  }
  return added;
}

namespace {

/// What a scene says of a light shader's parameters.
demand::ShaderDemand parametersOf(const ShaderUse &light) {
  demand::Demand demand;
  const ShaderUse *const uses[] = {&light};
  demand::addShader(demand, {}, uses);
  return std::move(demand.shaders.begin()->second);
}

/// What is known of a light before its shader, if it is one, is loaded.
demand::LightDemand demandFor(const LightUse &use, const AnyslLight &light) {
  demand::LightDemand result;
  result.values.light.kind = light.kind;
  if (light.kind == ANYSL_LIGHT_SHADER) {
    result.kind = kindOfShader(use.name);
    result.values.known_flags = demand::shadowsKnownOf(use);
    return result;
  }
  result.kind = demand::sourceOf(light.kind);
  result.values.light = light;
  result.category = light.category ? light.category : "";
  // What is the set's.
  result.values.light.shader = nullptr;
  result.values.light.category = result.values.light.handle = nullptr;
  result.values.known_flags =
      ANYSL_LIGHT_CASTS_SHADOW | ANYSL_LIGHT_NONDIFFUSE | ANYSL_LIGHT_NONSPECULAR;
  result.values.known = demand::finiteFields(light) | ANYSL_KNOWN_CATEGORY;
  return result;
}

} // namespace

void SceneLights::load(ShaderLoader &loader, const AnyslServices &services) {
  shaderOf.resize(useOf.size());
  for (size_t i = 0; i < useOf.size(); ++i)
    if (useOf[i])
      shaderOf[i] = loader.make(*useOf[i], services);
}

SceneLights::Known SceneLights::known(const std::vector<uint32_t> &indices) const {
  LightSet set;
  Known result;
  Warnings none(nullptr); // set() gives them
  for (uint32_t index : indices) {
    const LightUse &use = scene.lights[index];
    const size_t first = set.lights.size();
    if (standard[index]) {
      result.hasAmbient |= use.name == demand::ambientLight;
      addStandard(use, set, none);
    } else if (useOf[index]) {
      result.hasShaders = true;
      AnyslLight light = {};
      light.kind = ANYSL_LIGHT_SHADER;
      spread(use, light, set);
    }
    for (size_t i = first; i < set.lights.size(); ++i)
      result.each.push_back(demandFor(use, set.lights[i]));
    for (size_t i = first; useOf[index] && i < set.lights.size(); ++i)
      result.each[i].parameters = parametersOf(*useOf[index]);
  }
  if (std::all_of(set.ambient, set.ambient + 3, [](float x) { return std::isfinite(x); }))
    result.ambient = std::to_array(set.ambient);
  return result;
}

LightSet SceneLights::set(const std::vector<uint32_t> &indices, Warnings &warnings) const {
  LightSet set;
  for (uint32_t index : indices)
    if (shaderOf[index])
      addShader(scene.lights[index], *shaderOf[index], set);
    else if (standard[index])
      addStandard(scene.lights[index], set, warnings);
  set.globals = anysl_lights_globals(set.lights.data(), uint32_t(set.lights.size()));
  return set;
}

void SceneLights::addShader(const LightUse &use, const Shader &shader, LightSet &set) const {
  AnyslLight light;
  if (anysl_light_from_instance(shader.instance.get(), &light))
    throw UserError(use.where, anysl_last_error());
  // A shader that looks for shadows itself must not have them twice.
  if (use.castsShadow && !stc::has(shader.source.effects, stc::Effect::Shadows))
    light.flags |= ANYSL_LIGHT_CASTS_SHADOW;
  light.handle = use.handle.c_str();
  spread(use, light, set);
  set.hasShaders = true;
}

/// A standard light as one of its samples has it: there, as bright as it is large.
static AnyslStandardLight moved(AnyslStandardLight values, const AreaSample &sample, double area) {
  for (int k = 0; k < 3; ++k) {
    float from = values.from[k];
    values.from[k] = float(sample.P[k]);
    values.to[k] += values.from[k] - from;
  }
  values.share = float(sample.area / area);
  return values;
}

void SceneLights::keepValues(AnyslLight &light, AnyslStandardLight values, LightSet &set) {
  set.standards.push_back(std::make_shared<const AnyslStandardLight>(values));
  light.shader = set.standards.back().get();
}

void SceneLights::spread(const LightUse &use, const AnyslLight &light, LightSet &set) const {
  const std::vector<AreaSample> &samples = this->samples[size_t(&use - scene.lights.data())];
  double area = 0;
  for (const AreaSample &sample : samples)
    area += sample.area;
  bool isShader = light.kind == ANYSL_LIGHT_SHADER;
  AnyslStandardLight values = {};
  if (!isShader)
    values = *static_cast<const AnyslStandardLight *>(light.shader);
  if (samples.empty())
    set.lights.push_back(light);
  for (const AreaSample &sample : samples) {
    AnyslLight &part = set.lights.emplace_back(light);
    if (&sample != samples.data())
      part.handle = nullptr; // one light, whatever it is sampled by
    store(part.from, sample.P);
    if (isShader)
      store(part.direction, sample.N);
    else
      keepValues(part, moved(values, sample, area), set);
    for (float &channel : part.color)
      channel *= float(sample.area / area);
  }
}

void SceneLights::addStandard(const LightUse &use, LightSet &set, Warnings &warnings) const {
  LightValues values = readValues(use, warnings);
  Vec3d color = values.color * values.intensity;
  if (use.name == demand::ambientLight) {
    for (int i = 0; i < 3; ++i)
      set.ambient[i] += float(color[i]);
    return;
  }
  AnyslLight light = {};
  light.kind = demand::standardKind(use.name);
  light.flags = (use.castsShadow ? ANYSL_LIGHT_CASTS_SHADOW : 0) |
                (values.nonDiffuse != 0 ? ANYSL_LIGHT_NONDIFFUSE : 0) |
                (values.nonSpecular != 0 ? ANYSL_LIGHT_NONSPECULAR : 0);
  light.category = values.category;
  Vec3d from = use.lightToCamera.point(values.from), to = use.lightToCamera.point(values.to);
  Vec3d direction = normalized(to - from);
  if (light.kind != ANYSL_LIGHT_POINT && direction == Vec3d())
    throw UserError(use.where, use.name + ": \"from\" and \"to\" are the same point");
  store(light.color, color);
  store(light.from, from);
  store(light.direction, direction);
  light.cos_outer = float(std::cos(values.coneAngle));
  light.cos_inner = float(std::cos(std::max(0.0, values.coneAngle - values.coneDeltaAngle)));
  light.beam = float(values.beamDistribution);
  light.handle = use.handle.c_str();
  AnyslStandardLight kept;
  anysl_standard_light_defaults(&kept);
  kept.intensity = float(values.intensity);
  store(kept.color, values.color);
  store(kept.from, from);
  store(kept.to, to);
  kept.cone_angle = float(values.coneAngle);
  kept.cone_delta_angle = float(values.coneDeltaAngle);
  kept.beam_distribution = float(values.beamDistribution);
  keepValues(light, kept, set);
  spread(use, light, set);
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
