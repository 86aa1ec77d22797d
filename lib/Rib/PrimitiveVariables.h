//===-- lib/Rib/PrimitiveVariables.h - values on surfaces -------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A shape's variables as the scene gives them, and as hits find them: in camera space, as floats,
// indexed by what a piece of the surface knows of itself.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_PRIMITIVEVARIABLES_H
#define ANYSL_LIB_RIB_PRIMITIVEVARIABLES_H

#include "lib/Rib/SceneDescription.h"

namespace anysl::render {

/// What a standard name such as "Cs" is where nobody declares it otherwise; null if the name is
/// none.
const Declaration *standardVariable(std::string_view name);

/// How many values a variable of each storage class has on a shape; a constant one has one.
struct VariableCounts {
  size_t uniform = 1, varying = 1, vertex = 1, faceVarying = 1;
  size_t of(StorageClass storage) const;
  /// Of columns x rows patches, which border on each other round the back where they wrap.
  static VariableCounts ofPatches(size_t columns, size_t rows, bool wrapsU, bool wrapsV,
                                  size_t vertices);
};

/// Gives each variable its declaration, erases those that have none, with a warning, and throws
/// ShapeError where there are more or fewer values than the shape takes.
void checkVariables(ParameterList &variables, const VariableCounts &counts, Warnings &warnings);

/// The places of "P", or of "Pw" divided by their weights, in object space.
std::vector<Vec3d> positions(const ParameterList &variables);
bool hasPositions(const ParameterList &variables);
/// Whether a name is one of those that tell where the shape lies, rather than a value on it.
bool isPosition(std::string_view name);

/// Where a shape lies, and which way it faces.
struct Placement {
  Matrix4 toCamera, toObject;
  bool reverse, oneSided;
  /// The sign of cross(dPdu, dPdv), taken in camera space, that makes it the normal: a matrix that
  /// mirrors turns it round, as does ReverseOrientation.
  double normalSign;

  Placement(const Matrix4 &objectToCamera, const Appearance &appearance);
  /// How much longer lengths become in camera space, on the average of all directions.
  double lengthScale() const;
  /// A normal given in object space, in camera space and of unit length.
  Vec3d normal(Vec3d n) const {
    return normalized(toObject.normalByInverse(n)) * (reverse ? -1. : 1.);
  }
};

/// How a variable's values lie on a mesh.
enum class Domain : uint8_t { Constant, Face, Point, Corner };

struct Variable {
  std::string name;
  ValueType type = ValueType::Float;
  Domain domain = Domain::Constant;
  uint32_t components = 1; ///< of one value, with all elements of an array
  std::vector<float> values;

  const float *at(size_t index) const { return values.data() + index * components; }
};

/// The numbers of one variable in camera space; a homogeneous point becomes a point. "N" becomes
/// of unit length and faces as the shape does. Empty for strings.
Variable cameraVariable(const Parameter &parameter, const Placement &placement);

/// Points of (u, v) in the unit square between values at its corners (0,0) (1,0) (0,1) (1,1), or
/// one value for the whole: what a quadric or a single patch has.
void interpolateCorners(const Variable &variable, double u, double v, float *value);

} // namespace anysl::render

#endif
