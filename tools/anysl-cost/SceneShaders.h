//===-- tools/anysl-cost/SceneShaders.h - the shaders of a RIB scene --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_COST_SCENESHADERS_H
#define ANYSL_TOOLS_ANYSL_COST_SCENESHADERS_H

#include "lib/Shade/Recording.h"
#include "llvm/ADT/SmallString.h"
#include <memory>

namespace anysl::cost {

/// What shades a scene: STC files, and the points at which the renderer beside this program runs
/// their shaders.
class SceneShaders {
public:
  /// Renders the scene once, with the programs in a folder, and compiles the sources that it took.
  /// Throws shade::UserError.
  SceneShaders(const std::string &programs, const std::string &scene);

  const std::vector<std::string> &files() const { return stcFiles; }
  /// Of a shader that the scene uses with several sets of parameters, those of most points first.
  const std::vector<std::shared_ptr<const shade::RecordedShader>> &points() const {
    return recorded;
  }
  /// Libraries that the scene takes as they are, which cannot be linked anew.
  const std::vector<std::string> &libraries() const { return leftOut; }

private:
  /// A folder of temporary files.
  struct Folder {
    Folder();
    ~Folder();
    Folder(const Folder &) = delete;
    Folder &operator=(const Folder &) = delete;
    llvm::SmallString<128> path;
  };
  Folder folder;
  std::vector<std::string> stcFiles, leftOut;
  std::vector<std::shared_ptr<const shade::RecordedShader>> recorded;
};

} // namespace anysl::cost

#endif
