//===-- lib/Rib/PrimitiveVariables.cpp - values on surfaces -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/PrimitiveVariables.h"

#include <algorithm>

using namespace anysl::render;

const Declaration *anysl::render::standardVariable(std::string_view name) {
  static const std::map<std::string_view, Declaration> standard = {
      {"P", {StorageClass::Vertex, ValueType::Point, 0}},
      {"Pz", {StorageClass::Vertex, ValueType::Float, 0}},
      {"Pw", {StorageClass::Vertex, ValueType::HPoint, 0}},
      {"N", {StorageClass::Varying, ValueType::Normal, 0}},
      {"Np", {StorageClass::Uniform, ValueType::Normal, 0}},
      {"Cs", {StorageClass::Varying, ValueType::Color, 0}},
      {"Os", {StorageClass::Varying, ValueType::Color, 0}},
      {"s", {StorageClass::Varying, ValueType::Float, 0}},
      {"t", {StorageClass::Varying, ValueType::Float, 0}},
      {"st", {StorageClass::Varying, ValueType::Float, 2}},
      {"width", {StorageClass::Varying, ValueType::Float, 0}},
      {"constantwidth", {StorageClass::Constant, ValueType::Float, 0}}};
  auto entry = standard.find(name);
  return entry == standard.end() ? nullptr : &entry->second;
}

size_t VariableCounts::of(StorageClass storage) const {
  switch (storage) {
  case StorageClass::Constant:
    return 1;
  case StorageClass::Uniform:
    return uniform;
  case StorageClass::Varying:
    return varying;
  case StorageClass::Vertex:
    return vertex;
  case StorageClass::FaceVarying:
    return faceVarying;
  }
  return 1;
}

VariableCounts VariableCounts::ofPatches(size_t columns, size_t rows, bool wrapsU, bool wrapsV,
                                         size_t vertices) {
  return {.uniform = columns * rows,
          .varying = (columns + !wrapsU) * (rows + !wrapsV),
          .vertex = vertices,
          .faceVarying = columns * rows * 4};
}

void anysl::render::checkVariables(ParameterList &variables, const VariableCounts &counts,
                                   Warnings &warnings) {
  static constexpr const char *storageNames[] = {"constant", "uniform", "varying", "vertex",
                                                 "facevarying"};
  std::erase_if(variables, [&](Parameter &variable) {
    if (!variable.declaration)
      if (const Declaration *standard = standardVariable(variable.name))
        variable.declaration = *standard;
    if (!variable.declaration)
      warnings.warnOnce("variable " + variable.name, variable.where,
                        "\"" + variable.name +
                            "\" is not declared and has no effect; say what it is, as in "
                            "\"varying float " +
                            variable.name + "\"");
    return !variable.declaration;
  });
  for (const Parameter &variable : variables) {
    const Declaration &declaration = *variable.declaration;
    bool isText = declaration.type == ValueType::String;
    if (isText ? !variable.numbers.empty() : !variable.strings.empty())
      throw ShapeError(variable.where, "\"" + variable.name + "\" is declared as " +
                                           (isText ? "text" : "numbers") + ", and this is none");
    size_t values = counts.of(declaration.storage);
    size_t each = componentCount(declaration.type) * std::max(1u, declaration.arrayLength);
    size_t given = isText ? variable.strings.size() : variable.numbers.size();
    if (given != each * values)
      throw ShapeError(variable.where,
                       "\"" + variable.name + "\": expected " + std::to_string(each * values) +
                           (isText ? " strings, " : " numbers, ") + std::to_string(values) + " " +
                           storageNames[size_t(declaration.storage)] +
                           (values == 1 ? " value" : " values") + " of " + std::to_string(each) +
                           ", found " + std::to_string(given));
    for (double number : variable.numbers)
      if (!std::isfinite(number))
        throw ShapeError(variable.where, "\"" + variable.name + "\" has a number that is none");
  }
}

