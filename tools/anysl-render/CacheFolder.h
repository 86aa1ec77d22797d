//===-- tools/anysl-render/CacheFolder.h - files that are made once -----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_CACHEFOLDER_H
#define ANYSL_RENDER_CACHEFOLDER_H

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace anysl::render {

/// Where a cache lies, and how large it may grow.
struct CachePlace {
  std::string folder; ///< empty: $XDG_CACHE_HOME/anysl, else ~/.cache/anysl
  uint64_t megabytes = 1024;
};

/// A folder of files whose names say all that they are made of, so that a file that is there need
/// not be made again. Any number of processes may share it: files appear under their names only
/// when complete. Beyond its size those go first that have not been used for longest, but none that
/// has been within the last minute, which somebody may be about to open.
class CacheFolder {
public:
  explicit CacheFolder(const CachePlace &place);

  /// The file of that name, which `write` makes if it is not there. Throws UserError where it
  /// cannot be written, and what `write` throws. Several threads may call this.
  std::filesystem::path file(const std::string &name,
                             const std::function<void(const std::filesystem::path &)> &write) const;

private:
  void trim() const;

  std::filesystem::path folder;
  uint64_t limit; ///< bytes
};

/// A file that goes when its maker is done with it, unless it has been moved away.
struct TemporaryFile {
  std::filesystem::path path;
  ~TemporaryFile();
};

} // namespace anysl::render

#endif
