//===-- lib/Host/Demand.cpp - libraries that serve one scene ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <dlfcn.h>
#include <string_view>
#include <utility>
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

std::string kindName(uint32_t kind) {
  switch (kind) {
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence)                                      \
  case id:                                                                                         \
    return "a " word " light";
#include <anysl/LightKinds.def>
  default:
    return "a light shader";
  }
}

/// What of a light is other than what was linked in, as the end of a sentence; empty if nothing.
std::string difference(const AnyslLinkedLight &linked, const AnyslLight &light) {
  const AnyslLight &wanted = linked.light;
  if (wanted.kind != light.kind)
    return "is " + kindName(wanted.kind) + ", and here it is " + kindName(light.kind);
  const std::pair<uint32_t, const char *> flags[] = {
      {ANYSL_LIGHT_CASTS_SHADOW, "casts shadows"},
      {ANYSL_LIGHT_NONDIFFUSE, "leaves diffuse() out"},
      {ANYSL_LIGHT_NONSPECULAR, "leaves specular() out"}};
  for (auto [flag, what] : flags)
    if ((wanted.flags ^ light.flags) & linked.known_flags & flag)
      return std::string(wanted.flags & flag ? "" : "is not one that ") + what +
             ", and here it is otherwise";
  struct Part {
    uint32_t known;
    const char *name;
    const float *wanted, *given;
    size_t count;
  } const parts[] = {{ANYSL_KNOWN_COLOR, "colour", wanted.color, light.color, 3},
                     {ANYSL_KNOWN_FROM, "position", wanted.from, light.from, 3},
                     {ANYSL_KNOWN_DIRECTION, "direction", wanted.direction, light.direction, 3},
                     {ANYSL_KNOWN_CONE, "cone", &wanted.cos_outer, &light.cos_outer, 1},
                     {ANYSL_KNOWN_CONE, "cone", &wanted.cos_inner, &light.cos_inner, 1},
                     {ANYSL_KNOWN_BEAM, "beam", &wanted.beam, &light.beam, 1}};
  for (const Part &part : parts) // bits, since 0 and -0 are not the same
    if (linked.known & part.known &&
        std::memcmp(part.wanted, part.given, part.count * sizeof(float)))
      return std::string("has another ") + part.name + " than here";
  if (linked.known & ANYSL_KNOWN_CODE && (wanted.code != light.code || !light.params))
    return "runs other code than here";
  auto words = [](const char *category) { return std::string_view(category ? category : ""); };
  if (linked.known & ANYSL_KNOWN_CATEGORY && words(wanted.category) != words(light.category))
    return "is of category \"" + std::string(words(wanted.category)) + "\", and here of \"" +
           std::string(words(light.category)) + "\"";
  return {};
}

/// What a parameter of a linked light shader is other than, as the end of a sentence; empty if
/// nothing.
std::string difference(const AnyslLinkedParam &linked, const AnyslLight &light) {
  const AnyslCell &cell = light.params[linked.cell];
  const std::string name = "'" + std::string(linked.name) + "'";
  if (linked.text)
    return std::strcmp(linked.text, cell.string ? cell.string : "")
               ? "has \"" + std::string(linked.text) + "\" as " + name + ", and here it is \"" +
                     (cell.string ? cell.string : "") + "\""
               : std::string();
  if (!std::memcmp(&linked.number, &cell.number, sizeof linked.number)) // bits, as above
    return {};
  char numbers[80];
  std::snprintf(numbers, sizeof numbers, ": %.9g, and here it is %.9g", linked.number, cell.number);
  return "has another " + name + " than here" + numbers;
}

