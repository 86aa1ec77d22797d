//===-- tools/anysl-render/Tessellate.h - shapes to triangles ---------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_TESSELLATE_H
#define ANYSL_RENDER_TESSELLATE_H

#include "tools/anysl-render/Dicing.h"

namespace anysl::render {

/// Cuts polygons, with their holes, into triangles.
std::unique_ptr<Mesh> tessellate(const PolygonShape &shape, const ParameterList &variables,
                                 const Placement &placement, const Dicing &dicing);

/// Cuts a swept surface, quadric or not, into facets.
std::unique_ptr<Mesh> tessellate(const QuadricShape &shape, const ParameterList &variables,
                                 const Placement &placement, const Dicing &dicing);

/// Cuts patches into facets.
std::unique_ptr<Mesh> tessellate(const PatchShape &shape, const ParameterList &variables,
                                 const Placement &placement, const Dicing &dicing);
std::unique_ptr<Mesh> tessellate(const NurbsShape &shape, const ParameterList &variables,
                                 const Placement &placement, const Dicing &dicing);

/// Cuts a subdivision surface into facets.
std::unique_ptr<Mesh> tessellate(const SubdivisionShape &shape, const ParameterList &variables,
                                 const Placement &placement, const Dicing &dicing);
/// Cuts ribbons into facets that face as their normals do, or else the eye.
std::unique_ptr<Mesh> tessellate(const CurvesShape &shape, const ParameterList &variables,
                                 const Placement &placement, const Dicing &dicing);

/// Cuts the facets of polygons into finer ones of the size that displaced surfaces have.
void refine(Mesh &mesh, const Dicing &dicing);

/// The facets of any shape that has some; null for one that has not, as points.
std::unique_ptr<Mesh> tessellate(const Shape &shape, const Placement &placement,
                                 const Dicing &dicing);

} // namespace anysl::render

#endif
