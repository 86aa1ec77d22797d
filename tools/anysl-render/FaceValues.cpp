//===-- tools/anysl-render/FaceValues.cpp - values of single faces ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/FaceValues.h"
#include "lib/Rib/PrimitiveVariables.h"

#include <algorithm>
#include <map>

using namespace anysl::render;

namespace {

/// Whether a variable goes to a parameter that cannot have several values in a shape.
bool wantsOneValue(const Parameter &variable, const Shader &shader) {
  const Declaration &declaration = *variable.declaration;
  const AnyslParamInfo *param = anysl_shader_param(shader.info, variable.name.c_str());
  return param && fits(declaration.type, param->type) &&
         declaration.arrayLength == param->array_length &&
         (declaration.type == ValueType::String || !(param->flags & ANYSL_PARAM_VARYING));
}

/// Those of a variable's values that have these numbers, in this order.
Parameter pick(const Parameter &variable, std::span<const uint32_t> items) {
  Parameter result{variable.name, variable.declaration, {}, {}, variable.where};
  size_t each = std::max(1u, variable.declaration->arrayLength);
  auto append = [&](auto &to, const auto &from, size_t size) {
    for (uint32_t item : items)
      to.insert(to.end(), from.begin() + std::ptrdiff_t(item * size),
                from.begin() + std::ptrdiff_t((item + 1) * size));
  };
  if (variable.declaration->type == ValueType::String)
    append(result.strings, variable.strings, each);
  else
    append(result.numbers, variable.numbers, each * componentCount(variable.declaration->type));
  return result;
}

/// The faces with the same values of the variables that need one for a whole shape, in the order of
/// their first ones.
struct FaceGroups {
  std::vector<uint32_t> ofFace;
  std::vector<std::vector<uint32_t>> faces;

