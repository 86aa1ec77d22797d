//===-- tools/anysl-render/Scene.cpp - a scene ready to be rendered ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <exception>
#include <tuple>

using namespace anysl::render;

namespace {

/// The bit of AnyslShaderInfo::services that says that a shader asks for named spaces.
constexpr uint32_t spacesService = 1u << 3;

bool isTriple(ValueType type) {
  return type == ValueType::Point || type == ValueType::Vector || type == ValueType::Normal;
}

/// Whether a value declared in the scene may go into a shader's parameter.
bool fits(ValueType declared, uint32_t wanted) {
  switch (wanted) {
  case ANYSL_FLOAT:
    return declared == ValueType::Float;
  case ANYSL_COLOR:
    return declared == ValueType::Color;
  case ANYSL_MATRIX:
    return declared == ValueType::Matrix;
  case ANYSL_STRING:
    return declared == ValueType::String;
  default:
    return isTriple(declared);
  }
}

} // namespace

Scene::Scene(const SceneDescription &given, const ShaderCache &cache, const AnyslServices &services,
             AnyslLayout layout, unsigned width, Warnings &warnings)
    : description(given), camera(given.camera), spaces(given, camera), background(given) {
  loadShaders(cache, services, layout, width, warnings);
  makeGroups(warnings);
  surfaces = std::make_unique<Geometry>(description, groupOfShape);
}

void Scene::loadShaders(const ShaderCache &cache, const AnyslServices &services, AnyslLayout layout,
                        unsigned width, Warnings &warnings) {
  // Only those that some shape uses, and each file once.
  std::vector<bool> used(description.surfaces.size());
  for (const Shape &shape : description.shapes)
    if (int surface = description.appearances[shape.appearance].surface; surface >= 0)
      used[size_t(surface)] = true;
  std::map<std::string, const Location *> names;
  for (size_t i = 0; i < used.size(); ++i)
    if (used[i])
      names.emplace(description.surfaces[i].name, &description.surfaces[i].where);

  struct Job {
    std::string name;
    const Location *where;
    std::filesystem::path library;
    std::exception_ptr error;
  };
  std::vector<Job> jobs;
  for (auto [name, where] : names)
    jobs.push_back({name, where, {}, nullptr});
  tbb::parallel_for(size_t(0), jobs.size(), [&](size_t i) {
    try {
      jobs[i].library = cache.library(jobs[i].name, *jobs[i].where);
    } catch (...) {
      jobs[i].error = std::current_exception();
    }
  });
  for (Job &job : jobs) {
    if (job.error)
      std::rethrow_exception(job.error);
    AnyslLibrary *library = nullptr;
    if (anysl_library_open(std::filesystem::absolute(job.library).c_str(), 0, &library))
      throw UserError(*job.where, anysl_last_error());
    libraries[job.name].reset(library);
    const AnyslLibraryInfo &info = *anysl_library_info(library);
    if (info.layout != uint32_t(layout))
      throw UserError(*job.where, job.library.string() + " is made for runtime \"" + info.runtime +
                                      "\", whose arrays are laid out differently");
    if (libraries.size() > 1 && info.real != uint32_t(format))
      throw UserError(*job.where, "the scene's shaders compute in both float and double");
    format = AnyslReal(info.real);
  }

  shaders.resize(description.surfaces.size());
  for (size_t i = 0; i < used.size(); ++i) {
    if (!used[i])
      continue;
    const ShaderUse &use = description.surfaces[i];
    AnyslLibrary *library = libraries[use.name].get();
    std::string base = std::filesystem::path(use.name).stem().string();
    const AnyslLibraryInfo &info = *anysl_library_info(library);
    // The shader of the file's name, or the only one there is.
    bool only = info.shader_count == 1;
    const AnyslShaderInfo *shader = anysl_library_shader(library, only ? nullptr : base.c_str());
    if (!shader)
      throw UserError(use.where, anysl_last_error());
    if (shader->kind != ANYSL_SURFACE)
      throw UserError(use.where, "\"" + use.name + "\" is a " + anysl_kind_name(shader->kind) +
                                     " shader, not a surface shader");
    auto surface = std::make_unique<SurfaceShader>();
    surface->scene = this;
    surface->use = &use;
    surface->space = Space(use.shaderToCamera);
    AnyslInstance *instance = nullptr;
    if (anysl_instance_create(library, shader->name, &services, surface.get(), &instance))
      throw UserError(use.where, anysl_last_error());
    surface->instance.reset(instance);
    surface->shade = anysl_shader_entry(shader, width);
    surface->width = width;
    if (!surface->shade) { // a library from elsewhere, with other widths
      surface->shade = anysl_shader_entry(shader, 0);
      surface->width = anysl_shader_widest(shader);
    }
    surface->needed = shader->globals_read;
    surface->globals = shader->globals_read | shader->globals_written;
    setParameters(*surface, warnings);
    shaders[i] = std::move(surface);
  }
}

