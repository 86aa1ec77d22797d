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

namespace anysl::render {

/// The circumstances of the points that ask; all null while parameters' defaults are computed.
struct Asker {
  const ShadingGroup *group = nullptr;
  const Shader *volume = nullptr; ///< that the rays came through, or null
  const AnyslShadeArgs *surface =
      nullptr;        ///< what the surface was shaded with, asked for by its volume
  unsigned depth = 0; ///< how many traced rays lie between the eye and the points
};

/// The service `query`: `shader` asks.
int serveQuery(const Shader &shader, const Asker &asker, const AnyslShadeArgs *args, uint32_t point,
               const AnyslQuery &query, AnyslCell *value);

} // namespace anysl::render

#endif
