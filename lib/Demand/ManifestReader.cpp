//===-- lib/Demand/ManifestReader.cpp - members of a manifest ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Demand/ManifestReader.h"

#include <algorithm>

using namespace anysl::render;

namespace anysl::demand {

void expect(const Json &value, Json::Kind kind, const std::string &key) {
  if (value.kind != kind)
    throw UserError(value.where,
                    "\"" + key + "\" is " + describe(kind) + ", not " + describe(value.kind));
}

bool readBool(const Json &value, const std::string &key) {
  expect(value, Json::Bool, key);
  return value.truth;
}

std::vector<std::string> readTexts(const Json &value, const std::string &key) {
  expect(value, Json::Array, key);
  std::vector<std::string> result;
  for (const Json &item : value.items) {
    expect(item, Json::Text, key + "[]");
    result.push_back(item.text);
  }
  return result;
}

std::vector<double> readNumbers(const Json &value, const std::string &key) {
  expect(value, Json::Array, key);
  std::vector<double> result;
  for (const Json &item : value.items) {
    expect(item, Json::Number, key + "[]");
    result.push_back(item.number);
  }
  return result;
}

void readMembers(const Json &object, const std::string &what, std::span<const Key> keys) {
  for (const Json::Member &member : object.members) {
    auto key = std::find_if(keys.begin(), keys.end(),
                            [&](const Key &each) { return each.name == member.key; });
    if (key == keys.end()) {
      std::string known;
      for (const Key &each : keys)
        known += (known.empty() ? "" : ", ") + std::string(each.name);
      throw UserError(member.where, what + " has no \"" + member.key + "\"; there are " + known);
    }
    key->read(member.value, member.key);
  }
}

} // namespace anysl::demand
