//===-- tools/anysl-render/Progress.h - how far a picture is ----------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_PROGRESS_H
#define ANYSL_RENDER_PROGRESS_H

#include <chrono>
#include <string>

namespace anysl::render {

/// Shows progress on standard error: a bar that moves on a terminal, a line for each quarter
/// elsewhere.
class Progress {
public:
  Progress(std::string title, bool quiet);
  ~Progress() { finish(); }
  void show(double share);
  /// Removes the bar.
  void finish();

private:
  using Clock = std::chrono::steady_clock;

  std::string title;
  bool quiet, terminal;
  bool drawn = false;
  int quarters = 0;
  Clock::time_point begin = Clock::now(), last = begin;
};

} // namespace anysl::render

#endif
