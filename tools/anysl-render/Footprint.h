//===-- tools/anysl-render/Footprint.h - how much of a surface a pixel sees -------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_FOOTPRINT_H
#define ANYSL_RENDER_FOOTPRINT_H

#include "lib/Rib/Camera.h"
#include "tools/anysl-render/Surface.h"
#include <anysl/abi.h>

namespace anysl::render {

/// The bits of the globals du and dv, which findFootprint() finds.
constexpr uint64_t footprintBits = uint64_t(1) << ANYSL_du | uint64_t(1) << ANYSL_dv;

/// Sets du and dv to how far u and v go from pixel to pixel, with what they change by to the pixels
/// to the right and below, and how I changes with u and v. The rays through those pixels meet the
/// plane that touches the surface at the point; each of du and dv is the root of the sum of the
/// squares of what those two steps change. Where dPdu and dPdv are orthogonal and the surface faces
/// the eye, |dPdu du x dPdv dv| is then the area that the pixel sees.
///
/// Of a traced ray whose shader carries no derivatives nobody knows how it differs from its
/// neighbours. It is taken to have grown with the distance of its origin from the eye, which is so
/// for a flat mirror that is seen directly.
void findFootprint(const Camera &camera, bool isFromEye, const Ray &ray, SurfacePoint &point);

} // namespace anysl::render

#endif
