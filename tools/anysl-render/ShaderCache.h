//===-- tools/anysl-render/ShaderCache.h - finding and compiling shaders ----------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SHADERCACHE_H
#define ANYSL_RENDER_SHADERCACHE_H

#include "lib/Demand/Json.h"
#include "tools/anysl-render/CacheFolder.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace anysl::render {

/// What shaders are compiled for; part of a compiled shader's key.
struct ShaderTarget {
  std::string runtime = "packet", real = "float";
  std::string math; ///< empty: the linker's default
  unsigned width = 8;
  bool checkNaN = false;  ///< they note where a number stops being finite
  unsigned maxLoop = 0;   ///< rounds after which loops are left; 0: no limit
  bool specialise = true; ///< they are linked for the scene; false: for any
  /// Effects to be left out all the same, as anysl-link --without-effect takes them.
  std::vector<std::string> withoutEffects;
};

/// What a shader is linked for besides the target.
struct ShaderVariant {
  std::string manifest;        ///< of what the scene calls for (docs/effects.md); empty: anything
  bool rayDerivatives = false; ///< the rays that it traces carry theirs
  bool tangents = false;       ///< a displacement shader says how P changes
  std::string withPlaces;      ///< the manifest with who says what, for reports
  std::vector<std::string> lights; ///< light shaders that may be linked in
};

/// What a scene has to know of one of its shaders before any is linked for it.
struct ShaderAsking {
  /// Names of parameters that it may ask other shaders for, or set; nothing: any.
  std::optional<std::vector<std::string>> names;
  /// Whether it runs for other shaders' points and traces rays there.
  bool tracesForOthers = true;
  /// Whether it may ask lights for parameters, send them values, or ask for their names.
  bool asksLights = true;
  /// Whether it may see what rays meet.
  bool traces = true;
};

/// What a library will be, as far as it is known before code is optimised.
struct LibraryOutline {
  bool wantsFootprints = false; ///< some shader asks how much of a surface a pixel sees
  bool traces = false;          ///< some shader sees what rays meet
  double instructions = 0;      ///< of all shaders for one point
};

/// Finds a shader's file by its name and makes a shader library of it. NAME.so is taken as it is;
/// NAME.stc.bc is linked, NAME.sl compiled and linked, by the programs that lie beside this one,
/// unless the cache folder has the result of the same inputs: source with all it includes, target,
/// what it is linked for, processor, and the tools themselves with their runtimes.
///
/// Any number of renderers may share the folder (CacheFolder.h).
class ShaderCache {
public:
  ShaderCache(const CachePlace &place, ShaderTarget target);

  /// Folders that are searched, in order.
  std::vector<std::filesystem::path> searchPath;

  /// The shader's library. Throws UserError, naming the place that asks for the shader, if there is
  /// none or it does not compile. Several threads may call this.
  std::filesystem::path library(const std::string &name, const Location &where,
                                const ShaderVariant &variant = {}) const;

  /// What the library will be. Throws as library() does.
  LibraryOutline outline(const std::string &name, const Location &where,
                         const ShaderVariant &variant) const;

  /// What anysl-link tells of it (--report). Throws as library() does.
  demand::Json report(const std::string &name, const Location &where,
                      const ShaderVariant &variant) const;

  /// What a shader asks of others; of a library nobody knows. Throws as library() does.
  ShaderAsking asking(const std::string &name, const Location &where) const;

  /// Whether shaders are to be linked for their scene.
  bool specialises() const { return target.specialise; }

  /// A shader's file, if there is one.
  std::optional<std::filesystem::path> find(const std::string &name) const;

  /// The files that libraries were made from, to be watched for changes.
  std::vector<std::filesystem::path> sources() const;
  /// How many compilations library() has had to do.
  unsigned compilations() const { return compiled; }

private:
  struct Source;
  std::string toolKey() const;
  Source lookUp(const std::string &name, const Location &where) const;
  /// The light shaders of a variant. One of a standard light's name goes by another there.
  std::vector<Source> lightsOf(const ShaderVariant &variant, const Location &where) const;
  std::filesystem::path threadedCode(const Source &source) const;
  /// Runs the linker; `more`: what it is to write.
  void link(const Source &source, const ShaderVariant &variant, const std::filesystem::path &output,
            std::vector<std::string> more) const;
  /// The key of what is linked of a source in a variant; `form`: what of it.
  std::string keyOf(const Source &source, const ShaderVariant &variant,
                    const std::string &form) const;
  std::filesystem::path make(const Source &source, const std::string &name,
                             const std::function<void(const std::filesystem::path &)> &write) const;
  void run(const Source &source, std::vector<std::string> command,
           const std::filesystem::path &output = {}) const;

  CacheFolder folder;
  std::filesystem::path tools;
  ShaderTarget target;
  std::string toolsUsed; ///< what they are, as a key
  mutable std::atomic<unsigned> compiled = 0;
  mutable std::mutex lock;
  mutable std::vector<std::filesystem::path> used;
};

/// The folder of the running program.
std::filesystem::path programFolder();

} // namespace anysl::render

#endif
