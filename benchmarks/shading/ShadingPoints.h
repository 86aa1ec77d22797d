//===-- benchmarks/shading/ShadingPoints.h - the points that shading benchmarks run over ------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_BENCHMARKS_SHADING_SHADINGPOINTS_H
#define ANYSL_BENCHMARKS_SHADING_SHADINGPOINTS_H

#include <anysl/anysl.h>

#include <cstdint>

namespace anysl::benchmarks {

/// Fits in the second-level cache with all globals a shader reads.
constexpr uint32_t pointCount = 4096;

/// Services of a renderer whose every ray is answered at once: the colour is a gradient over the
/// direction, nothing is in shadow. The time measured is the shader's and that of calling out.
const AnyslServices &services();

/// Fills a batch with the visible half of a unit sphere, seen in perspective from (0, 0, -3), point after
/// point along rows as a renderer's tiles are; two lights (distant and point) and an ambient one shine.
void fillBatch(AnyslBatch *batch);

} // namespace anysl::benchmarks

#endif
