//===-- tools/anysl-render/Shaders.cpp - shaders with their values ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Shaders.h"

#include "tools/anysl-render/Footprint.h"
#include "tools/anysl-render/Geometry.h"
#include "tools/anysl-render/Lights.h"
#include "tools/anysl-render/Scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <exception>

namespace demand = anysl::demand;
namespace stc = anysl::stc;
using namespace anysl::render;

namespace {

static_assert(int(ShaderKind::Surface) == ANYSL_SURFACE && int(ShaderKind::Light) == ANYSL_LIGHT &&
              int(ShaderKind::Displacement) == ANYSL_DISPLACEMENT &&
              int(ShaderKind::Volume) == ANYSL_VOLUME && int(ShaderKind::Imager) == ANYSL_IMAGER);

constexpr uint64_t bits(auto... globals) { return ((uint64_t(1) << globals) | ...); }

/// The globals that derivativesBit asks for.
constexpr uint64_t differentiatedGlobals =
    bits(ANYSL_dNdu, ANYSL_dNdv, ANYSL_dsdu, ANYSL_dsdv, ANYSL_dtdu, ANYSL_dtdv, ANYSL_dNgdu,
         ANYSL_dNgdv, ANYSL_dCsdu, ANYSL_dCsdv, ANYSL_dOsdu, ANYSL_dOsdv);

bool isTriple(ValueType type) {
  return type == ValueType::Point || type == ValueType::Vector || type == ValueType::Normal ||
         type == ValueType::HPoint;
}

} // namespace

uint64_t anysl::render::neededFor(uint64_t globals) {
  uint64_t needed = globals;
  if (globals & differentiatedGlobals)
    needed |= derivativesBit;
  if (globals & (footprintBits | bits(ANYSL_dIdu, ANYSL_dIdv)))
    needed |= footprintBits | bits(ANYSL_dPdu, ANYSL_dPdv);
  return needed;
}

