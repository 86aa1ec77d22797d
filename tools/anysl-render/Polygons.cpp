//===-- tools/anysl-render/Polygons.cpp - polygons to triangles -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Tessellate.h"
#include "tools/anysl-render/Triangulate.h"

#include <algorithm>

using namespace anysl::render;

namespace {

Domain domainOf(StorageClass storage) {
  switch (storage) {
  case StorageClass::Constant:
    return Domain::Constant;
  case StorageClass::Uniform:
    return Domain::Face;
  case StorageClass::Varying:
  case StorageClass::Vertex:
    return Domain::Point;
  case StorageClass::FaceVarying:
    return Domain::Corner;
  }
  return Domain::Point;
}

} // namespace

std::unique_ptr<Mesh> anysl::render::tessellate(const PolygonShape &shape,
                                                const ParameterList &variables,
                                                const Placement &placement, const Dicing &) {
  auto mesh = std::make_unique<Mesh>(placement);
  std::vector<Vec3d> places = positions(variables);
  mesh->points.reserve(places.size() + 1);
  for (const Vec3d &p : places)
    mesh->points.push_back(Vec3f(placement.toCamera.point(p)));

  std::vector<Vec3d> outline;
  std::vector<std::array<uint32_t, 3>> cut;
  uint32_t firstCorner = 0;
  auto loops = std::span(shape.vertexCounts);
  for (uint32_t face = 0; face < shape.loopCounts.size(); ++face) {
    auto itsLoops = loops.first(shape.loopCounts[face]);
    loops = loops.subspan(shape.loopCounts[face]);
    outline.clear();
    cut.clear();
    for (uint32_t count : itsLoops)
      for (uint32_t i = 0; i < count; ++i)
        outline.push_back(places[shape.vertices[firstCorner + outline.size()]]);
    triangulate(outline, itsLoops, cut);
    for (const auto &[a, b, c] : cut) {
      std::array<uint32_t, 3> corner{firstCorner + a, firstCorner + b, firstCorner + c};
      mesh->corners.push_back(corner);
      mesh->addTriangle(shape.vertices[corner[0]], shape.vertices[corner[1]],
                        shape.vertices[corner[2]]);
      mesh->faces.push_back(face);
    }
    firstCorner += uint32_t(outline.size());
  }

  std::vector<Variable> values;
  for (const Parameter &parameter : variables) {
    if (isPosition(parameter.name) || parameter.declaration->type == ValueType::String)
      continue;
    Variable variable = cameraVariable(parameter, placement);
    variable.domain = domainOf(parameter.declaration->storage);
    if (parameter.name == "N" || parameter.name == "Np")
      mesh->normals = variable;
    values.push_back(std::move(variable));
  }
  mesh->values = SurfaceVariables(std::move(values));
  return mesh;
}
