//===-- tools/anysl-render/Scene.h - a scene ready to be rendered -----------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SCENE_H
#define ANYSL_RENDER_SCENE_H

#include "tools/anysl-render/Geometry.h"
#include "tools/anysl-render/Lights.h"
#include "tools/anysl-render/ShaderCache.h"
#include "tools/anysl-render/Spaces.h"

#include <anysl/anysl.h>

namespace anysl::render {

class Scene;

/// A shader library on disk, open.
struct LibraryCloser {
  void operator()(AnyslLibrary *library) const { anysl_library_close(library); }
};
using LibraryHandle = std::unique_ptr<AnyslLibrary, LibraryCloser>;

/// A shader with its parameters' values, as one Surface request states it. Its address is what the
/// shader hands back to every service as `renderer`.
struct SurfaceShader {
  const Scene *scene = nullptr;
  const ShaderUse *use = nullptr;
  Space space; ///< "shader"
  struct Free {
    void operator()(AnyslInstance *instance) const { anysl_instance_free(instance); }
  };
  std::unique_ptr<AnyslInstance, Free> instance;
  AnyslShadeFunction shade = nullptr;
  uint32_t width = 1;
  uint64_t globals = 0; ///< all that it reads or writes, as bits 1 << ANYSL_P ...
  uint64_t needed = 0;  ///< those that it reads
};

/// Points that may share a batch: one shader, one set of lights, and one object where the shader
/// may ask for "object" space.
struct ShadingGroup {
  const SurfaceShader *shader = nullptr; ///< null: the built-in default surface
  const LightSet *lights = nullptr;
  Space object;
};

/// What both hosts work on: surfaces in Embree, shaders with their values, lights, camera. It is
/// constant while it is rendered.
class Scene {
public:
  /// Opens the shaders' libraries and sets their parameters. `services` are the host's.
  /// Throws UserError where a shader is missing, does not compile or does not fit the host.
  Scene(const SceneDescription &description, const ShaderCache &cache,
        const AnyslServices &services, AnyslLayout layout, unsigned width, Warnings &warnings);

  const SceneDescription &description;
  const Camera camera;
  const Spaces spaces;
  const Background background;
  const Geometry &geometry() const { return *surfaces; }
  const ShadingGroup &group(uint32_t index) const { return groups[index]; }
  uint32_t groupCount() const { return uint32_t(groups.size()); }
  /// The number format of all the shaders' batches.
  AnyslReal real() const { return format; }

private:
  void loadShaders(const ShaderCache &cache, const AnyslServices &services, AnyslLayout layout,
                   unsigned width, Warnings &warnings);
  void setParameters(SurfaceShader &shader, Warnings &warnings);
  void makeGroups(Warnings &warnings);

  AnyslReal format = ANYSL_REAL_FLOAT;
  std::map<std::string, LibraryHandle> libraries;
  std::vector<std::unique_ptr<SurfaceShader>> shaders; ///< as description.surfaces
  std::map<std::vector<uint32_t>, LightSet> lightSets;
  std::vector<ShadingGroup> groups;
  std::vector<uint32_t> groupOfShape;
  std::unique_ptr<Geometry> surfaces;
};

} // namespace anysl::render

#endif
