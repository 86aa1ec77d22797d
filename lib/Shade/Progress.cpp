//===-- lib/Shade/Progress.cpp - how far something is -----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Progress.h"

#include <cmath>
#include <cstdio>

#include <sys/ioctl.h>
#include <unistd.h>

using namespace anysl::shade;

Progress::Progress(std::string title, bool quiet)
    : title(std::move(title)), quiet(quiet), terminal(isatty(STDERR_FILENO)) {}

void Progress::show(double share) {
  if (quiet)
    return;
  auto now = Clock::now();
  double seconds = std::chrono::duration<double>(now - begin).count();
  if (!terminal) {
    // Short pictures need no lines at all.
    if (seconds < 2)
      return;
    int reached = int(share * 4);
    if (reached <= quarters || reached >= 4)
      return;
    quarters = reached;
    std::fprintf(stderr, "%s: %d %%, %.1f s\n", title.c_str(), reached * 25, seconds);
    return;
  }
  if (drawn && std::chrono::duration<double>(now - last).count() < 0.05)
    return;
  last = now;
  winsize size = {};
  int width = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
  char numbers[64];
  double rest = share > 0 ? seconds / share - seconds : 0;
  std::snprintf(numbers, sizeof numbers, " %3.0f %% %5.1f s left", std::floor(share * 100), rest);
  int room = width - int(title.size()) - int(std::string(numbers).size()) - 4;
  std::string bar;
  for (int i = 0; i < room; ++i)
    bar += i < int(share * room) ? '#' : '.';
  std::fprintf(stderr, "\r%s [%s]%s", title.c_str(), bar.c_str(), numbers);
  std::fflush(stderr);
  drawn = true;
}

void Progress::finish() {
  if (drawn)
    std::fprintf(stderr, "\r\033[K");
  drawn = false;
}
