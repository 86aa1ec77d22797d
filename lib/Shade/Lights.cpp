//===-- lib/Shade/Lights.cpp - the lights of the command line ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Lights.h"
#include <algorithm>
#include <anysl/demand.h>

namespace anysl::shade {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

[[noreturn]] void fail(const std::string &message) { throw UserError(message); }

uint32_t flagNamed(const std::string &name) {
  return name == "shadow"        ? ANYSL_LIGHT_CASTS_SHADOW
         : name == "nondiffuse"  ? ANYSL_LIGHT_NONDIFFUSE
         : name == "nonspecular" ? ANYSL_LIGHT_NONSPECULAR
                                 : 0;
}

/// A light of a standard kind as it is described.
struct StandardText {
  std::string kind;
  uint32_t number = 0; ///< AnyslLightKind; 0: ambient
  AnyslStandardLight values;
  std::vector<double> direction;
  std::string category, handle;
  uint32_t flags = 0;
};

/// The kinds by both of their names; those that end in "light" have the standard's parameters.
uint32_t kindNamed(const std::string &name, bool &known, bool &standardNames) {
  struct Kind {
    uint32_t number;
    const char *word, *source;
  } const kinds[] = {
      {0, "ambient", "ambientlight"},
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence) {id, word, source},
#include <anysl/LightKinds.def>
  };
  for (const Kind &kind : kinds) {
    standardNames = name == kind.source;
    if ((known = standardNames || name == kind.word))
      return kind.number;
  }
  return 0;
}

void readKey(StandardText &light, const std::string &part, bool standardNames) {
  if (uint32_t flag = flagNamed(part)) {
    light.flags |= flag;
    return;
  }
  auto [key, value] = parseAssignment(part, "--light");
  if (key == "category" || key == "__category") {
    light.category = value;
    return;
  }
  if (key == "handle") {
    light.handle = value;
    return;
  }
  std::vector<double> numbers = parseNumbers(value, "--light");
  bool positioned = light.number >= ANYSL_LIGHT_POINT, aimed = light.number != ANYSL_LIGHT_POINT;
  bool spot = light.number == ANYSL_LIGHT_SPOT, ambient = light.number == 0;
  AnyslStandardLight &v = light.values;
  if (key == "direction" && !standardNames && aimed && !ambient) {
    if (numbers.size() != 3)
      fail("'direction' of --light wants 3 numbers");
    light.direction = numbers;
    return;
  }
  struct Key {
    const char *name, *standardName;
    float *target;
    size_t count;
    double scale;
    bool allowed;
  } const keys[] = {
      {"color", "lightcolor", v.color, 3, 1, true},
      {"intensity", "intensity", &v.intensity, 1, 1, true},
      {"from", "from", v.from, 3, 1, positioned || (standardNames && !ambient)},
      {"to", "to", v.to, 3, 1, spot || (standardNames && aimed && !ambient)},
      {"cone", "coneangle", &v.cone_angle, 1, standardNames ? 1 : degree, spot},
      {"delta", "conedeltaangle", &v.cone_delta_angle, 1, standardNames ? 1 : degree, spot},
      {"beam", "beamdistribution", &v.beam_distribution, 1, 1, spot}};
  for (const Key &known : keys) {
    if (key != (standardNames ? known.standardName : known.name) || !known.allowed)
      continue;
    if (numbers.size() != known.count)
      fail("'" + key + "' of --light wants " + (known.count == 3 ? "3 numbers" : "1 number"));
    for (size_t i = 0; i < known.count; ++i)
      known.target[i] = float(numbers[i] * known.scale);
    if (key == "to")
      light.direction.clear();
    return;
  }
  fail("--light " + light.kind + " has no '" + key + "'");
}

} // namespace

Lights::Lights(const std::vector<std::string> &descriptions, const AnyslServices &services,
               const Environment &world) {
  for (const std::string &description : descriptions)
    add(description, services, world);
}

void Lights::add(const RecordedShader &recording) {
  for (const RecordedShader::Light &recorded : recording.lights) {
    AnyslLight &light = lights.emplace_back(recorded.values);
    light.category = recorded.category.empty() ? nullptr : recorded.category.c_str();
  }
  for (int c = 0; c < 3; ++c)
    ambient[c] += recording.ambient[c];
}

uint64_t Lights::globals() const {
  return anysl_lights_globals(lights.data(), uint32_t(lights.size()));
}

