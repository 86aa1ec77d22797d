//===-- tools/anysl-render/ShaderCache.h - finding and compiling shaders ----------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SHADERCACHE_H
#define ANYSL_RENDER_SHADERCACHE_H

#include "lib/Rib/Diagnostics.h"

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <vector>

namespace anysl::render {

/// What shaders are compiled for; part of a compiled shader's key.
struct ShaderTarget {
  std::string runtime = "packet", real = "float";
  std::string math; ///< empty: the linker's default
  unsigned width = 8;
  bool checkNaN = false; ///< they note where a number stops being finite
  unsigned maxLoop = 0;  ///< rounds after which loops are left; 0: no limit
};

/// What a shader is asked to compute besides its results.
struct ShaderExtras {
  bool rayDerivatives = false; ///< the rays that it traces carry theirs
  bool tangents = false;       ///< a displacement shader says how P changes
};

/// Finds a shader's file by its name and makes a shader library of it. NAME.so is taken as it is;
/// NAME.stc.bc is linked, NAME.sl compiled and linked, by the programs that lie beside this one,
/// unless the cache folder has the result of the same inputs: source with all it includes, target,
/// processor, and the tools themselves with their runtimes.
///
/// Files appear in the folder under their final name only when complete, so any number of renderers
/// may share it.
class ShaderCache {
public:
  /// An empty folder means $XDG_CACHE_HOME/anysl, else ~/.cache/anysl.
  ShaderCache(std::filesystem::path folder, ShaderTarget target);

  /// Folders that are searched, in order.
  std::vector<std::filesystem::path> searchPath;

  /// The shader's library. Throws UserError, naming the place that asks for the shader, if there is
  /// none or it does not compile. Several threads may call this for different shaders.
  std::filesystem::path library(const std::string &name, const Location &where,
                                ShaderExtras extras = {}) const;

  /// A shader's file, if there is one.
  std::optional<std::filesystem::path> find(const std::string &name) const;

  /// The files that libraries were made from, to be watched for changes.
  std::vector<std::filesystem::path> sources() const;
  /// How many compilations library() has had to do.
  unsigned compilations() const { return compiled; }

private:
  std::string toolKey() const;

  std::filesystem::path folder, tools;
  ShaderTarget target;
  mutable std::atomic<unsigned> compiled = 0;
  mutable std::mutex lock;
  mutable std::vector<std::filesystem::path> used;
};

/// The folder of the running program.
std::filesystem::path programFolder();

} // namespace anysl::render

#endif
