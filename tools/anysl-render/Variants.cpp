//===-- tools/anysl-render/Variants.cpp - what shaders are linked for -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Variants.h"

#include "tools/anysl-render/Lights.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <exception>

namespace demand = anysl::demand;
using namespace anysl::render;

namespace {

bool anyDisplaces(const std::vector<const ShaderUse *> &uses) {
  return std::any_of(uses.begin(), uses.end(),
                     [](const ShaderUse *use) { return use->kind == ShaderKind::Displacement; });
}

void setManifest(WantedLibrary &library) {
  library.variant.manifest = demand::writeManifest(library.demand, /*places=*/false);
  library.variant.withPlaces = demand::writeManifest(library.demand);
  std::set<std::string> lights;
  for (const demand::LightDemand &light : library.demand.linkedLights())
    if (light.values.light.kind == ANYSL_LIGHT_SHADER)
      lights.insert(light.kind);
  library.variant.lights.assign(lights.begin(), lights.end());
}

} // namespace

WantedLibrary Variants::forRays(const WantedLibrary &camera, RayKind rays,
                                std::vector<const ShaderUse *> uses) {
  WantedLibrary result = camera;
  result.uses = std::move(uses);
  result.rays = rays;
  result.outline.reset();
  result.demand.outputs = rays == RayKind::Shadow ? std::vector<std::string>{"Oi"}
                                                  : std::vector<std::string>{"Ci", "Oi"};
  setManifest(result);
  return result;
}

demand::Demand Variants::common() const {
  demand::Demand result = demand::demandOf(scene);
  for (std::string &light : *result.lights)
    if (!isStandardLight(light, cache))
      light = kindOfShader(light);
  std::set<std::string> names;
  bool known = true;
  result.othersTrace = false;
  for (const auto &[name, its] : asking) {
    known &= its.names.has_value();
    if (its.names)
      names.insert(its.names->begin(), its.names->end());
    *result.othersTrace |= its.tracesForOthers;
  }
  // Then the standard's lights are run as the shaders that they are, too.
  if (asksLights())
    result.lights->push_back("the standard's, as shaders");
  if (known)
    result.asked.emplace(names.begin(), names.end());
  return result;
}

bool Variants::asksLights() const {
  return std::any_of(asking.begin(), asking.end(),
                     [](const auto &entry) { return entry.second.asksLights; });
}

bool Variants::mayTrace() const {
  return !cache.specialises() || std::any_of(asking.begin(), asking.end(),
                                             [](const auto &entry) { return entry.second.traces; });
}

std::vector<const Shape *> Variants::shapesOf(const std::vector<const ShaderUse *> &uses) const {
  std::vector<const Shape *> result;
  for (const Shape &shape : scene.shapes) {
    int surface = scene.appearances[shape.appearance].surface;
    if (surface >= 0 &&
        std::find(uses.begin(), uses.end(), &scene.shaders[size_t(surface)]) != uses.end())
      result.push_back(&shape);
  }
  return result;
}

void Variants::addLights(demand::Demand &demand, std::span<const Shape *const> shapes,
                         bool areAllThere) const {
  if (!lights || asksLights())
    return;
  const std::vector<uint32_t> *same = nullptr;
  for (const Shape *shape : shapes) {
    const Appearance &appearance = scene.appearances[shape->appearance];
    if (same && *same != appearance.lights)
      return;
    same = &appearance.lights;
  }
  if (!same)
    return;
  SceneLights::Known known = lights->known(*same);
  if (known.each.size() > ANYSL_MOST_LINKED_LIGHTS || (known.hasShaders && !areAllThere))
    return;
  demand.shadows = std::any_of(known.each.begin(), known.each.end(), [](const auto &light) {
    const AnyslLinkedLight &values = light.values;
    return ((values.light.flags | ~values.known_flags) & ANYSL_LIGHT_CASTS_SHADOW) != 0;
  });
  demand.setLights(std::move(known.each), known.hasAmbient, known.ambient);
}

std::vector<WantedLibrary> Variants::plan(std::span<const ShaderUse *const> uses,
                                          Warnings &warnings) {
  std::map<std::string, std::vector<const ShaderUse *>> byName;
  for (const ShaderUse *use : uses)
    byName[use->name].push_back(use);
  std::vector<WantedLibrary> result;
  if (!cache.specialises()) {
    for (auto &[name, its] : byName) {
      ShaderVariant variant;
      variant.tangents = anyDisplaces(its);
      result.push_back({name, variant, std::move(its), {}});
    }
    return result;
  }

  struct Job {
    const std::string *name;
    ShaderAsking asking;
    std::exception_ptr error;
  };
  std::vector<Job> jobs;
  for (const auto &[name, its] : byName)
    if (!asking.contains(name))
      jobs.push_back({&name, {}, nullptr});
  tbb::parallel_for(size_t(0), jobs.size(), [&](size_t i) {
    try {
      jobs[i].asking = cache.asking(*jobs[i].name, byName.at(*jobs[i].name).front()->where);
    } catch (...) {
      jobs[i].error = std::current_exception();
    }
  });
  for (Job &job : jobs)
    try {
      if (job.error)
        std::rethrow_exception(job.error);
      asking[*job.name] = std::move(job.asking);
    } catch (const UserError &error) {
      warnings.fail(error.where, error.message);
      byName.erase(*job.name);
    }

  const demand::Demand common = this->common();
  const std::set<std::string> variables = demand::variablesOf(scene);
  for (const auto &[name, its] : byName) {
    // A co-shader's parameters are set and read by whoever calls it.
    std::vector<const ShaderUse *> called, stated;
    for (const ShaderUse *use : its)
      (use->kind == ShaderKind::Any ? called : stated).push_back(use);
    auto add = [&](const demand::Demand &demand, const std::vector<const ShaderUse *> &group) {
      WantedLibrary wanted{name, {}, {}, demand};
      setManifest(wanted);
      auto same = std::find_if(result.begin(), result.end(), [&](const WantedLibrary &other) {
        return other.name == name && other.variant.manifest == wanted.variant.manifest;
      });
      if (same == result.end())
        same = result.insert(result.end(), std::move(wanted));
      same->variant.tangents |= anyDisplaces(group);
      same->uses.insert(same->uses.end(), group.begin(), group.end());
    };
    if (!called.empty())
      add(common, called);
    for (const auto &group : demand::alikeUses(stated, mostOfOne - !called.empty())) {
      demand::Demand demand = common;
      demand::addShader(demand, variables, group);
      if (std::all_of(group.begin(), group.end(),
                      [](const ShaderUse *use) { return use->kind == ShaderKind::Surface; })) {
        const std::vector<const Shape *> shapes = shapesOf(group);
        addLights(demand, shapes, !warnings.keepGoing);
        demand.globals = demand::fixedGlobals(scene, shapes);
      }
      add(demand, group);
    }
  }
  return result;
}
