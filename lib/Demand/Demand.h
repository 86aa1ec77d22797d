//===-- lib/Demand/Demand.h - what a scene calls for --------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_DEMAND_DEMAND_H
#define ANYSL_LIB_DEMAND_DEMAND_H

#include "lib/Rib/SceneDescription.h"

#include <anysl/demand.h>

#include <set>
#include <span>

namespace anysl::demand {

/// The value that a scene gives a parameter.
struct Value {
  std::vector<double> numbers; ///< empty: it is text
  std::string text;
  std::string from; ///< who gives it: "scene.rib:12"
};

/// What the scene says of a shader's parameters.
struct ShaderDemand {
  /// Nothing as a value: the renderer sets it, to what is not known here.
  std::map<std::string, std::optional<Value>, std::less<>> parameters;
  /// Those that are not named keep their defaults.
  bool complete = false;
};

/// A light that shines on all points that a shader is run for, as far as it is known.
struct LightDemand {
  std::string kind; ///< the name of its light source or light shader
  AnyslLinkedLight values = {};
  std::string category;    ///< if it is known; `values` have none
  ShaderDemand parameters; ///< of a light shader
};

/// What a scene calls for. What is not said is not known, and kept.
struct Demand {
  std::map<std::string, ShaderDemand, std::less<>> shaders;
  /// Globals that are the same at all points that surfaces are run for: "Cs", "Os".
  std::map<std::string, std::array<double, 3>, std::less<>> globals;
  /// The outputs that somebody looks at: output parameters, "Ci", "Oi".
  std::optional<std::vector<std::string>> outputs;
  /// Names of parameters that other shaders of the scene ask for or set.
  std::optional<std::vector<std::string>> asked;
  /// The kinds of lights that shine: "ambientlight", "distantlight", a light shader's name.
  std::optional<std::vector<std::string>> lights;
  /// The lights that shine, each of them, in the order in which the renderer has them; ambient ones
  /// do not count. Nothing: any number of those kinds, or not the same on all points.
  std::optional<std::vector<LightDemand>> eachLight;
  /// What ambient ones add up to.
  std::optional<std::array<float, 3>> ambient;
  std::optional<bool> shadows; ///< whether some light casts shadows
  /// Whether shaders that run for points of others (lights, volumes, methods) trace rays there.
  std::optional<bool> othersTrace;
  std::optional<unsigned> rayDepth;
  std::optional<std::vector<std::string>> textures;
  std::optional<bool> displacement, atmosphere, imager, lens;
  std::optional<std::array<double, 2>> shutter; ///< when it opens and closes

  /// Whether somebody looks at "Ci" or at "Oi": at both, unless `outputs` names just one of them.
  bool looksAt(std::string_view light) const;

  /// Bits 1 << ANYSL_ASSUMES_... of what a library for this scene may take for granted.
  uint32_t assumptions() const;
  /// The lights to be linked in; none if they are not known or there are too many.
  std::span<const LightDemand> linkedLights() const;
  /// Makes these the lights that shine, each of them. `hasAmbient`: and ambient ones besides, which
  /// add up to `sum`, if that is known.
  void setLights(std::vector<LightDemand> each, bool hasAmbient,
                 std::optional<std::array<float, 3>> sum = std::nullopt);
};

/// The AnyslLightKind of a light source of the standard; ANYSL_LIGHT_SHADER of any other, and of
/// "ambientlight".
uint32_t standardKind(std::string_view source);
/// The light source of a standard's AnyslLightKind.
const char *sourceOf(uint32_t standardKind);
/// The values that a light of a standard kind has and a manifest can give, bits ANYSL_KNOWN_...:
/// those that are finite.
uint32_t finiteFields(const AnyslLight &light);
/// The standard's ambient lights, which AnyslShadeArgs has as one sum.
inline constexpr std::string_view ambientLight = "ambientlight";

/// Reads a manifest (docs/effects.md). Throws UserError with the place of what is wrong in it.
Demand readManifest(const std::shared_ptr<const render::SourceFile> &file);
/// The manifest of a demand, on one line: equal demands give equal texts. Without `places` it does
/// not say who gives a value.
std::string writeManifest(const Demand &demand, bool places = true);

/// The flags that are known of a light shader: one that is to cast shadows may look for them
/// itself.
inline uint32_t shadowsKnownOf(const render::LightUse &shader) {
  return shader.castsShadow ? 0 : ANYSL_LIGHT_CASTS_SHADOW;
}

/// The lights that shine on some shape: indices into SceneDescription::lights.
std::set<uint32_t> usedLights(const render::SceneDescription &scene);

/// What a scene says apart from its shaders' parameters. Some reader of the shaders has to find out
/// what they ask each other.
Demand demandOf(const render::SceneDescription &scene);
/// The names of shapes' variables, which go into parameters of these names.
std::set<std::string> variablesOf(const render::SceneDescription &scene);
/// Adds what the uses of one shader have in common.
void addShader(Demand &demand, const std::set<std::string> &variables,
               std::span<const render::ShaderUse *const> uses);
/// Sorts the uses of one shader by what they can have in common: those that state the same
/// parameters, and of these the same ones as nothing (0, or empty text), go together, since that is
/// what effects are switched off with. At most `most` groups, in the order of the uses; the last of
/// these then has all that are left.
std::vector<std::vector<const render::ShaderUse *>>
alikeUses(std::span<const render::ShaderUse *const> uses, size_t most);
/// The globals that are the same on some shapes, as the scene states them.
std::map<std::string, std::array<double, 3>, std::less<>>
fixedGlobals(const render::SceneDescription &scene, std::span<const render::Shape *const> shapes);
/// A scene's demand with all its shaders.
Demand demandOfAll(const render::SceneDescription &scene);

/// The name of the shader that a file holds by its own: without folders and suffixes.
std::string shaderName(const std::string &file);
/// "scene.rib:12".
std::string placeOf(const render::Location &where);

} // namespace anysl::demand

#endif
