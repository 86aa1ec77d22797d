//===-- lib/Demand/ManifestShaders.cpp - a manifest's shaders ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Demand/ManifestShaders.h"

using namespace anysl::render;

namespace anysl::demand {
namespace {

/// 0.5, [1, 0, 0], "grid.tex", null, or one of these with its origin: {"value": 0.5, "from":
/// "..."}.
std::optional<Value> readValue(const Json &json, const std::string &name) {
  if (json.kind == Json::Null)
    return std::nullopt;
  Value result;
  result.from = placeOf(json.where);
  const Json *value = &json;
  if (json.kind == Json::Object) {
    value = nullptr;
    const Key keys[] = {{"value", [&](const Json &given, const std::string &) { value = &given; }},
                        {"from", [&](const Json &given, const std::string &key) {
                           expect(given, Json::Text, key);
                           result.from = given.text;
                         }}};
    readMembers(json, "a value", keys);
    if (!value)
      throw UserError(json.where, "\"" + name + "\" has no \"value\"");
  }
  if (value->kind == Json::Text) {
    result.text = value->text;
  } else if (value->kind == Json::Number) {
    result.numbers = {value->number};
  } else if (value->kind == Json::Array && !value->items.empty()) {
    for (const Json &item : value->items) {
      expect(item, Json::Number, name + "[]");
      result.numbers.push_back(item.number);
    }
  } else {
    throw UserError(value->where,
                    "\"" + name + "\" is a number, numbers or text, not " + describe(value->kind));
  }
  return result;
}

std::string writeValue(const Value &value, bool places) {
  std::string text;
  for (double number : value.numbers)
    text += (text.empty() ? "" : ", ") + shortest(number);
  text = value.numbers.empty()       ? quoted(value.text)
         : value.numbers.size() == 1 ? text
                                     : "[" + text + "]";
  return places && !value.from.empty()
             ? "{\"value\": " + text + ", \"from\": " + quoted(value.from) + "}"
             : text;
}

} // namespace

ShaderDemand readShader(const Json &json, const std::string &name, bool complete) {
  expect(json, Json::Object, name);
  ShaderDemand result;
  result.complete = complete;
  const Key keys[] = {{"parameters",
                       [&](const Json &value, const std::string &key) {
                         expect(value, Json::Object, key);
                         for (const Json::Member &member : value.members)
                           result.parameters[member.key] = readValue(member.value, member.key);
                       }},
                      {"complete", [&](const Json &value, const std::string &key) {
                         result.complete = readBool(value, key);
                       }}};
  readMembers(json, "a shader", keys);
  return result;
}

std::string writeShader(const ShaderDemand &shader, bool places) {
  std::string parameters;
  for (const auto &[name, value] : shader.parameters)
    parameters += (parameters.empty() ? "" : ", ") + quoted(name) + ": " +
                  (value ? writeValue(*value, places) : "null");
  return std::string("{\"complete\": ") + (shader.complete ? "true" : "false") +
         ", \"parameters\": {" + parameters + "}}";
}

} // namespace anysl::demand
