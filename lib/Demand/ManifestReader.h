//===-- lib/Demand/ManifestReader.h - members of a manifest -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_DEMAND_MANIFESTREADER_H
#define ANYSL_LIB_DEMAND_MANIFESTREADER_H

#include "lib/Demand/Json.h"

#include <functional>
#include <span>

namespace anysl::demand {

/// These throw UserError with the place of a value that is of another kind than the key wants.
void expect(const Json &value, Json::Kind kind, const std::string &key);
bool readBool(const Json &value, const std::string &key);
std::vector<std::string> readTexts(const Json &value, const std::string &key);
std::vector<double> readNumbers(const Json &value, const std::string &key);

/// A key of an object, and what reads its value.
struct Key {
  const char *name;
  std::function<void(const Json &, const std::string &)> read;
};
/// Calls the reader of each member; one that has none is refused, with those that there are.
void readMembers(const Json &object, const std::string &what, std::span<const Key> keys);

} // namespace anysl::demand

#endif
