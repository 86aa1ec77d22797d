//===-- tools/anysl-render/Render.h - tiles in threads ----------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_RENDER_H
#define ANYSL_RENDER_RENDER_H

#include "tools/anysl-render/Film.h"
#include "tools/anysl-render/Host.h"

#include <functional>

namespace anysl::render {

struct RenderOptions {
  bool timed = false;                  ///< measure how long shaders run
  shade::Recorder *recorder = nullptr; ///< collects what shaders are called with
  /// Globals that are computed once more at each point whose shaders want them, to see what that
  /// takes; 0: only the point itself.
  std::optional<uint64_t> again;
  /// Called now and then, by one thread at a time, with the share of tiles that are done.
  std::function<void(double share)> progress;
  /// Asked before each tile; true gives up, and the picture is not complete.
  std::function<bool()> cancelled;
};

struct RenderResult {
  Film film;
  RenderCounts counts;
  double seconds = 0;        ///< from the first tile to the last
  double shadingSeconds = 0; ///< summed over all threads, if measured
  bool complete = true;
};

/// Renders a scene in tiles, on as many threads as oneTBB may use.
RenderResult render(const Host &host, const RenderOptions &options);

} // namespace anysl::render

#endif
