//===-- tools/anysl-render/MeshCorners.cpp - slopes at the corners of a mesh ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/MeshCorners.h"

#include <algorithm>

using namespace anysl::render;

MeshCorners::MeshCorners(const Mesh &mesh) : mesh(mesh) {
  for (uint32_t place = 0; place < 3 * mesh.triangles.size(); ++place) {
    const auto &list = mesh.unitParameters ? mesh.corners : mesh.triangles;
    uint32_t index = list[place / 3][place % 3];
    if (around.size() <= index)
      around.resize(index + 1);
    around[index].push_back(place);
    if (mesh.unitParameters)
      continue;
    SurfacePoint point;
    mesh.evaluate(hitOf(place), Vec3f(), Vec3f(), SurfaceNeeds(), point);
    normals.push_back(normalized(point.normal));
  }
}

Hit MeshCorners::hitOf(uint32_t place) {
  Hit hit;
  hit.primitive = place / 3;
  hit.u = place % 3 == 1;
  hit.v = place % 3 == 2;
  return hit;
}

/// Calls add(hit, weight) for the facets at a corner, with weights whose sum is 1. Those whose
/// parameters tell nothing weigh nothing.
template <typename Add>
void MeshCorners::forEachAround(const Hit &hit, const Add &add) const {
  uint32_t own = placeOf(hit);
  const auto &list = mesh.unitParameters ? mesh.corners : mesh.triangles;
  const std::vector<uint32_t> &places = around[list[own / 3][own % 3]];
  auto weightOf = [&](uint32_t place) {
    Vec3d byU, byV;
    bool belongs = mesh.unitParameters || dot(normals[own], normals[place]) > 0.9;
    return belongs ? mesh.tangents(place / 3, byU, byV) : 0;
  };
  double sum = 0;
  for (uint32_t place : places)
    sum += weightOf(place);
  for (uint32_t place : places)
    if (double weight = weightOf(place); weight > 0)
      add(hitOf(place), weight / sum);
}

void MeshCorners::evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &needs,
                           SurfacePoint &point) const {
  mesh.evaluate(hit, origin, direction, needs, point);
  if (!needs.derivatives)
    return;
  point.dNdu = point.dNdv = Vec3d();
  forEachAround(hit, [&](const Hit &facet, double weight) {
    SurfacePoint there;
    mesh.evaluate(facet, origin, direction, needs, there);
    point.dNdu += there.dNdu * weight;
    point.dNdv += there.dNdv * weight;
  });
}

void MeshCorners::differentiate(const Variable &variable, uint32_t component, const Hit &hit,
                                const SurfacePoint &point, double &byU, double &byV) const {
  byU = byV = 0;
  forEachAround(hit, [&](const Hit &facet, double weight) {
    double u = 0, v = 0;
    mesh.differentiate(variable, component, facet, point, u, v);
    byU += u * weight;
    byV += v * weight;
  });
}
