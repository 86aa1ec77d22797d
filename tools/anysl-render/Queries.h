//===-- tools/anysl-render/Queries.h - what shaders ask for by name ----------------*- C++
//-*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_QUERIES_H
#define ANYSL_RENDER_QUERIES_H

#include "tools/anysl-render/Scene.h"

#include <optional>

namespace anysl::render {

/// The circumstances of the points that ask; all null while parameters' defaults are computed.
struct Asker {
  const ShadingGroup *group = nullptr;
  const Shader *volume = nullptr;          ///< that the rays came through, or null
  const AnyslShadeArgs *surface = nullptr; ///< what it was shaded with, for its volume
  RayPath path;                            ///< that has led to the points
  std::optional<Hit> hit;                  ///< where the point that asks lies, if it is one
};

/// The service `query`: `shader` asks.
int serveQuery(const Shader &shader, const Asker &asker, const AnyslShadeArgs *args, uint32_t point,
               const AnyslQuery &query, AnyslCell *value);

/// The services `call_method` and `shader_name`, for the co-shaders of the points that ask and the
/// lights that shine on them.
int serveMethod(const Shader &shader, const Asker &asker, const AnyslShadeArgs *args,
                uint32_t point, const char *handle, AnyslMessage &message);
const char *serveShaderName(const Shader &shader, const Asker &asker, const char *category,
                            uint32_t index);

/// A surface that a ray has met, for AnyslHits::values.
struct MetSurface {
  const Scene *scene;
  Hit hit;
  Ray ray;
  const AnyslShadeArgs *surface = nullptr; ///< what it was shaded with; null: not at all
  uint32_t point = 0;                      ///< its number among the points shaded so
};
void answerValues(AnyslMessage &message, const MetSurface &met);

} // namespace anysl::render

#endif
