//===-- tools/anysl-info/DescribeLibrary.cpp - asks a compiled library ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Ops.h"
#include "tools/anysl-info/Description.h"
#include "llvm/ADT/StringExtras.h"
#include <anysl/anysl.h>
#include <array>
#include <memory>

using namespace llvm;

namespace anysl::info {
namespace {

std::vector<std::string> globalNames(uint64_t mask) {
  std::vector<std::string> names;
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
    if (mask >> global & 1)
      names.push_back(anysl_global_name(global));
  return names;
}

/// The names of a mask's bits; one that this program's table does not know is its number.
std::vector<std::string> bitNames(uint32_t mask, ArrayRef<StringRef> table) {
  std::vector<std::string> names;
  for (unsigned bit = 0; bit < 32; ++bit)
    if (mask >> bit & 1)
      names.push_back(bit < table.size() && !table[bit].empty() ? table[bit].str()
                                                                : std::to_string(bit));
  return names;
}

const StringRef serviceNames[] = {
#define STC_SERVICE(id, name, doc) #name,
#include "lib/STC/Services.def"
};
/// By their identifiers, between which there are gaps.
const std::array<StringRef, 32> effectNames = [] {
  std::array<StringRef, 32> names;
#define STC_EFFECT(id, name, doc) names[id] = #name;
#include "lib/STC/Effects.def"
  return names;
}();

std::optional<Default> readDefault(const AnyslInstance *instance, const AnyslParamInfo &param) {
  if (!instance)
    return std::nullopt;
  size_t count = size_t(anysl_type_components(param.type)) * std::max(param.array_length, 1u);
  if (param.type == ANYSL_STRING) {
    std::vector<const char *> texts(count);
    if (anysl_instance_get_strings(instance, param.name, texts.data(), count))
      return std::nullopt;
    return std::vector<std::string>(texts.begin(), texts.end());
  }
  std::vector<double> numbers(count);
  if (anysl_instance_get_numbers(instance, param.name, numbers.data(), count))
    return std::nullopt;
  return numbers;
}

Param describeParam(const AnyslParamInfo &info, const AnyslInstance *instance) {
  Param param;
  param.name = info.name;
  param.type = anysl_type_name(info.type);
  param.components = anysl_type_components(info.type);
  param.arrayLength = info.array_length;
  param.varying = info.flags & ANYSL_PARAM_VARYING;
  param.output = info.flags & ANYSL_PARAM_OUTPUT;
  param.fixed = info.flags & ANYSL_PARAM_FIXED;
  param.defaultValue = readDefault(instance, info);
  return param;
}

Shader describeShader(const AnyslShaderInfo &info, AnyslLibrary *library) {
  Shader shader;
  shader.name = info.name;
  shader.kind = anysl_kind_name(info.kind);
  for (uint32_t i = 0; i < info.entry_count; ++i)
    shader.widths.push_back(info.entries[i].width);
  shader.globalsRead = globalNames(info.globals_read);
  shader.globalsWritten = globalNames(info.globals_written);
  // Bit 0 of the services means that something asks for nothing.
  shader.services = bitNames(info.services & ~1u, serviceNames);
  shader.effects = bitNames(info.effects, effectNames);
  // Fails where the library is open for inspection only: then there are no defaults to show.
  AnyslInstance *instance = nullptr;
  std::string exact = shader.kind + ":" + info.name;
  if (anysl_instance_create(library, exact.c_str(), nullptr, nullptr, &instance))
    instance = nullptr;
  for (uint32_t i = 0; i < info.param_count; ++i)
    shader.params.push_back(describeParam(info.params[i], instance));
  anysl_instance_free(instance);
  return shader;
}

std::vector<std::string> splitList(StringRef list) {
  std::vector<std::string> names;
  for (StringRef name : split(list, ','))
    if (!name.empty())
      names.push_back(name.str());
  return names;
}

std::string orEmpty(const char *text) { return text ? text : ""; }

} // namespace

std::optional<Description> describeLibrary(DiagnosticEngine &diags, const std::string &path) {
  Target target;
  AnyslLibrary *opened = nullptr;
  AnyslStatus status = anysl_library_open(path.c_str(), 0, &opened);
  if (status == ANYSL_ERROR_CPU) {
    target.refusal = StringRef(anysl_last_error()).drop_front(path.size() + 2).str();
    status = anysl_library_open(path.c_str(), ANYSL_OPEN_INSPECT, &opened);
  }
  if (status) {
    diags.error(anysl_last_error());
    return std::nullopt;
  }
  std::unique_ptr<AnyslLibrary, decltype(&anysl_library_close)> library(opened,
                                                                        anysl_library_close);
  const AnyslLibraryInfo &info = *anysl_library_info(opened);
  target.runtime = orEmpty(info.runtime);
  target.real = orEmpty(info.real_name);
  target.math = orEmpty(info.math);
  target.layout = info.layout == ANYSL_LAYOUT_SOA ? "SoA" : "AoS";
  target.cpu = orEmpty(info.target_cpu);
  target.cpuFeatures = splitList(orEmpty(info.cpu_features));
  Description description = {path, orEmpty(info.producer), target, std::nullopt, {}};
  for (uint32_t i = 0; i < info.shader_count; ++i)
    description.shaders.push_back(describeShader(info.shaders[i], opened));
  return description;
}

} // namespace anysl::info
