//===-- lib/Shade/Environment.h - a world in closed form ----------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What the renderer's services answer when there is no renderer: a world simple enough that every
// answer is a formula, so that tests can compute it. With d = R / |R|:
//
//   trace         sky        d.z >= 0: (0.9, 0.95, 1) (1 - d.z) + (0.25, 0.5, 0.9) d.z, a sky paler
//   at the horizon
//                            d.z < 0:  (0.3, 0.25, 0.2), the ground
//                 direction  (1 + d) / 2, the direction as a colour
//                 black      0
//                 A zero R arrives from nowhere: black.
//   trace distance, transmission: of the ground, the plane z = -1; black has none (1e30, 1)
//   what rays hit the ground, with its colour and opacity 1
//   textures      files, see Pictures.h
//   space matrix  the identity for "current", "camera", "world", "object", "shader" and "", and
//   what --space gives
//   query         rendererinfo "renderer" is "anysl-shade"; rayinfo "depth" 0 and "type" "camera";
//   else
//                 what the command line gives; textureinfo what the file says
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_ENVIRONMENT_H
#define ANYSL_LIB_SHADE_ENVIRONMENT_H

#include "lib/Shade/Pictures.h"
#include <anysl/anysl.h>
#include <array>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace anysl::shade {

using Matrix = std::array<double, 16>; ///< row by row, for row vectors

enum class Surroundings { Sky, Direction, Black };

/// A value whose type is whatever a shader asks for, if the number of its components fits.
struct KnownValue {
  std::vector<std::string> texts;
  std::vector<double> numbers; ///< the same, if they all are numbers
};

struct Environment {
  Surroundings surroundings = Surroundings::Sky;
  bool surroundingsGiven = false;          ///< by the command line
  std::map<std::string, Matrix> toCurrent; ///< by name of the coordinate system
  std::set<std::string> givenSpaces;       ///< those that the command line names
  std::FILE *printTo = stdout;             ///< what shaders print
  /// What answers queries, by kind and name; that of a texture by "FILE:NAME".
  std::map<std::pair<uint32_t, std::string>, KnownValue> answers;
  std::shared_ptr<Pictures> pictures = std::make_shared<Pictures>();
  std::map<std::string, const AnyslInstance *> coshaders; ///< by handle; Grid owns them

  Environment();
};

/// The services of this world; the renderer pointer that goes with them is an Environment.
AnyslServices environmentServices();

/// The inverse, or nothing that is finite where there is none.
Matrix inverse(const Matrix &matrix);

} // namespace anysl::shade

#endif
