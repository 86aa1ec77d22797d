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

/// Sets du and dv to how far u and v go from pixel to pixel. The rays through the pixels to the
/// right and below meet the plane that touches the surface at the point; each of du and dv is the
/// root of the sum of the squares of what those two steps change. Where dPdu and dPdv are
/// orthogonal and the surface faces the eye, |dPdu du x dPdv dv| is then the area that the pixel
/// sees.
///
/// For a ray that does not come from the eye, the pixel is taken to have grown with the distance of
/// the ray's origin from the eye and the ray's length, which is so for a flat mirror.
void findFootprint(const Camera &camera, bool isFromEye, Vec3f origin, Vec3f direction,
                   SurfacePoint &point);

} // namespace anysl::render

#endif
