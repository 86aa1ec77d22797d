//===-- tools/anysl-render/Lights.h - what shines on surfaces, and the sky --------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_LIGHTS_H
#define ANYSL_RENDER_LIGHTS_H

#include "lib/Demand/Demand.h"
#include "tools/anysl-render/AreaLights.h"
#include "tools/anysl-render/Shaders.h"

#include <memory>

namespace anysl::render {

/// The lights that shine on a surface, as its shader gets them.
struct LightSet {
  std::vector<AnyslLight> lights;
  /// What those of standard kinds are made of.
  std::vector<std::shared_ptr<const AnyslStandardLight>> standards;
  float ambient[3] = {};
  bool hasShaders = false; ///< whether one of the lights is a light shader
  uint64_t globals = 0;    ///< what those read of the surface
};

/// Whether a light is one of the standard's: no shader of that name is on the scene's path, or only
/// the one that comes with this program.
bool isStandardLight(const std::string &name, const ShaderCache &cache);

/// What a demand calls the kind of a light shader: another light of a standard one's name may do
/// anything.
std::string kindOfShader(const std::string &light);

/// The lights of a scene. ambientlight, distantlight, pointlight and spotlight are data, with the
/// parameters of the RenderMan Interface's standard lights and __nondiffuse, __nonspecular and
/// __category, unless the scene's shader path has other shaders of these names, or some shader asks
/// for lights' parameters or sends values to them. All others are light shaders.
class SceneLights {
public:
  /// Lights whose shaders there are not get a warning and are left out.
  SceneLights(const SceneDescription &scene, const ShaderCache &cache, Warnings &warnings);

  /// The light shaders that shapes are lit by.
  std::span<const ShaderUse *const> shaders() const { return uses; }
  /// Lets the standard lights be shaders too, which are to be opened besides.
  std::vector<const ShaderUse *> runStandard(const ShaderCache &cache);
  /// Makes the light shaders, whose libraries are open. Throws UserError as the loader does.
  void load(ShaderLoader &loader, const AnyslServices &services);
  /// What shaders may be linked for where exactly these lights shine, before any is loaded.
  struct Known {
    std::vector<demand::LightDemand> each;
    bool hasShaders = false;                     ///< whether one of them is a light shader
    bool hasAmbient = false;                     ///< whether there are ambient ones besides
    std::optional<std::array<float, 3>> ambient; ///< what those add up to
  };
  Known known(const std::vector<uint32_t> &indices) const;
  /// The lights with these indices.
  LightSet set(const std::vector<uint32_t> &indices, Warnings &warnings) const;

private:
  const ShaderUse *useShader(uint32_t index);
  void addShader(const LightUse &use, const Shader &shader, LightSet &set) const;
  void addStandard(const LightUse &use, LightSet &set, Warnings &warnings) const;
  /// The light, or as many as its shapes have samples.
  void spread(const LightUse &use, const AnyslLight &light, LightSet &set) const;
  static void keepValues(AnyslLight &light, AnyslStandardLight values, LightSet &set);

  const SceneDescription &scene;
  std::vector<std::unique_ptr<ShaderUse>> useOf; ///< by light; null: no light shader
  std::vector<std::unique_ptr<Shader>> shaderOf; ///< by light
  std::vector<bool> standard;                    ///< by light
  std::vector<std::vector<AreaSample>> samples;  ///< by light, of its shapes
  std::vector<const ShaderUse *> uses;
};

/// Keeps what light shaders give as long as a batch is shaded.
class LightScope {
public:
  LightScope(AnyslShadeArgs &args, const LightSet &lights)
      : args(lights.hasShaders ? &args : nullptr) {
    if (this->args)
      anysl_lights_begin(this->args);
  }
  ~LightScope() {
    if (args)
      anysl_lights_end(args);
  }
  LightScope(const LightScope &) = delete;
  LightScope &operator=(const LightScope &) = delete;

private:
  AnyslShadeArgs *args;
};

/// The light from beyond all surfaces: a sky that is brighter or darker towards the world's +y.
class Background {
public:
  explicit Background(const SceneDescription &scene);
  bool isVisible() const { return visible; }
  Vec3f color(Vec3f direction) const;

private:
  bool visible;
  Vec3f up, zenith, horizon, ground;
};

} // namespace anysl::render

#endif
