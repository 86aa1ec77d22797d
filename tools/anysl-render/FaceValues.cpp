//===-- tools/anysl-render/FaceValues.cpp - values of single polygons -------------------------===//
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

/// Some of the polygons of a shape, and the places of their values in its variables.
struct Part {
  PolygonShape geometry;
  std::vector<uint32_t> faces, corners, points;
};

Shape shapeOf(Part &part, const Shape &whole, const std::vector<const Parameter *> &split) {
  Shape result{std::move(part.geometry), {}, whole.objectToCamera, whole.appearance, whole.where};
  for (const Parameter &variable : whole.variables) {
    switch (variable.declaration->storage) {
    case StorageClass::Constant:
      result.variables.push_back(variable);
      break;
    case StorageClass::Uniform:
      if (std::find(split.begin(), split.end(), &variable) == split.end()) {
        result.variables.push_back(pick(variable, part.faces));
      } else {
        result.variables.push_back(pick(variable, std::span(part.faces).first(1)));
        result.variables.back().declaration->storage = StorageClass::Constant;
      }
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

} // namespace

std::vector<Shape> anysl::render::splitByFaceValues(Shape &shape,
                                                    std::span<const Shader *const> shaders) {
  auto *polygons = std::get_if<PolygonShape>(&shape.geometry);
  if (!polygons || polygons->loopCounts.size() < 2)
    return {};
  std::vector<const Parameter *> split;
  for (const Parameter &variable : shape.variables)
    if (variable.declaration->storage == StorageClass::Uniform && !isPosition(variable.name) &&
        std::any_of(shaders.begin(), shaders.end(),
                    [&](const Shader *shader) { return wantsOneValue(variable, *shader); }))
      split.push_back(&variable);
  if (split.empty())
    return {};

  using Values = std::pair<std::vector<double>, std::vector<std::string>>;
  std::map<Values, size_t> partOf;
  std::vector<Part> parts;
  std::vector<std::map<uint32_t, uint32_t>> numbers; // of the points in each part
  uint32_t loop = 0, corner = 0;
  for (uint32_t face = 0; face < polygons->loopCounts.size(); ++face) {
    Values values;
    for (const Parameter *variable : split) {
      Parameter value = pick(*variable, std::span(&face, 1));
      values.first.insert(values.first.end(), value.numbers.begin(), value.numbers.end());
      values.second.insert(values.second.end(), value.strings.begin(), value.strings.end());
    }
    size_t number = partOf.try_emplace(std::move(values), parts.size()).first->second;
    if (number == parts.size()) {
      parts.emplace_back();
      numbers.emplace_back();
    }
    Part &part = parts[number];
    part.faces.push_back(face);
    part.geometry.loopCounts.push_back(polygons->loopCounts[face]);
    for (uint32_t i = 0; i < polygons->loopCounts[face]; ++i, ++loop) {
      part.geometry.vertexCounts.push_back(polygons->vertexCounts[loop]);
      for (uint32_t k = 0; k < polygons->vertexCounts[loop]; ++k, ++corner) {
        part.corners.push_back(corner);
        uint32_t point = polygons->vertices[corner];
        auto [entry, isNew] = numbers[number].try_emplace(point, uint32_t(part.points.size()));
        if (isNew)
          part.points.push_back(point);
        part.geometry.vertices.push_back(entry->second);
      }
    }
  }
  std::vector<Shape> result;
  for (Part &part : parts)
    result.push_back(shapeOf(part, shape, split));
  shape = std::move(result.front());
  result.erase(result.begin());
  return result;
}
