//===-- lib/Demand/ManifestLights.cpp - a manifest's lights -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Demand/ManifestLights.h"
#include "lib/Demand/ManifestShaders.h"

#include <algorithm>
#include <cmath>

using namespace anysl::render;

namespace anysl::demand {
namespace {

/// A value of a light in the manifest: where it lies in AnyslLight, and what says that it is known.
struct Field {
  const char *name;
  unsigned kinds; ///< bits 1 << AnyslLightKind that have it
  uint32_t known; ///< ANYSL_KNOWN_...
  size_t count;   ///< of its numbers
  float *(*find)(AnyslLight &);
};

constexpr unsigned bits(auto... kinds) { return ((1u << kinds) | ...); }
constexpr unsigned ambientBit = 1u << 31; // such lights have no kind
constexpr unsigned anyStandard = bits(ANYSL_LIGHT_DISTANT, ANYSL_LIGHT_POINT, ANYSL_LIGHT_SPOT);

const Field fields[] = {{"color", anyStandard | ambientBit, ANYSL_KNOWN_COLOR, 3,
                         [](AnyslLight &light) { return light.color; }},
                        {"from", bits(ANYSL_LIGHT_POINT, ANYSL_LIGHT_SPOT), ANYSL_KNOWN_FROM, 3,
                         [](AnyslLight &light) { return light.from; }},
                        {"direction", bits(ANYSL_LIGHT_DISTANT, ANYSL_LIGHT_SPOT),
                         ANYSL_KNOWN_DIRECTION, 3,
                         [](AnyslLight &light) { return light.direction; }},
                        {"cosOuter", bits(ANYSL_LIGHT_SPOT), ANYSL_KNOWN_CONE, 1,
                         [](AnyslLight &light) { return &light.cos_outer; }},
                        {"cosInner", bits(ANYSL_LIGHT_SPOT), ANYSL_KNOWN_CONE, 1,
                         [](AnyslLight &light) { return &light.cos_inner; }},
                        {"beam", bits(ANYSL_LIGHT_SPOT), ANYSL_KNOWN_BEAM, 1,
                         [](AnyslLight &light) { return &light.beam; }}};

struct Flag {
  const char *name;
  unsigned kinds;
  uint32_t bit; ///< ANYSL_LIGHT_...
};
const Flag flags[] = {{"shadows", anyStandard | bits(ANYSL_LIGHT_SHADER), ANYSL_LIGHT_CASTS_SHADOW},
                      {"nondiffuse", anyStandard, ANYSL_LIGHT_NONDIFFUSE},
                      {"nonspecular", anyStandard, ANYSL_LIGHT_NONSPECULAR}};

std::string readKind(const Json &object) {
  for (const Json::Member &member : object.members)
    if (member.key == "kind") {
      expect(member.value, Json::Text, member.key);
      return member.value.text;
    }
  throw UserError(object.where, "a light has no \"kind\"");
}

LightDemand readLight(const Json &object) {
  LightDemand light;
  light.kind = readKind(object);
  light.values.light.kind = standardKind(light.kind);
  const unsigned kind = light.kind == ambientLight ? ambientBit : 1u << light.values.light.kind;
  std::vector<Key> keys{{"kind", [](const Json &, const std::string &) {}}};
  for (const Flag &flag : flags)
    if (flag.kinds & kind)
      keys.push_back({flag.name, [&](const Json &value, const std::string &key) {
                        light.values.known_flags |= flag.bit;
                        light.values.light.flags |= readBool(value, key) ? flag.bit : 0;
                      }});
  if (kind != ambientBit)
    keys.push_back({"category", [&](const Json &value, const std::string &key) {
                      expect(value, Json::Text, key);
                      light.values.known |= ANYSL_KNOWN_CATEGORY;
                      light.category = value.text;
                    }});
  if (kind == 1u << ANYSL_LIGHT_SHADER)
    keys.push_back({"shader", [&](const Json &value, const std::string &key) {
                      light.parameters = readShader(value, key, /*complete=*/false);
                    }});
  unsigned cone = 0; // how much of it is given
  for (const Field &field : fields)
    if (field.kinds & kind)
      keys.push_back({field.name, [&](const Json &value, const std::string &key) {
                        std::vector<double> numbers;
                        if (field.count == 1) {
                          expect(value, Json::Number, key);
                          numbers = {value.number};
                        } else {
                          numbers = readNumbers(value, key);
                        }
                        if (numbers.size() != field.count)
                          throw UserError(value.where, "\"" + key + "\" has " +
                                                           std::to_string(field.count) +
                                                           " numbers");
                        light.values.known |= field.known;
                        cone += field.known == ANYSL_KNOWN_CONE;
                        std::copy(numbers.begin(), numbers.end(), field.find(light.values.light));
                      }});
  readMembers(object, "a light of kind \"" + light.kind + "\"", keys);
  if (cone == 1)
    throw UserError(object.where, "\"cosOuter\" and \"cosInner\" go together");
  return light;
}

} // namespace

uint32_t finiteFields(const AnyslLight &light) {
  uint32_t result = 0, infinite = 0;
  for (const Field &field : fields) {
    if (!(field.kinds >> light.kind & 1))
      continue;
    const float *numbers = field.find(const_cast<AnyslLight &>(light));
    bool isFinite =
        std::all_of(numbers, numbers + field.count, [](float x) { return std::isfinite(x); });
    (isFinite ? result : infinite) |= field.known;
  }
  return result & ~infinite;
}

void readLights(const Json &value, const std::string &key, Demand &demand) {
  expect(value, Json::Array, key);
  auto isObject = [](const Json &item) { return item.kind == Json::Object; };
  auto object = std::find_if(value.items.begin(), value.items.end(), isObject);
  if (object == value.items.end()) {
    demand.lights = readTexts(value, key);
    return;
  }
  auto other = std::find_if_not(value.items.begin(), value.items.end(), isObject);
  if (other != value.items.end())
    throw UserError(other->where, "\"lights\" are either names of kinds or objects, not both");
  std::vector<LightDemand> each;
  bool hasAmbient = false;
  std::optional sum = std::array<float, 3>{};
  for (const Json &item : value.items) {
    LightDemand light = readLight(item);
    if (light.kind != ambientLight) {
      each.push_back(std::move(light));
      continue;
    }
    hasAmbient = true;
    if (!(light.values.known & ANYSL_KNOWN_COLOR))
      sum.reset();
    for (size_t c = 0; sum && c < 3; ++c)
      (*sum)[c] += light.values.light.color[c];
  }
  demand.setLights(std::move(each), hasAmbient, sum);
}

void addShadows(const Json &manifest, Demand &demand) {
  if (!demand.eachLight)
    return;
  bool areKnown = true, casts = false;
  for (const LightDemand &light : *demand.eachLight) {
    areKnown &= (light.values.known_flags & ANYSL_LIGHT_CASTS_SHADOW) != 0;
    casts |= (light.values.light.flags & ANYSL_LIGHT_CASTS_SHADOW) != 0;
  }
  if (demand.shadows && !*demand.shadows && casts) {
    auto said = std::find_if(manifest.members.begin(), manifest.members.end(),
                             [](const Json::Member &member) { return member.key == "shadows"; });
    throw UserError(said->where, "\"shadows\" is false, and a light casts some");
  }
  if (!demand.shadows && (areKnown || casts))
    demand.shadows = casts;
}

std::string writeLights(const Demand &demand, bool places) {
  std::string result;
  auto numbersOf = [](const float *numbers, size_t count) {
    std::string text;
    for (size_t i = 0; i < count; ++i)
      text += (i ? ", " : "") + shortest(numbers[i]);
    return count == 1 ? text : "[" + text + "]";
  };
  auto add = [&](const std::string &kind, const std::string &values) {
    result += (result.empty() ? "" : ", ") + ("{\"kind\": " + quoted(kind)) + values + "}";
  };
  for (LightDemand light : *demand.eachLight) {
    std::string values;
    auto key = [&](const char *name) { values += ", " + quoted(name) + ": "; };
    for (const Flag &flag : flags)
      if (light.values.known_flags & flag.bit) {
        key(flag.name);
        values += light.values.light.flags & flag.bit ? "true" : "false";
      }
    for (const Field &field : fields) {
      if (!(light.values.known & field.known))
        continue;
      key(field.name);
      values += numbersOf(field.find(light.values.light), field.count);
    }
    if (light.values.known & ANYSL_KNOWN_CATEGORY) {
      key("category");
      values += quoted(light.category);
    }
    if (light.parameters.complete || !light.parameters.parameters.empty()) {
      key("shader");
      values += writeShader(light.parameters, places);
    }
    add(light.kind, values);
  }
  if (demand.lights &&
      std::find(demand.lights->begin(), demand.lights->end(), ambientLight) != demand.lights->end())
    add(std::string(ambientLight),
        demand.ambient ? ", \"color\": " + numbersOf(demand.ambient->data(), 3) : "");
  return "[" + result + "]";
}

} // namespace anysl::demand
