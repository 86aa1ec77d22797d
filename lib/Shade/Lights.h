//===-- lib/Shade/Lights.h - the lights of the command line -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_LIGHTS_H
#define ANYSL_LIB_SHADE_LIGHTS_H

#include "lib/Shade/Handles.h"
#include "lib/Shade/Recording.h"
#include <list>

namespace anysl::shade {

class Lights {
public:
  /// Reads what --light gives, each by itself. Throws UserError.
  Lights(const std::vector<std::string> &descriptions, const AnyslServices &services,
         const Environment &world);

  /// The lights of recorded points, which must outlive this.
  void add(const RecordedShader &recording);

  /// What the lights read of the surface.
  uint64_t globals() const;
  /// Throws UserError if a library was linked for a scene that has no lights like these.
  /// \p results are those that somebody looks at; empty: Ci and Oi.
  void checkAllowed(const AnyslLibrary *library, const std::vector<std::string> &results) const;
  /// Sets the batch's lights. It must not outlive this.
  void shineOn(AnyslBatch *batch) const;

private:
  void addStandard(const std::vector<std::string> &parts);
  void addShader(const std::vector<std::string> &parts, const AnyslServices &services,
                 const Environment &world);
  void add(const std::string &description, const AnyslServices &services, const Environment &world);
  void addLight(AnyslLight light, const std::string &handle);

  std::vector<AnyslLight> lights;
  float ambient[3] = {0, 0, 0};
  std::list<std::string> categories, handles;
  std::list<AnyslStandardLight> standards; ///< what lights of standard kinds are made of
  std::list<Environment> environments;     ///< of each light shader: with a space of its own
  std::vector<LibraryHandle> libraries;
  std::vector<InstanceHandle> instances;
};

} // namespace anysl::shade

#endif