bool anysl::render::fits(ValueType declared, uint32_t wanted) {
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

namespace {

/// Of a file that may hold several shaders, the one of the request's kind that has the file's name,
/// or that is the only one of its kind.
const AnyslShaderInfo *findShader(const AnyslLibrary *library, const ShaderUse &use) {
  const AnyslLibraryInfo &file = *anysl_library_info(library);
  std::string base = std::filesystem::path(use.name).filename().string();
  base = base.substr(0, base.find('.'));
  const AnyslShaderInfo *found = nullptr, *other = nullptr;
  unsigned count = 0;
  for (uint32_t i = 0; i < file.shader_count; ++i) {
    const AnyslShaderInfo &shader = file.shaders[i];
    if (use.kind != ShaderKind::Any && shader.kind != uint32_t(use.kind)) {
      other = &shader;
      continue;
    }
    if (shader.name == base)
      return &shader;
    found = &shader;
    ++count;
  }
  // Of a class any part does: its methods and parameters are all there.
  if (use.kind == ShaderKind::Any && count > 0)
    return &file.shaders[0];
  const std::string kind = anysl_kind_name(uint32_t(use.kind));
  if (count > 1)
    throw UserError(use.where, "\"" + use.name + "\" holds " + std::to_string(count) + " " + kind +
                                   " shaders, and none is named \"" + base + "\"");
  if (count == 0 && !other)
    throw UserError(use.where, "\"" + use.name + "\" holds no shader");
  if (count == 0)
    throw UserError(use.where, "\"" + use.name + "\" is a " + anysl_kind_name(other->kind) +
                                   " shader, not a " + kind + " shader");
  return found;
}

} // namespace

namespace {

/// All that a library's shaders do.
uint32_t effectsOf(const AnyslLibraryInfo &library) {
  uint32_t effects = 0;
  for (uint32_t i = 0; i < library.shader_count; ++i)
    effects |= library.shaders[i].effects;
  return effects;
}

} // namespace

void ShaderLoader::open(std::span<const ShaderUse *const> uses) {
  std::vector<const ShaderUse *> added;
  std::copy_if(uses.begin(), uses.end(), std::back_inserter(added),
               [&](const ShaderUse *use) { return !libraryOf.contains({use, RayKind::Camera}); });
  std::vector<WantedLibrary> wanted = variants.plan(added, warnings);
  if (scene.description.maxDepth > 0 && variants.mayTrace()) {
    // What is seen in mirrors is filtered as wide as the rays there say, which has its price.
    outlineAll(wanted);
    wantsFootprints |= std::any_of(wanted.begin(), wanted.end(), [](const WantedLibrary &library) {
      return library.outline->wantsFootprints;
    });
    for (WantedLibrary &library : wanted)
      library.variant.rayDerivatives = wantsFootprints && library.outline->traces;
  }
  openAll(std::move(wanted));
  for (; logged < libraries.size(); ++logged)
    if (AnyslNoteLog *log = anysl_note_log_create(libraries[logged]->library.get()))
      notes.emplace_back(log);
}

void ShaderLoader::openForRays() {
  std::set<const ShaderUse *> inShadows;
  const SceneDescription &description = scene.description;
  for (const Shape &shape : description.shapes) {
    const Appearance &appearance = description.appearances[shape.appearance];
    if (appearance.surface >= 0 && appearance.visibility.transmission == Visibility::ByShader)
      inShadows.insert(&description.shaders[size_t(appearance.surface)]);
  }
  uint32_t effects = 0;
  for (const auto &opened : libraries)
    effects |= effectsOf(*anysl_library_info(opened->library.get()));
  const bool tracesRays = stc::has(effects, stc::Effect::Trace) ||
                          stc::has(effects, stc::Effect::Indirect) ||
                          stc::has(effects, stc::Effect::Glossy);
  std::vector<WantedLibrary> more;
  for (const auto &opened : libraries) {
    if (!anysl_library_demand(opened->library.get()) || opened->wanted.variant.manifest.empty())
      continue;
    std::vector<const ShaderUse *> traced, shadow;
    for (const ShaderUse *use : opened->wanted.uses) {
      if (use->kind == ShaderKind::Surface)
        traced.push_back(use);
      if (inShadows.contains(use))
        shadow.push_back(use);
    }
    auto add = [&](RayKind rays, std::vector<const ShaderUse *> uses) {
      if (auto smaller = smallerFor(rays, *opened, std::move(uses)))
        more.push_back(std::move(*smaller));
    };
    if (!traced.empty() && tracesRays && description.maxDepth > 0)
      add(RayKind::Traced, std::move(traced));
    if (!shadow.empty() && stc::has(effects, stc::Effect::Shadows))
      add(RayKind::Shadow, std::move(shadow));
  }
  openAll(std::move(more));
}

std::optional<WantedLibrary> ShaderLoader::smallerFor(RayKind rays, Opened &opened,
                                                      std::vector<const ShaderUse *> uses) const {
  // Compiling takes as long as there is code, and has to be worth that.
  constexpr double worthwhile = 0.875;
  WantedLibrary smaller = Variants::forRays(opened.wanted, rays, std::move(uses));
  if (smaller.variant.manifest == opened.wanted.variant.manifest)
    return std::nullopt;
  auto outlineOf = [this](WantedLibrary &library) -> const LibraryOutline & {
    if (!library.outline)
      library.outline = cache.outline(library.name, library.uses[0]->where, library.variant);
    return *library.outline;
  };
  if (outlineOf(smaller).instructions > worthwhile * outlineOf(opened.wanted).instructions)
    return std::nullopt;
  return smaller;
}

void ShaderLoader::outlineAll(std::vector<WantedLibrary> &wanted) {
  std::vector<std::exception_ptr> errors(wanted.size());
  tbb::parallel_for(size_t(0), wanted.size(), [&](size_t i) {
    try {
      wanted[i].outline =
          cache.outline(wanted[i].name, wanted[i].uses[0]->where, wanted[i].variant);
    } catch (...) {
      errors[i] = std::current_exception();
    }
  });
  for (std::exception_ptr &error : errors)
    try {
      if (error)
        std::rethrow_exception(error);
    } catch (const UserError &refused) {
      warnings.fail(refused.where, refused.message);
    }
  std::erase_if(wanted, [](const WantedLibrary &library) { return !library.outline; });
}

void ShaderLoader::openAll(std::vector<WantedLibrary> wanted) {
  struct Job {
    WantedLibrary wanted;
    std::filesystem::path library;
    std::exception_ptr error;
  };
  std::vector<Job> jobs;
  for (WantedLibrary &library : wanted)
    jobs.push_back({std::move(library), {}, nullptr});
  tbb::parallel_for(size_t(0), jobs.size(), [&](size_t i) {
    try {
      const WantedLibrary &its = jobs[i].wanted;
      jobs[i].library = cache.library(its.name, its.uses[0]->where, its.variant);
    } catch (...) {
      jobs[i].error = std::current_exception();
    }
  });
  for (Job &job : jobs) {
    try {
      if (job.error)
        std::rethrow_exception(job.error);
    } catch (const UserError &error) {
      warnings.fail(error.where, error.message);
      continue;
    }
    const Location &where = job.wanted.uses[0]->where;
    AnyslLibrary *library = nullptr;
    if (anysl_library_open(std::filesystem::absolute(job.library).c_str(), 0, &library))
      throw UserError(where, anysl_last_error());
    Opened &opened = *libraries.emplace_back(std::make_unique<Opened>());
    opened.library.reset(library);
    const AnyslLibraryInfo &info = *anysl_library_info(library);
    if (info.layout != uint32_t(layout))
      throw UserError(where, job.library.string() + " is made for runtime \"" + info.runtime +
                                 "\", whose arrays are laid out differently");
    if (libraries.size() > 1 && info.real != uint32_t(format))
      throw UserError(where, "the scene's shaders compute in both float and double");
    format = AnyslReal(info.real);
    opened.wanted = std::move(job.wanted);
    for (const ShaderUse *use : opened.wanted.uses)
      libraryOf[{use, opened.wanted.rays}] = &opened;
  }
}

std::vector<const WantedLibrary *> ShaderLoader::opened() const {
  std::vector<const WantedLibrary *> result;
  for (const auto &library : libraries)
    result.push_back(&library->wanted);
  return result;
}

ShaderLoader::Linked ShaderLoader::linkedForScene() const {
  Linked result;
  // Camera rays, traced ones whatever for, shadow rays.
  auto column = [](RayKind rays) {
    return size_t(rays == RayKind::Camera ? 0 : rays == RayKind::Shadow ? 2 : 1);
  };
  for (const auto &opened : libraries)
    if (anysl_library_demand(opened->library.get()))
      ++result[opened->wanted.name][column(opened->wanted.rays)];
  return result;
}

void ShaderLoader::checkLights(const ShaderUse &opened, const LightSet &lights) const {
  for (const auto &[key, library] : libraryOf) {
    if (key.first != &opened)
      continue;
    const AnyslDemandInfo *demand = anysl_library_demand(library->library.get());
    if (!demand)
      continue;
    // Only lights are in question: what the library does not give, nobody wants of it.
    const AnyslLibraryInfo &info = *anysl_library_info(library->library.get());
    uint64_t written = 0;
    for (uint32_t i = 0; i < info.shader_count; ++i)
      written |= info.shaders[i].globals_written;
    const char *const wanted[] = {written & bits(ANYSL_Ci) ? "Ci" : "Oi", nullptr};
    AnyslSceneFacts facts = {};
    facts.struct_size = sizeof facts;
    facts.outputs =
        (written & bits(ANYSL_Ci, ANYSL_Oi)) == bits(ANYSL_Ci, ANYSL_Oi) ? nullptr : wanted;
    facts.time = demand->time;
    facts.lights = lights.lights.data();
    facts.light_count = uint32_t(lights.lights.size());
    std::copy_n(lights.ambient, 3, facts.ambient);
    if (anysl_library_allows(library->library.get(), &facts))
      throw UserError(opened.where, anysl_last_error());
  }
}

void ShaderLoader::printNotes(std::FILE *file) const {
  for (const shade::NoteLogHandle &log : notes)
    shade::printNotes(log.get(), file);
}

std::unique_ptr<Shader> ShaderLoader::make(const ShaderUse &use, const AnyslServices &services,
                                           const ShaderUse *opened, RayKind rays) {
  if (!opened)
    opened = &use;
  auto found = libraryOf.find({opened, rays});
  if (found == libraryOf.end())
    return nullptr;
  AnyslLibrary *library = found->second->library.get();
  const AnyslShaderInfo *info = nullptr;
  try {
    info = findShader(library, use);
  } catch (const UserError &error) {
    warnings.fail(error.where, error.message);
    return nullptr;
  }
  auto shader = std::make_unique<Shader>();
  shader->scene = &scene;
  shader->use = &use;
  shader->file = std::filesystem::absolute(cache.find(use.name).value_or(use.name));
  shader->info = info;
  shader->space = Space(use.shaderToCamera);
  AnyslInstance *instance = nullptr;
  std::string exact = anysl_kind_name(info->kind) + (":" + std::string(info->name));
  if (anysl_instance_create(library, exact.c_str(), &services, shader.get(), &instance))
    throw UserError(use.where, anysl_last_error());
  shader->instance.reset(instance);
  shader->shade = anysl_shader_entry(info, width);
  shader->width = width;
  if (!shader->shade) { // a library from elsewhere, with other widths
    shader->shade = anysl_shader_entry(info, 0);
    shader->width = anysl_shader_widest(info);
  }
  uint64_t read = info->globals_read, written = info->globals_written;
  shader->source = anysl_library_source(library, info);
  // A co-shader's methods are shaders of their own, which find the globals of who calls them.
  const AnyslLibraryInfo &file = *anysl_library_info(library);
  for (uint32_t i = 0; use.kind == ShaderKind::Any && i < file.shader_count; ++i)
    if (file.shaders[i].kind == ANYSL_METHOD) {
      read |= file.shaders[i].globals_read;
      written |= file.shaders[i].globals_written;
      shader->source.effects |= anysl_library_source(library, &file.shaders[i]).effects;
    }
  shader->needed = neededFor(read);
  shader->globals = read | written;
  setParameters(*shader);
  if (rays == RayKind::Camera) {
    shader->forTraced = make(use, services, opened, RayKind::Traced);
    shader->forShadow = make(use, services, opened, RayKind::Shadow);
  }
  return shader;
}

void ShaderLoader::setParameters(Shader &shader) {
  const ShaderUse &use = *shader.use;
  for (const Parameter &parameter : use.parameters) {
    const AnyslParamInfo *param = anysl_shader_param(shader.info, parameter.name.c_str());
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