bool anysl::render::isPosition(std::string_view name) {
  return name == "P" || name == "Pw" || name == "Pz";
}

bool anysl::render::hasPositions(const ParameterList &variables) {
  return findParameter(variables, "P") || findParameter(variables, "Pw");
}

std::vector<Vec3d> anysl::render::positions(const ParameterList &variables) {
  std::vector<Vec3d> result;
  if (const Parameter *p = findParameter(variables, "P")) {
    for (size_t i = 0; i + 2 < p->numbers.size(); i += 3)
      result.emplace_back(p->numbers[i], p->numbers[i + 1], p->numbers[i + 2]);
  } else if (const Parameter *pw = findParameter(variables, "Pw")) {
    for (size_t i = 0; i + 3 < pw->numbers.size(); i += 4)
      result.push_back(Vec3d(pw->numbers[i], pw->numbers[i + 1], pw->numbers[i + 2]) *
                       (1 / pw->numbers[i + 3]));
  }
  return result;
}

Placement::Placement(const Matrix4 &objectToCamera, const Appearance &appearance)
    : toCamera(objectToCamera), toObject(objectToCamera.inverse()),
      reverse(appearance.reverseOrientation), oneSided(appearance.sides == 1) {
  Vec3d x = toCamera.vector({1, 0, 0}), y = toCamera.vector({0, 1, 0});
  bool mirrors = dot(cross(x, y), toCamera.vector({0, 0, 1})) < 0;
  normalSign = mirrors != reverse ? -1 : 1;
}

double Placement::lengthScale() const {
  Vec3d x = toCamera.vector({1, 0, 0}), y = toCamera.vector({0, 1, 0});
  return std::cbrt(std::fabs(dot(cross(x, y), toCamera.vector({0, 0, 1}))));
}

Variable anysl::render::cameraVariable(const Parameter &parameter, const Placement &placement) {
  Variable result;
  result.name = parameter.name;
  result.type = parameter.declaration->type;
  uint32_t size = componentCount(result.type);
  const std::vector<double> &n = parameter.numbers;
  if (result.type == ValueType::HPoint) {
    result.type = ValueType::Point;
    for (size_t i = 0; i + 3 < n.size(); i += 4) {
      Vec3d p = placement.toCamera.point(Vec3d(n[i], n[i + 1], n[i + 2]) * (1 / n[i + 3]));
      result.values.insert(result.values.end(), {float(p.x), float(p.y), float(p.z)});
    }
    size = 3;
  } else {
    result.values.assign(n.begin(), n.end());
  }
  result.components = size * std::max(1u, parameter.declaration->arrayLength);
  bool isNormal = parameter.name == "N" || parameter.name == "Np";
  if (parameter.declaration->type != ValueType::Point && result.type != ValueType::Vector &&
      result.type != ValueType::Normal)
    return result;
  for (size_t i = 0; i + 2 < n.size(); i += 3) {
    Vec3d value(n[i], n[i + 1], n[i + 2]);
    if (result.type == ValueType::Point)
      value = placement.toCamera.point(value);
    else if (result.type == ValueType::Vector)
      value = placement.toCamera.vector(value);
    else
      value = isNormal ? placement.normal(value) : placement.toObject.normalByInverse(value);
    for (int k = 0; k < 3; ++k)
      result.values[i + size_t(k)] = float(value[k]);
  }
  return result;
}

void anysl::render::interpolateCorners(const Variable &variable, double u, double v, float *value) {
  if (variable.domain == Domain::Constant) {
    std::copy_n(variable.at(0), variable.components, value);
    return;
  }
  const double weights[4] = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
  for (uint32_t k = 0; k < variable.components; ++k) {
    double sum = 0;
    for (size_t corner = 0; corner < 4; ++corner)
      sum += weights[corner] * double(variable.at(corner)[k]);
    value[k] = float(sum);
  }
}