void Scene::setParameters(SurfaceShader &shader, Warnings &warnings) {
  const ShaderUse &use = *shader.use;
  const AnyslShaderInfo *info = anysl_instance_shader(shader.instance.get());
  for (const Parameter &parameter : use.parameters) {
    const AnyslParamInfo *param = anysl_shader_param(info, parameter.name.c_str());
    if (!param) {
      warnings.warn(parameter.where,
                    "shader \"" + use.name + "\" has no parameter \"" + parameter.name + "\"");
      continue;
    }
    if (parameter.declaration && !fits(parameter.declaration->type, param->type))
      throw UserError(parameter.where, "\"" + parameter.name + "\" of shader \"" + use.name +
                                           "\" is a " + anysl_type_name(param->type) +
                                           "; it is declared otherwise here");
    AnyslStatus status;
    if (!parameter.strings.empty()) {
      std::vector<const char *> texts;
      for (const std::string &text : parameter.strings)
        texts.push_back(text.c_str());
      status = anysl_instance_set_strings(shader.instance.get(), param->name, texts.data(),
                                          texts.size());
    } else {
      // Geometric values are given in the space of the request, and shaders want camera space.
      std::vector<double> numbers = parameter.numbers;
      bool geometric =
          param->type == ANYSL_POINT || param->type == ANYSL_VECTOR || param->type == ANYSL_NORMAL;
      for (size_t i = 0; geometric && i + 2 < numbers.size(); i += 3) {
        Vec3d value(numbers[i], numbers[i + 1], numbers[i + 2]);
        value = param->type == ANYSL_POINT    ? use.shaderToCamera.point(value)
                : param->type == ANYSL_VECTOR ? use.shaderToCamera.vector(value)
                                              : shader.space.fromCamera.normalByInverse(value);
        for (size_t k = 0; k < 3; ++k)
          numbers[i + k] = value[int(k)];
      }
      status = anysl_instance_set_numbers(shader.instance.get(), param->name, numbers.data(),
                                          numbers.size());
    }
    if (status != ANYSL_OK)
      throw UserError(parameter.where, anysl_last_error());
  }
}

void Scene::makeGroups(Warnings &warnings) {
  using Key = std::tuple<int, const LightSet *, uint32_t>;
  std::map<Key, uint32_t> known;
  constexpr uint32_t anyObject = ~uint32_t(0);
  for (uint32_t i = 0; i < description.shapes.size(); ++i) {
    const Shape &shape = description.shapes[i];
    const Appearance &appearance = description.appearances[shape.appearance];
    auto [lights, isNew] = lightSets.try_emplace(appearance.lights);
    if (isNew)
      lights->second = makeLightSet(description, appearance.lights, warnings);
    const SurfaceShader *shader =
        appearance.surface < 0 ? nullptr : shaders[size_t(appearance.surface)].get();
    bool bySpace =
        shader && (anysl_instance_shader(shader->instance.get())->services & spacesService) != 0;
    Key key{appearance.surface, &lights->second, bySpace ? i : anyObject};
    auto [entry, isNewGroup] = known.try_emplace(key, uint32_t(groups.size()));
    if (isNewGroup)
      groups.push_back({shader, &lights->second, Space(shape.objectToCamera)});
    groupOfShape.push_back(entry->second);
  }
}
