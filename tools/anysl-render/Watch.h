//===-- tools/anysl-render/Watch.h - waiting for files to change ------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_WATCH_H
#define ANYSL_RENDER_WATCH_H

#include <chrono>
#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <vector>

namespace anysl::render {

/// Looks whether files change. It compares times and sizes, which works for editors that write a
/// new file in place of the old one, and on every file system.
class Watch {
public:
  void add(const std::vector<std::filesystem::path> &files);
  /// Leaves a file out from now on, which this program itself writes.
  void leaveOut(const std::filesystem::path &file);
  /// Whether a file has changed since it was added. Cheap: it looks five times a second at most.
  /// Any thread may ask.
  bool changed();
  /// Waits until changed(), and gives the time when the file was saved that changed last.
  std::filesystem::file_time_type wait();

private:
  struct State {
    std::filesystem::file_time_type time;
    uintmax_t size;
    friend bool operator==(const State &, const State &) = default;
  };
  static State look(const std::filesystem::path &file);

  std::mutex lock;
  std::map<std::filesystem::path, State> files;
  std::set<std::filesystem::path> leftOut;
  std::chrono::steady_clock::time_point last;
  bool seen = false;
  std::filesystem::file_time_type saved = std::filesystem::file_time_type::min();
};

} // namespace anysl::render

#endif
