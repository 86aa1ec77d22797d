//===-- tools/anysl-render/Variants.h - what shaders are linked for -----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_VARIANTS_H
#define ANYSL_RENDER_VARIANTS_H

#include "lib/Demand/Demand.h"
#include "tools/anysl-render/ShaderCache.h"

namespace anysl::render {

class SceneLights;

/// What a ray wants of the surfaces that it meets: all that pictures show, light and opacity (from
/// one direction, or for a mean over many), or opacity alone.
enum class RayKind { Camera, Traced, Diffuse, Shadow };

/// A library that a scene wants: a shader, linked for some of its uses.
struct WantedLibrary {
  std::string name;
  ShaderVariant variant;
  std::vector<const ShaderUse *> uses;
  demand::Demand demand = {}; ///< what it is linked for, unless that is any scene
  RayKind rays = RayKind::Camera;
  std::optional<LibraryOutline> outline = {}; ///< where somebody had to know
};

/// Says for what a scene's shaders are linked: uses that switch the same effects off share a
/// library, and a shader has four at most, the last of which then serves all other uses. Of a
/// surface each of these has one more at most for each other kind of ray.
class Variants {
public:
  static constexpr size_t mostOfOne = 4, kindsOfRays = 3;

  Variants(const SceneDescription &scene, const ShaderCache &cache) : scene(scene), cache(cache) {}

  /// The libraries of these uses. Shaders that are missing or do not compile have none, with a
  /// warning, or throw UserError. What earlier uses ask for counts as well.
  std::vector<WantedLibrary> plan(std::span<const ShaderUse *const> uses, Warnings &warnings);

  /// Whether a shader may see what rays meet, of all that plan() has been asked for.
  bool mayTrace() const;

  /// The same library for rays that want less of it, and for some of its uses.
  static WantedLibrary forRays(const WantedLibrary &camera, RayKind rays,
                               std::vector<const ShaderUse *> uses);

  /// From now on surfaces that the same lights shine on are linked for these.
  void linkLights(const SceneLights &given) { lights = &given; }

  /// What the scene calls for, without its shaders' parameters.
  demand::Demand common() const;

private:
  /// The shapes that a surface of one of these uses is on.
  std::vector<const Shape *> shapesOf(const std::vector<const ShaderUse *> &uses) const;
  /// Whether some shader asks lights for more than their light.
  bool asksLights() const;
  /// Adds the lights that shine on all points of these shapes, if they are known.
  /// `areAllThere`: a light shader that cannot be had ends it all.
  void addLights(demand::Demand &demand, std::span<const Shape *const> shapes,
                 bool areAllThere) const;

  const SceneDescription &scene;
  const ShaderCache &cache;
  const SceneLights *lights = nullptr;
  std::map<std::string, ShaderAsking> asking; ///< by the shader's name
};

} // namespace anysl::render

#endif