  FaceGroups(uint32_t count, const std::vector<const Parameter *> &split) {
    std::map<std::pair<std::vector<double>, std::vector<std::string>>, uint32_t> numbers;
    for (uint32_t face = 0; face < count; ++face) {
      std::pair<std::vector<double>, std::vector<std::string>> values;
      for (const Parameter *variable : split) {
        Parameter value = pick(*variable, std::span(&face, 1));
        values.first.insert(values.first.end(), value.numbers.begin(), value.numbers.end());
        values.second.insert(values.second.end(), value.strings.begin(), value.strings.end());
      }
      uint32_t group = numbers.try_emplace(std::move(values), uint32_t(faces.size())).first->second;
      if (group == faces.size())
        faces.emplace_back();
      faces[group].push_back(face);
      ofFace.push_back(group);
    }
  }
};

/// How many values a variable of class uniform has; 0 where faces are not told apart.
template <class Geometry>
uint32_t faceCount(const Geometry &geometry) {
  if constexpr (std::is_same_v<Geometry, PolygonShape>)
    return uint32_t(geometry.loopCounts.size());
  else if constexpr (std::is_same_v<Geometry, PatchShape>)
    return geometry.u.segments(geometry.cubic) * geometry.v.segments(geometry.cubic);
  else if constexpr (std::is_same_v<Geometry, NurbsShape>)
    return geometry.u.segments() * geometry.v.segments();
  else if constexpr (std::is_same_v<Geometry, SubdivisionShape>)
    return uint32_t(geometry.vertexCounts.size());
  else
    return 0;
}

/// What a variable that is split has in all of a group.
Parameter commonValue(const Parameter &variable, const std::vector<uint32_t> &faces) {
  Parameter result = pick(variable, std::span(faces).first(1));
  result.declaration->storage = StorageClass::Constant;
  return result;
}

bool isAmong(const std::vector<const Parameter *> &split, const Parameter &variable) {
  return std::find(split.begin(), split.end(), &variable) != split.end();
}

/// Parts of a smooth mesh: the faces around those that are drawn shape them, and u and v stay.
template <class Geometry>
std::vector<Shape> partsOf(const Geometry &geometry, const Shape &whole,
                           const std::vector<const Parameter *> &split, const FaceGroups &groups) {
  std::vector<Shape> result;
  if constexpr (requires { geometry.drawn; })
    for (const std::vector<uint32_t> &faces : groups.faces) {
      Geometry part = geometry;
      part.drawn.faces = faces;
      Shape &shape = result.emplace_back(
          Shape{std::move(part), {}, whole.objectToCamera, whole.appearance, whole.where});
      for (const Parameter &variable : whole.variables)
        shape.variables.push_back(isAmong(split, variable) ? commonValue(variable, faces)
                                                           : variable);
    }
  return result;
}

/// Some of the polygons of a shape, and the places of their values in its variables.
struct Part {
  PolygonShape geometry;
  std::vector<uint32_t> corners, points;
};

Shape shapeOf(Part &part, const std::vector<uint32_t> &faces, const Shape &whole,
              const std::vector<const Parameter *> &split) {
  Shape result{std::move(part.geometry), {}, whole.objectToCamera, whole.appearance, whole.where};
  for (const Parameter &variable : whole.variables) {
    switch (variable.declaration->storage) {
    case StorageClass::Constant:
      result.variables.push_back(variable);
      break;
    case StorageClass::Uniform:
      result.variables.push_back(isAmong(split, variable) ? commonValue(variable, faces)
                                                          : pick(variable, faces));
      break;
    case StorageClass::Varying:
    case StorageClass::Vertex:
      result.variables.push_back(pick(variable, part.points));
      break;
    case StorageClass::FaceVarying:
      result.variables.push_back(pick(variable, part.corners));
      break;
    }
  }
  return result;
}

std::vector<Shape> partsOf(const PolygonShape &polygons, const Shape &whole,
                           const std::vector<const Parameter *> &split, const FaceGroups &groups) {
  std::vector<Part> parts(groups.faces.size());
  std::vector<std::map<uint32_t, uint32_t>> numbers(parts.size()); // of the points in each part
  uint32_t loop = 0, corner = 0;
  for (uint32_t face = 0; face < polygons.loopCounts.size(); ++face) {
    uint32_t number = groups.ofFace[face];
    Part &part = parts[number];
    part.geometry.loopCounts.push_back(polygons.loopCounts[face]);
    for (uint32_t i = 0; i < polygons.loopCounts[face]; ++i, ++loop) {
      part.geometry.vertexCounts.push_back(polygons.vertexCounts[loop]);
      for (uint32_t k = 0; k < polygons.vertexCounts[loop]; ++k, ++corner) {
        part.corners.push_back(corner);
        uint32_t point = polygons.vertices[corner];
        auto [entry, isNew] = numbers[number].try_emplace(point, uint32_t(part.points.size()));
        if (isNew)
          part.points.push_back(point);
        part.geometry.vertices.push_back(entry->second);
      }
    }
  }
  std::vector<Shape> result;
  for (uint32_t i = 0; i < parts.size(); ++i)
    result.push_back(shapeOf(parts[i], groups.faces[i], whole, split));
  return result;
}

} // namespace

std::vector<Shape> anysl::render::splitByFaceValues(Shape &shape,
                                                    std::span<const Shader *const> shaders) {
  uint32_t faces =
      std::visit([](const auto &geometry) { return faceCount(geometry); }, shape.geometry);
  if (faces < 2)
    return {};
  std::vector<const Parameter *> split;
  for (const Parameter &variable : shape.variables)
    if (variable.declaration->storage == StorageClass::Uniform && !isPosition(variable.name) &&
        std::any_of(shaders.begin(), shaders.end(),
                    [&](const Shader *shader) { return wantsOneValue(variable, *shader); }))
      split.push_back(&variable);
  if (split.empty())
    return {};
  FaceGroups groups(faces, split);
  std::vector<Shape> result =
      std::visit([&](const auto &geometry) { return partsOf(geometry, shape, split, groups); },
                 shape.geometry);
  shape = std::move(result.front());
  result.erase(result.begin());
  return result;
}