/// The same of all lights.
std::string otherLights(const AnyslDemandInfo &demand, const AnyslLight *lights, uint32_t count,
                        const float (&ambient)[3]) {
  if (demand.ambient_known && std::memcmp(demand.ambient, ambient, sizeof ambient))
    return "whose ambient lights add up to other light than here";
  if (demand.assumes & 1u << ANYSL_ASSUMES_NO_LIGHT_SHADERS &&
      std::any_of(lights, lights + count,
                  [](auto &light) { return light.kind == ANYSL_LIGHT_SHADER; }))
    return std::string("without ") + assumptionNames[ANYSL_ASSUMES_NO_LIGHT_SHADERS] +
           ", and this one has them";
  if (!demand.lights)
    return {};
  auto number = [](uint32_t lights) {
    return std::to_string(lights) + (lights == 1 ? " light" : " lights");
  };
  if (demand.light_count != count)
    return "with " + number(demand.light_count) + ", and this one has " + std::to_string(count);
  for (uint32_t i = 0; i < count; ++i)
    if (std::string what = difference(demand.lights[i], lights[i]); !what.empty())
      return "whose light " + std::to_string(i + 1) + " " + what;
  for (uint32_t i = 0; i < demand.linked_param_count; ++i) {
    const AnyslLinkedParam &linked = demand.linked_params[i];
    if (std::string what = difference(linked, lights[linked.light]); !what.empty())
      return "whose light " + std::to_string(linked.light + 1) + " " + what;
  }
  return {};
}

AnyslStatus refuse(const LoadedLibrary &library, const std::string &lack) {
  return lack.empty() ? ANYSL_OK
                      : fail(ANYSL_ERROR_STATE,
                             library.path + ": the library was linked for a scene " + lack);
}

} // namespace

const AnyslDemandInfo *anysl::host::findDemand(void *handle) {
  auto *demand = static_cast<const AnyslDemandInfo *>(dlsym(handle, ANYSL_DEMAND_SYMBOL));
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

const AnyslFixedGlobal *anysl::host::fixedGlobal(const LoadedLibrary &library, int global) {
  for (uint32_t i = 0; library.demand && i < library.demand->fixed_global_count; ++i)
    if (library.demand->fixed_globals[i].global == uint32_t(global))
      return &library.demand->fixed_globals[i];
  return nullptr;
}

AnyslSourceInfo anysl::host::sourceOf(const LoadedLibrary &library, const AnyslShaderInfo &shader) {
  if (library.demand)
    return library.demand->sources[&shader - library.info->shaders];
  return {shader.globals_written, shader.effects, 0};
}

AnyslStatus anysl::host::checkDemand(const LoadedLibrary &library, const AnyslSceneFacts &facts) {
  return library.demand ? refuse(library, lacking(*library.demand, facts)) : ANYSL_OK;
}

AnyslStatus anysl::host::checkLights(const LoadedLibrary &library, const AnyslLight *lights,
                                     uint32_t count, const float (&ambient)[3]) {
  return library.demand ? refuse(library, otherLights(*library.demand, lights, count, ambient))
                        : ANYSL_OK;
}

/// With its lights.
static AnyslStatus checkScene(const LoadedLibrary &library, const AnyslSceneFacts &facts) {
  AnyslStatus status = checkDemand(library, facts);
  // A host that knows less facts than this header says nothing of its lights.
  static constexpr float none[3] = {};
  if (!status && facts.struct_size < sizeof facts)
    return checkLights(library, nullptr, 0, none);
  return status ? status : checkLights(library, facts.lights, facts.light_count, facts.ambient);
}

extern "C" {

const AnyslDemandInfo *anysl_library_demand(const AnyslLibrary *library) {
  return library->loaded->demand;
}

AnyslSourceInfo anysl_library_source(const AnyslLibrary *library, const AnyslShaderInfo *shader) {
  return sourceOf(*library->loaded, *shader);
}

AnyslStatus anysl_library_allows(const AnyslLibrary *library, const AnyslSceneFacts *facts) {
  return guarded([&] { return checkScene(*library->loaded, *facts); });
}

AnyslStatus anysl_library_open_for(const char *path, const char *general,
                                   const AnyslSceneFacts *facts, AnyslLibrary **library) {
  return guarded([&] {
    AnyslLibrary *opened = nullptr;
    if (AnyslStatus status = anysl_library_open(path, 0, &opened))
      return status;
    AnyslStatus status = checkScene(*opened->loaded, *facts);
    if (!status) {
      *library = opened;
      return ANYSL_OK;
    }
    anysl_library_close(opened);
    return general ? anysl_library_open(general, 0, library) : status;
  });
}

} // extern "C"
