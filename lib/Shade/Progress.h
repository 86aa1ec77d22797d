//===-- lib/Shade/Progress.h - how far something is ---------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_PROGRESS_H
#define ANYSL_LIB_SHADE_PROGRESS_H

#include <chrono>
#include <string>

namespace anysl::shade {

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

} // namespace anysl::shade

#endif
