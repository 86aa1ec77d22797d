//===-- tools/anysl-render/Refine.cpp - coarse facets to fine ones ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Edges that are too long are halved, which both facets at an edge agree about; then the facets are
// cut through the middles of their edges; and all that again.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Tessellate.h"

#include <algorithm>
#include <unordered_map>

using namespace anysl::render;

namespace {

using Triple = std::array<uint32_t, 3>;

/// The middles of pairs of points or of corners, each made once.
class Middles {
public:
  template <typename Make>
  uint32_t get(uint32_t a, uint32_t b, const Make &make) {
    auto [entry, isNew] = known.try_emplace(uint64_t(std::min(a, b)) << 32 | std::max(a, b), 0);
    if (isNew)
      entry->second = make(a, b);
    return entry->second;
  }

private:
  std::unordered_map<uint64_t, uint32_t> known;
};

void appendMean(Variable &variable, uint32_t a, uint32_t b) {
  for (uint32_t k = 0; k < variable.components; ++k)
    variable.values.push_back(0.5f * (variable.at(a)[k] + variable.at(b)[k]));
}

} // namespace

void anysl::render::refine(Mesh &mesh, const Dicing &dicing) {
  uint32_t cornerCount = 0;
  for (const Triple &corner : mesh.corners)
    cornerCount = std::max(cornerCount, *std::max_element(corner.begin(), corner.end()) + 1);
  auto appendMeans = [&](Domain domain, uint32_t a, uint32_t b) {
    for (Variable &variable : mesh.values.list)
      if (variable.domain == domain)
        appendMean(variable, a, b);
    if (!mesh.normals.values.empty() && mesh.normals.domain == domain)
      appendMean(mesh.normals, a, b);
  };
  for (int pass = 0; pass < 16 && mesh.triangles.size() < Dicing::mostFacets; ++pass) {
    Middles points, corners;
    std::vector<Triple> triangles, newCorners;
    std::vector<uint32_t> faces;
    bool changed = false;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      Triple p = mesh.triangles[t], c = mesh.corners[t];
      bool split[3];
      int count = 0;
      for (size_t k = 0; k < 3; ++k)
        count += split[k] =
            dicing.isLong(Vec3d(mesh.points[p[k]]), Vec3d(mesh.points[p[(k + 1) % 3]]));
      // One edge: the first. Two: the first and the second.
      while (count == 1 ? !split[0] : count == 2 && split[2]) {
        std::rotate(p.begin(), p.begin() + 1, p.end());
        std::rotate(c.begin(), c.begin() + 1, c.end());
        std::rotate(split, split + 1, split + 3);
      }
      uint32_t mp[3] = {}, mc[3] = {};
      for (size_t k = 0; k < 3; ++k)
        if (split[k]) {
          mp[k] = points.get(p[k], p[(k + 1) % 3], [&](uint32_t a, uint32_t b) {
            mesh.points.push_back((mesh.points[a] + mesh.points[b]) * 0.5f);
            appendMeans(Domain::Point, a, b);
            return uint32_t(mesh.points.size() - 1);
          });
          mc[k] = corners.get(c[k], c[(k + 1) % 3], [&](uint32_t a, uint32_t b) {
            appendMeans(Domain::Corner, a, b);
            return cornerCount++;
          });
        }
      auto add = [&](Triple which) { // 0 1 2: the corners; 3 4 5: the middles
        Triple tp, tc;
        for (size_t k = 0; k < 3; ++k) {
          uint32_t w = which[k];
          tp[k] = w < 3 ? p[w] : mp[w - 3];
          tc[k] = w < 3 ? c[w] : mc[w - 3];
        }
        triangles.push_back(tp);
        newCorners.push_back(tc);
        faces.push_back(mesh.faces[t]);
      };
      if (count == 0)
        add({0, 1, 2});
      if (count == 1)
        add({0, 3, 2}), add({3, 1, 2});
      if (count == 2)
        add({3, 1, 4}), add({0, 3, 4}), add({0, 4, 2});
      if (count == 3)
        add({0, 3, 5}), add({3, 1, 4}), add({5, 4, 2}), add({3, 4, 5});
      changed |= count > 0;
    }
    mesh.triangles = std::move(triangles);
    mesh.corners = std::move(newCorners);
    mesh.faces = std::move(faces);
    if (!changed)
      return;
  }
}
