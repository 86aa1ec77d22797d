//===-- lib/Host/Demand.cpp - libraries that serve one scene ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"

#include <algorithm>
#include <cstring>
#include <dlfcn.h>
#include <string_view>
#include <vector>

using namespace anysl::host;

namespace {

const char *const assumptionNames[] = {
#define ANYSL_ASSUMPTION(id, name, doc) doc,
#include <anysl/Assumptions.def>
};

/// What a library lacks for a scene, as the end of a sentence; empty if nothing.
std::string lacking(const AnyslDemandInfo &demand, const AnyslSceneFacts &facts) {
  for (uint32_t i = 0; i < ANYSL_ASSUMPTION_COUNT; ++i)
    if (demand.assumes & facts.has & 1u << i)
      return std::string("without ") + assumptionNames[i] + ", and this one has them";
  if (demand.assumes & 1u << ANYSL_ASSUMES_NO_MOTION && demand.time != facts.time)
    return "at time " + std::to_string(demand.time) + ", and this one is at time " +
           std::to_string(facts.time);
  std::vector<std::string_view> wanted;
  for (const char *const *output = facts.outputs; output && *output; ++output)
    wanted.push_back(*output);
  auto names = [&](std::string_view output) {
    return std::find(wanted.begin(), wanted.end(), output) != wanted.end();
  };
  if (names("Ci") == names("Oi"))
    wanted.insert(wanted.end(), {"Ci", "Oi"});
  for (std::string_view output : wanted)
    if (isDropped(demand, output))
      return "that does not show '" + std::string(output) + "', and this one does";
  return {};
}

} // namespace

const AnyslDemandInfo *anysl::host::demandOf(const LoadedLibrary &library) {
  auto *demand = static_cast<const AnyslDemandInfo *>(
      library.handle ? dlsym(library.handle, ANYSL_DEMAND_SYMBOL) : nullptr);
  return demand && demand->struct_size == sizeof(AnyslDemandInfo) ? demand : nullptr;
}

bool anysl::host::isDropped(const AnyslDemandInfo &demand, std::string_view output) {
  std::string_view list = demand.dropped_outputs;
  while (!list.empty()) {
    size_t end = std::min(list.find(','), list.size());
    if (list.substr(0, end) == output)
      return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

AnyslSourceInfo anysl::host::sourceOf(const LoadedLibrary &library, const AnyslShaderInfo &shader) {
  if (const AnyslDemandInfo *demand = demandOf(library))
    return demand->sources[&shader - library.info->shaders];
  return {shader.globals_written, shader.effects, 0};
}

AnyslStatus anysl::host::checkDemand(const LoadedLibrary &library, const AnyslSceneFacts &facts) {
  const AnyslDemandInfo *demand = demandOf(library);
  std::string lack = demand ? lacking(*demand, facts) : "";
  return lack.empty() ? ANYSL_OK
                      : fail(ANYSL_ERROR_STATE,
                             library.path + ": the library was linked for a scene " + lack);
}

extern "C" {

const AnyslDemandInfo *anysl_library_demand(const AnyslLibrary *library) {
  return demandOf(*library->loaded);
}

AnyslSourceInfo anysl_library_source(const AnyslLibrary *library, const AnyslShaderInfo *shader) {
  return sourceOf(*library->loaded, *shader);
}

AnyslStatus anysl_library_allows(const AnyslLibrary *library, const AnyslSceneFacts *facts) {
  return guarded([&] { return checkDemand(*library->loaded, *facts); });
}

AnyslStatus anysl_library_open_for(const char *path, const char *general,
                                   const AnyslSceneFacts *facts, AnyslLibrary **library) {
  return guarded([&] {
    AnyslLibrary *opened = nullptr;
    if (AnyslStatus status = anysl_library_open(path, 0, &opened))
      return status;
    AnyslStatus status = checkDemand(*opened->loaded, *facts);
    if (!status) {
      *library = opened;
      return ANYSL_OK;
    }
    anysl_library_close(opened);
    return general ? anysl_library_open(general, 0, library) : status;
  });
}

} // extern "C"
