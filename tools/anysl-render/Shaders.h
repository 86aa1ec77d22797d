//===-- tools/anysl-render/Shaders.h - shaders with their values ------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SHADERS_H
#define ANYSL_RENDER_SHADERS_H

#include "lib/STC/Effects.h"
#include "lib/Shade/Handles.h"
#include "tools/anysl-render/Spaces.h"
#include "tools/anysl-render/Variants.h"

#include <anysl/demand.h>

#include <set>
#include <span>

namespace anysl::render {

class Scene;
struct LightSet;

/// A shader with its parameters' values, as one request states it. Its address is what the shader
/// hands back to every service as `renderer`.
struct Shader {
  const Scene *scene = nullptr;
  const ShaderUse *use = nullptr;
  std::string file; ///< it comes from: source, STC or library
  Space space;      ///< "shader"
  struct Free {
    void operator()(AnyslInstance *instance) const { anysl_instance_free(instance); }
  };
  std::unique_ptr<AnyslInstance, Free> instance;
  const AnyslShaderInfo *info = nullptr;
  AnyslShadeFunction shade = nullptr;
  uint32_t width = 1;
  uint64_t globals = 0; ///< all that it reads or writes, as bits 1 << ANYSL_P ...
  uint64_t needed = 0;  ///< those that it reads
  /// What its source has, whatever the scene calls for; effects with those of a co-shader's
  /// methods.
  AnyslSourceInfo source = {};

  /// An output parameter that is wanted for a picture.
  struct Output {
    uint32_t param;   ///< number in `info`
    uint32_t channel; ///< number in the scene's list
  };
  std::vector<Output> outputs;

  /// The same linked for what these rays want of it; null: as it is.
  std::unique_ptr<Shader> forTraced, forShadow;
  const Shader &of(RayKind rays) const {
    const auto &other = rays == RayKind::Shadow ? forShadow : forTraced;
    return rays == RayKind::Camera || !other ? *this : *other;
  }
  bool asksFor(stc::Service service) const { return stc::has(info->services, service); }
  /// Whether it asks lights for parameters or sends them values.
  bool asksLights() const { return stc::has(source.effects, stc::Effect::LightValues); }
};

/// The bits of Geometry::evaluate() that ask for these globals.
uint64_t neededFor(uint64_t globals);

/// Whether a value declared in the scene may go into a shader's parameter of an AnyslType.
bool fits(ValueType declared, uint32_t wanted);

/// Opens shader libraries, each file once, and makes shaders of them.
class ShaderLoader {
public:
  /// The layout and width are what the host can work with.
  ShaderLoader(const Scene &scene, const SceneDescription &description, const ShaderCache &cache,
               AnyslLayout layout, unsigned width, Warnings &warnings)
      : scene(scene), cache(cache), variants(description, cache), layout(layout), width(width),
        warnings(warnings) {}

  /// Lets surfaces be linked for the lights that shine on them, which must outlive this.
  void linkLights(const SceneLights &lights) { variants.linkLights(lights); }
  /// Throws UserError if the library that was opened for a surface is linked for other lights.
  void checkLights(const ShaderUse &opened, const LightSet &lights) const;
  /// Finds and compiles what the shaders need, in parallel, and opens it. Throws UserError where
  /// one is missing, does not compile or does not fit the host.
  void open(std::span<const ShaderUse *const> uses);
  /// Does the same for rays that want less of surfaces than the camera, once all is open of which
  /// it depends whether there are such rays.
  void openForRays();
  /// A shader whose library is open, with the values that the request gives its parameters; null
  /// where the user wants to go on without it. Throws
  /// UserError where it is of another kind or a value does not fit. `use` and `services` must
  /// outlive it. `opened`: the use that it was opened for, if not this one.
  std::unique_ptr<Shader> make(const ShaderUse &use, const AnyslServices &services,
                               const ShaderUse *opened = nullptr, RayKind rays = RayKind::Camera);

  /// The libraries that are open, and for which of the scene's shaders.
  std::vector<const WantedLibrary *> opened() const;
  /// How many libraries each shader has been linked to for this scene, by its name and the rays.
  using Linked = std::map<std::string, std::array<unsigned, Variants::kindsOfRays>>;
  Linked linkedForScene() const;

  /// Prints what shaders that were linked for it have noted, each place once.
  void printNotes(std::FILE *file) const;

  /// The number format of all the shaders' batches.
  AnyslReal real() const { return format; }

private:
  struct Close {
    void operator()(AnyslLibrary *library) const { anysl_library_close(library); }
  };
  struct Opened {
    WantedLibrary wanted;
    std::unique_ptr<AnyslLibrary, Close> library;
  };
  /// Leaves out, with a warning, what does not compile.
  void outlineAll(std::vector<WantedLibrary> &wanted);
  void openAll(std::vector<WantedLibrary> wanted);
  /// What is enough of an open library for some of its uses where rays are of a kind; nothing if it
  /// would hardly be smaller.
  std::optional<WantedLibrary> smallerFor(RayKind rays, Opened &opened,
                                          std::vector<const ShaderUse *> uses) const;
  void setParameters(Shader &shader);

  const Scene &scene;
  const ShaderCache &cache;
  Variants variants;
  AnyslLayout layout;
  unsigned width;
  Warnings &warnings;
  AnyslReal format = ANYSL_REAL_FLOAT;
  bool wantsFootprints = false; ///< some shader does
  std::vector<std::unique_ptr<Opened>> libraries;
  std::map<std::pair<const ShaderUse *, RayKind>, Opened *> libraryOf;
  std::vector<shade::NoteLogHandle> notes; ///< of libraries that note something
  size_t logged = 0;                       ///< how many have been asked for a log
};

} // namespace anysl::render

#endif
