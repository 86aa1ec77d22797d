//===-- tools/anysl-link/Scene.cpp - the scene to link for ----------------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-link/Scene.h"

#include "lib/Rib/RibReader.h"
#include "lib/STC/Asking.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/LLVMContext.h"

using namespace llvm;

namespace anysl {
namespace {

/// Adds what shaders that are not linked ask for, and whether they trace; a file that is wrong is
/// an error.
bool addBeside(DiagnosticEngine &diags, ArrayRef<std::string> beside, demand::Demand &scene,
               std::set<std::string> &shaders) {
  LLVMContext context;
  std::set<std::string> asked;
  if (scene.asked)
    asked.insert(scene.asked->begin(), scene.asked->end());
  bool isKnown = scene.asked.has_value();
  for (const std::string &path : beside) {
    auto file = stc::readFile(diags, context, path);
    if (!file)
      return false;
    for (const stc::ShaderInfo &shader : file->shaders)
      shaders.insert(shader.name);
    if (stc::tracesForOthers(*file))
      scene.othersTrace = true;
    auto names = stc::askedNames(*file->module);
    isKnown &= names.has_value();
    if (names)
      asked.insert(names->begin(), names->end());
  }
  scene.asked.reset();
  if (isKnown)
    scene.asked.emplace(asked.begin(), asked.end());
  return true;
}

/// The scene's shaders that are in no file at hand. The standard lights ask for nothing.
std::string missing(const demand::Demand &scene, const std::set<std::string> &shaders) {
  std::string result;
  for (const auto &[name, shader] : scene.shaders)
    if (!shaders.contains(name) && name != demand::ambientLight &&
        demand::standardKind(name) == ANYSL_LIGHT_SHADER)
      result += (result.empty() ? "'" : ", '") + name + "'";
  return result;
}

std::optional<demand::Demand> read(DiagnosticEngine &diags, const std::string &path,
                                   ArrayRef<std::string> linked, ArrayRef<std::string> beside) {
  auto file = render::loadSourceFile(path);
  std::set<std::string> shaders;
  for (const std::string &name : linked)
    shaders.insert(demand::shaderName(name));
  if (StringRef(path).ends_with(".json")) {
    demand::Demand scene = demand::readManifest(file);
    if (!addBeside(diags, beside, scene, shaders))
      return std::nullopt;
    return scene;
  }
  render::Warnings warnings(nullptr); // the renderer gives them
  std::vector<render::SceneDescription> scenes = render::readRib(file, warnings);
  if (scenes.size() != 1) {
    diags.error(FilePosition{path}, "there are " + Twine(scenes.size()) +
                                        " worlds in this file; it has to be one to link for it");
    return std::nullopt;
  }
  demand::Demand scene = demand::demandOfAll(scenes[0]);
  scene.asked.emplace();
  scene.othersTrace = false;
  if (!addBeside(diags, beside, scene, shaders))
    return std::nullopt;
  std::string unknown = missing(scene, shaders);
  if (!unknown.empty())
    scene.othersTrace = true;
  if (!unknown.empty() && scene.asked) {
    static constexpr WarningGroup Beside{"beside", true};
    diags.warning(FilePosition{path}, Beside,
                  "nobody knows what shaders " + unknown +
                      " of this scene ask for, so that parameters and outputs are kept; name their "
                      "files with --beside");
    scene.asked.reset();
  }
  return scene;
}

} // namespace

std::optional<demand::Demand> readScene(DiagnosticEngine &diags, const std::string &path,
                                        const std::vector<std::string> &linked,
                                        const std::vector<std::string> &beside) {
  try {
    return read(diags, path, linked, beside);
  } catch (const render::UserError &error) {
    FilePosition position;
    if (error.where.file) {
      size_t line, column;
      error.where.lineAndColumn(line, column);
      position = {error.where.file->name, unsigned(line), unsigned(column)};
    }
    diags.error(position, error.message);
    return std::nullopt;
  }
}

} // namespace anysl
