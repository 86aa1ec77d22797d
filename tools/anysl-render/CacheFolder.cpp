//===-- tools/anysl-render/CacheFolder.cpp - files that are made once -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/CacheFolder.h"

#include "lib/Rib/Diagnostics.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace anysl::render;

namespace {

using Clock = fs::file_time_type::clock;
constexpr std::chrono::minutes inUse(1);    ///< somebody may be about to open what was used then
constexpr std::chrono::hours abandoned(24); ///< whoever wrote something half done is gone

/// Lets one process at a time trim; others need not.
class Lock {
public:
  explicit Lock(const fs::path &path)
      : file(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)),
        held(file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0) {}
  ~Lock() {
    if (file >= 0)
      close(file);
  }
  Lock(const Lock &) = delete;
  Lock &operator=(const Lock &) = delete;
  explicit operator bool() const { return held; }

private:
  int file;
  bool held;
};

} // namespace

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  fs::remove(path, ignored);
}

CacheFolder::CacheFolder(const CachePlace &place)
    : folder(place.folder), limit(place.megabytes << 20) {
  if (!folder.empty())
    return;
  if (const char *cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
    folder = fs::path(cache) / "anysl";
  else if (const char *home = std::getenv("HOME"); home && *home)
    folder = fs::path(home) / ".cache" / "anysl";
  else
    folder = fs::temp_directory_path() / ("anysl-" + std::to_string(getuid()));
}

fs::path CacheFolder::file(const std::string &name,
                           const std::function<void(const fs::path &)> &write) const {
  fs::path result = folder / name;
  std::error_code error;
  if (fs::is_regular_file(result, error)) {
    fs::last_write_time(result, Clock::now(), error); // of its last use
    return result;
  }
  fs::create_directories(folder, error);
  if (error)
    throw UserError("cannot make the cache folder '" + folder.string() + "': " + error.message());
  static std::atomic<unsigned> serial = 0;
  // The suffix stays, since it says what is to be written.
  TemporaryFile temporary{
      folder / ("." + std::to_string(getpid()) + "-" + std::to_string(++serial) + "-" + name)};
  write(temporary.path);
  fs::rename(temporary.path, result, error);
  if (error)
    throw UserError("cannot write '" + result.string() + "': " + error.message());
  trim();
  return result;
}

void CacheFolder::trim() const {
  Lock lock(folder / ".lock");
  if (!lock)
    return;
  struct File {
    fs::path path;
    Clock::time_point used;
    uintmax_t size;
  };
  std::vector<File> files;
  uintmax_t sum = 0;
  const Clock::time_point now = Clock::now();
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code gone; // another process may be faster
    if (!entry->is_regular_file(gone))
      continue;
    File file{entry->path(), fs::last_write_time(entry->path(), gone), entry->file_size(gone)};
    if (gone)
      continue;
    std::string name = file.path.filename().string();
    if (name == ".lock")
      continue;
    if (name[0] == '.') {
      if (now - file.used > abandoned)
        fs::remove(file.path, gone);
      continue;
    }
    sum += file.size;
    files.push_back(std::move(file));
  }
  std::sort(files.begin(), files.end(),
            [](const File &a, const File &b) { return a.used < b.used; });
  for (const File &file : files) {
    if (sum <= limit || now - file.used < inUse)
      break;
    if (fs::remove(file.path, error))
      sum -= file.size;
  }
}
