//===-- lib/Demand/Manifest.cpp - a demand as JSON --------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Demand/Demand.h"
#include "lib/Demand/ManifestLights.h"
#include "lib/Demand/ManifestShaders.h"

#include <algorithm>
#include <cmath>

using namespace anysl::render;

namespace anysl::demand {
namespace {

/// A manifest that says all there is to say: what it leaves out is not called for.
void complete(Demand &demand) {
  auto fill = [](auto &member, auto value) {
    if (!member)
      member = std::move(value);
  };
  const std::vector<std::string> none;
  fill(demand.outputs, std::vector<std::string>{"Ci", "Oi"});
  fill(demand.asked, none);
  fill(demand.lights, none);
  fill(demand.textures, none);
  fill(demand.shadows, false);
  fill(demand.othersTrace, false);
  fill(demand.rayDepth, 0u);
  fill(demand.displacement, false);
  fill(demand.atmosphere, false);
  fill(demand.imager, false);
  fill(demand.lens, false);
  fill(demand.shutter, std::array<double, 2>{0, 0});
}

} // namespace

Demand readManifest(const std::shared_ptr<const SourceFile> &file) {
  Json json = parseJson(file);
  expect(json, Json::Object, "the manifest");
  Demand result;
  // How the rest is read depends on this.
  bool isComplete = false;
  for (const Json::Member &member : json.members)
    if (member.key == "complete")
      isComplete = readBool(member.value, member.key);
  auto texts = [](std::optional<std::vector<std::string>> &target) {
    return [&target](const Json &value, const std::string &key) { target = readTexts(value, key); };
  };
  auto truth = [](std::optional<bool> &target) {
    return [&target](const Json &value, const std::string &key) { target = readBool(value, key); };
  };
  const Key keys[] = {
      {"complete", [](const Json &, const std::string &) {}},
      {"shaders",
       [&](const Json &value, const std::string &key) {
         expect(value, Json::Object, key);
         for (const Json::Member &member : value.members)
           result.shaders[member.key] = readShader(member.value, member.key, isComplete);
       }},
      {"globals",
       [&](const Json &value, const std::string &key) {
         expect(value, Json::Object, key);
         auto set = [&](const Json &given, const std::string &name) {
           std::vector<double> numbers{given.number};
           if (given.kind != Json::Number)
             numbers = readNumbers(given, name);
           if (numbers.size() == 1)
             numbers.assign(3, numbers[0]);
           if (numbers.size() != 3)
             throw UserError(given.where, "\"" + name + "\" has 3 numbers");
           std::copy_n(numbers.begin(), 3, result.globals[name].begin());
         };
         const Key globals[] = {{"Cs", set}, {"Os", set}};
         readMembers(value, "\"" + key + "\"", globals);
       }},
      {"outputs", texts(result.outputs)},
      {"asked", texts(result.asked)},
      {"lights",
       [&](const Json &value, const std::string &key) { readLights(value, key, result); }},
      {"shadows", truth(result.shadows)},
      {"othersTrace", truth(result.othersTrace)},
      {"rayDepth",
       [&](const Json &value, const std::string &key) {
         expect(value, Json::Number, key);
         if (!(value.number >= 0) || value.number > 1e6 || value.number != std::floor(value.number))
           throw UserError(value.where, "\"rayDepth\" is a whole number from 0 on");
         result.rayDepth = unsigned(value.number);
       }},
      {"textures", texts(result.textures)},
      {"displacement", truth(result.displacement)},
      {"atmosphere", truth(result.atmosphere)},
      {"imager", truth(result.imager)},
      {"lens", truth(result.lens)},
      {"shutter", [&](const Json &value, const std::string &key) {
         expect(value, Json::Array, key);
         if (value.items.size() != 2)
           throw UserError(value.where, "\"shutter\" is two times, when it opens and closes");
         for (const Json &item : value.items)
           expect(item, Json::Number, "shutter[]");
         result.shutter = {value.items[0].number, value.items[1].number};
       }}};
  readMembers(json, "a manifest", keys);
  addShadows(json, result);
  if (isComplete)
    complete(result);
  return result;
}

std::string writeManifest(const Demand &demand, bool places) {
  std::string result = "{";
  auto key = [&](const char *name) {
    result += (result.size() > 1 ? ", " : "") + quoted(name) + ": ";
  };
  auto texts = [&](const char *name, const std::optional<std::vector<std::string>> &list) {
    if (!list)
      return;
    key(name);
    std::string items;
    for (const std::string &item : *list)
      items += (items.empty() ? "" : ", ") + quoted(item);
    result += "[" + items + "]";
  };
  auto truth = [&](const char *name, std::optional<bool> value) {
    if (!value)
      return;
    key(name);
    result += *value ? "true" : "false";
  };
  if (!demand.shaders.empty()) {
    key("shaders");
    std::string shaders;
    for (const auto &[name, shader] : demand.shaders)
      shaders += (shaders.empty() ? "" : ", ") + quoted(name) + ": " + writeShader(shader, places);
    result += "{" + shaders + "}";
  }
  if (!demand.globals.empty()) {
    key("globals");
    std::string globals;
    for (const auto &[name, value] : demand.globals)
      globals += (globals.empty() ? "" : ", ") + quoted(name) + ": [" + shortest(value[0]) + ", " +
                 shortest(value[1]) + ", " + shortest(value[2]) + "]";
    result += "{" + globals + "}";
  }
  texts("outputs", demand.outputs);
  texts("asked", demand.asked);
  if (demand.eachLight) {
    key("lights");
    result += writeLights(demand, places);
  } else {
    texts("lights", demand.lights);
  }
  truth("shadows", demand.shadows);
  truth("othersTrace", demand.othersTrace);
  if (demand.rayDepth) {
    key("rayDepth");
    result += std::to_string(*demand.rayDepth);
  }
  texts("textures", demand.textures);
  truth("displacement", demand.displacement);
  truth("atmosphere", demand.atmosphere);
  truth("imager", demand.imager);
  truth("lens", demand.lens);
  if (demand.shutter) {
    key("shutter");
    result += "[" + shortest((*demand.shutter)[0]) + ", " + shortest((*demand.shutter)[1]) + "]";
  }
  return result + "}";
}

bool Demand::looksAt(std::string_view light) const {
  auto names = [this](std::string_view name) {
    return outputs && std::find(outputs->begin(), outputs->end(), name) != outputs->end();
  };
  return names(light) || names("Ci") == names("Oi");
}

} // namespace anysl::demand