void Lights::checkAllowed(const AnyslLibrary *library,
                          const std::vector<std::string> &results) const {
  AnyslSceneFacts facts = {};
  facts.struct_size = sizeof facts;
  auto note = [&](bool has, AnyslAssumption absence) { facts.has |= uint32_t(has) << absence; };
  note(ambient[0] != 0 || ambient[1] != 0 || ambient[2] != 0, ANYSL_ASSUMES_NO_AMBIENT);
  for (const AnyslLight &light : lights) {
    note(true, ANYSL_ASSUMES_NO_LIGHTS);
    note(light.flags & ANYSL_LIGHT_AMBIENT, ANYSL_ASSUMES_NO_AMBIENT);
    note(light.flags & ANYSL_LIGHT_CASTS_SHADOW, ANYSL_ASSUMES_NO_SHADOWS);
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence)                                      \
  note(light.kind == id, ANYSL_ASSUMES_##absence);
#include <anysl/LightKinds.def>
    note(light.kind == ANYSL_LIGHT_SHADER, ANYSL_ASSUMES_NO_LIGHT_SHADERS);
  }
  facts.lights = lights.data();
  facts.light_count = uint32_t(lights.size());
  std::copy_n(ambient, 3, facts.ambient);
  std::vector<const char *> outputs;
  for (const std::string &result : results)
    outputs.push_back(result.c_str());
  outputs.push_back(nullptr);
  if (const AnyslDemandInfo *demand = anysl_library_demand(library))
    facts.time = demand->time;
  facts.outputs = outputs.data();
  check(anysl_library_allows(library, &facts));
}

void Lights::shineOn(AnyslBatch *batch) const {
  anysl_batch_set_lights(batch, lights.data(), uint32_t(lights.size()), ambient);
}

void Lights::add(const std::string &description, const AnyslServices &services,
                 const Environment &world) {
  std::vector<std::string> parts = split(description, ':');
  bool isFile = parts[0].find('/') != std::string::npos ||
                (parts[0].size() > 3 && parts[0].compare(parts[0].size() - 3, 3, ".so") == 0);
  if (isFile)
    addShader(parts, services, world);
  else
    addStandard(parts);
}

void Lights::addStandard(const std::vector<std::string> &parts) {
  StandardText text;
  text.kind = parts[0];
  bool known, standardNames;
  text.number = kindNamed(parts[0], known, standardNames);
  if (!known)
    fail("--light is ambient, distant, point, spot or a shader library, not '" + parts[0] + "'");
  anysl_standard_light_defaults(&text.values);
  if (!standardNames) {
    text.values.from[2] = 1;
    text.direction = {0, 0, -1};
  }
  for (size_t i = 1; i < parts.size(); ++i)
    readKey(text, parts[i], standardNames);
  const AnyslStandardLight &values = text.values;
  if (!text.number) {
    for (int c = 0; c < 3; ++c)
      ambient[c] += values.color[c] * values.intensity;
    return;
  }
  // A direction that is given by itself does not go through a position's rounding.
  AnyslStandardLight aimed = values;
  const std::vector<double> &d = text.direction;
  for (size_t c = 0; c < d.size(); ++c) {
    aimed.from[c] = 0;
    aimed.to[c] = float(d[c]);
  }
  AnyslLight light;
  if (anysl_light_standard(text.number, &aimed, &light))
    fail("the direction of --light " + text.kind + " is zero");
  std::copy_n(values.from, 3, light.from);
  AnyslStandardLight &kept = standards.emplace_back(values);
  for (size_t c = 0; c < d.size(); ++c)
    kept.to[c] = values.from[c] + float(d[c]);
  light.shader = &kept;
  light.flags = text.flags;
  if (!text.category.empty())
    light.category = categories.emplace_back(text.category).c_str();
  addLight(light, text.handle);
}

/// A light without a name of its own is called "light" and its number.
void Lights::addLight(AnyslLight light, const std::string &handle) {
  handles.push_back(handle.empty() ? "light" + std::to_string(lights.size()) : handle);
  light.handle = handles.back().c_str();
  lights.push_back(light);
}

void Lights::addShader(const std::vector<std::string> &parts, const AnyslServices &services,
                       const Environment &world) {
  Environment &environment = environments.emplace_back(world);
  std::vector<ParamText> params;
  std::optional<std::string> shader;
  std::string handle;
  uint32_t flags = 0;
  for (size_t i = 1; i < parts.size(); ++i) {
    if (uint32_t flag = flagNamed(parts[i])) {
      flags |= flag;
    } else if (parts[i].find('=') == std::string::npos && i == 1) {
      shader = parts[i];
    } else {
      auto [name, value] = parseAssignment(parts[i], "--light");
      if (name == "handle")
        handle = value;
      else if (name == "space")
        environment.toCurrent["shader"] = parseMatrix(value, "space of --light");
      else
        params.push_back({name, value});
    }
  }
  LibraryHandle &library = libraries.emplace_back(openLibrary(parts[0]));
  InstanceHandle &instance = instances.emplace_back(
      makeInstance(library.get(), shader ? &*shader : nullptr, services, environment));
  for (const ParamText &param : params)
    setParam(instance.get(), param, "--light");
  AnyslLight light;
  check(anysl_light_from_instance(instance.get(), &light));
  light.flags |= flags;
  addLight(light, handle);
}

} // namespace anysl::shade
