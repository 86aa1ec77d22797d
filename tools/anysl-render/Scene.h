//===-- tools/anysl-render/Scene.h - a scene ready to be rendered -----------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SCENE_H
#define ANYSL_RENDER_SCENE_H

#include "lib/Textures/Textures.h"
#include "tools/anysl-render/Bindings.h"
#include "tools/anysl-render/Channels.h"
#include "tools/anysl-render/Geometry.h"
#include "tools/anysl-render/Lights.h"
#include "tools/anysl-render/Shaders.h"

namespace anysl::render {

/// How points have been reached: the rays that shaders have traced between the eye and them.
struct RayPath {
  unsigned depth = 0;             ///< all of these rays
  unsigned diffuse = 0;           ///< those for means over many directions
  RayKind kind = RayKind::Camera; ///< of the last ray

  unsigned shadow() const { return kind == RayKind::Shadow ? 1 : 0; }
  unsigned specular() const { return depth - diffuse - shadow(); }
  RayPath then(RayKind next) const {
    return {depth + 1, diffuse + (next == RayKind::Diffuse ? 1 : 0), next};
  }
};

/// Points that may share a batch: the same shaders, one set of lights, and one object where a
/// shader may ask for "object" space.
struct ShadingGroup {
  const Shader *shader = nullptr; ///< null: the built-in default surface
  /// What says how much light passes, where the shader does; null: it is as opaque as it is anyhow.
  const Shader *shadow = nullptr;
  bool shadowByShader = false; ///< whether its shader is asked, or would be if it changed anything
  /// Volumes: between the eye and the surface, and where rays go that start on its two sides.
  const Shader *atmosphere = nullptr, *interior = nullptr, *exterior = nullptr;
  const LightSet *lights = nullptr;
  uint64_t called = 0; ///< the globals that co-shaders name, as bits
  /// Those that others than the surface's own shaders want to find.
  uint64_t globalsOfOthers() const { return neededFor(lights->globals | called); }
  Space object;
  /// The shader to run where such a ray meets it.
  const Shader *shaderFor(RayKind rays) const {
    return rays == RayKind::Shadow ? shadow : shader ? &shader->of(rays) : nullptr;
  }
  bool matte = false; ///< hides what is behind it from the camera, and is transparent itself
  unsigned maxDiffuseDepth = 1, maxSpecularDepth = 64; ///< of rays that start here
  /// Parameters of the surface shader that take their values from the shapes' variables, which each
  /// shape has in its own places.
  std::vector<Binding> bound;
  /// Of all points, if a shader asks questions by name or calls others.
  const Appearance *appearance = nullptr;
};

/// What both hosts work on: surfaces in Embree, shaders with their values, lights, camera. It is
/// constant while it is rendered.
class Scene {
public:
  /// Opens the shaders' libraries and sets their parameters. `services` are the host's.
  /// Throws UserError where a shader is missing, does not compile or does not fit the host.
  Scene(const SceneDescription &description, const ShaderCache &cache,
        const AnyslServices &services, AnyslLayout layout, unsigned width, Warnings &warnings);

  /// As given, but for shapes of which several have been made.
  SceneDescription description;
  const Camera camera;
  const Spaces spaces;
  const Background background;
  const Geometry &geometry() const { return *surfaces; }
  textures::Textures &pictures() const { return *textures; }
  const Channels &channels() const { return wantedChannels; }
  const Shader *imager() const; ///< or null
  /// One of description.shaders; null where no shape uses it, or it is missing.
  const Shader *shader(int index) const { return shaders[size_t(index)].get(); }
  /// The shader that has moved a shape, with the shape's own values; null: none.
  const Shader *displacementOf(uint32_t shape) const { return displacements[shape]; }
  const ShadingGroup &group(uint32_t index) const { return groups[index]; }
  /// Those of a shape, for the parameters that its group lists.
  std::span<const Binding> bindingsOf(uint32_t shape) const { return bindings[shape]; }
  uint32_t groupCount() const { return uint32_t(groups.size()); }
  /// The number format of all the shaders' batches.
  AnyslReal real() const { return loader.real(); }
  /// The libraries that are open, and for which of the scene's shaders.
  std::vector<const WantedLibrary *> opened() const { return loader.opened(); }
  /// How many libraries each shader has been linked to for this scene, by its name and the rays.
  ShaderLoader::Linked linkedForScene() const { return loader.linkedForScene(); }
  /// What the shaders have noted so far, not while they run.
  void printNotes(std::FILE *file) const { loader.printNotes(file); }

private:
  void loadShaders(const ShaderCache &cache, const AnyslServices &services, Warnings &warnings);
  /// Gives polygons values of their own for their shaders' uniform parameters.
  void splitShapes();
  void makeGroups(const AnyslServices &services, Warnings &warnings);
  /// A shader with values of its own for some parameters; shapes with the same values share it.
  const Shader *specialise(int index, const std::vector<Parameter> &constants,
                           const AnyslServices &services, Warnings &warnings);

  std::unique_ptr<textures::Textures> textures;
  ShaderLoader loader;
  AnyslServices imagerServices = {};            ///< what makes sense without a scene's point
  std::vector<std::unique_ptr<Shader>> shaders; ///< as description.shaders; null where not used
  struct Specialised {
    ShaderUse use;
    std::unique_ptr<Shader> shader;
  };
  std::map<std::string, Specialised> specialised; ///< by shader and values
  std::vector<std::vector<Binding>> bindings;     ///< by shape
  Channels wantedChannels;
  SceneLights lights;
  std::map<std::vector<uint32_t>, LightSet> lightSets;
  std::vector<ShadingGroup> groups;
  std::vector<uint32_t> groupOfShape;
  std::vector<const Shader *> displacements; ///< by shape
  std::unique_ptr<Geometry> surfaces;
};

} // namespace anysl::render

#endif
