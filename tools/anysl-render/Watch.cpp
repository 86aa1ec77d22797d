//===-- tools/anysl-render/Watch.cpp - waiting for files to change ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Watch.h"

#include <algorithm>
#include <thread>

using namespace anysl::render;

Watch::State Watch::look(const std::filesystem::path &file) {
  // A file that is away just now has the time and size of none.
  std::error_code error;
  State state{std::filesystem::last_write_time(file, error), 0};
  if (error)
    return {};
  state.size = std::filesystem::file_size(file, error);
  return state;
}

void Watch::add(const std::vector<std::filesystem::path> &paths) {
  std::lock_guard guard(lock);
  for (const auto &path : paths)
    if (!leftOut.contains(std::filesystem::absolute(path).lexically_normal()))
      files.emplace(path, look(path));
}

void Watch::leaveOut(const std::filesystem::path &file) {
  std::lock_guard guard(lock);
  leftOut.insert(std::filesystem::absolute(file).lexically_normal());
}

bool Watch::changed() {
  std::lock_guard guard(lock);
  auto now = std::chrono::steady_clock::now();
  if (seen || now - last < std::chrono::milliseconds(200))
    return seen;
  last = now;
  for (const auto &[path, state] : files)
    if (State current = look(path); !(current == state) && !(current == State())) {
      seen = true;
      saved = std::max(saved, current.time);
    }
  return seen;
}

std::filesystem::file_time_type Watch::wait() {
  while (!changed())
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::lock_guard guard(lock);
  return saved;
}
