//===-- tools/anysl-render/ShaderCache.cpp - finding and compiling shaders --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/ShaderCache.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

namespace fs = std::filesystem;
using namespace anysl::render;

namespace {

/// Two 64-bit FNV-1a sums over the same bytes: 128 bits, plenty against accidents.
class ContentHash {
public:
  void add(std::string_view bytes) {
    for (unsigned char c : bytes) {
      first = (first ^ c) * 0x100000001b3u;
      second = (second ^ (c + 0x5bu)) * 0x100000001b3u;
    }
    // The length keeps "ab" + "c" from meeting "a" + "bc".
    first = (first ^ bytes.size()) * 0x100000001b3u;
    second = (second ^ ~bytes.size()) * 0x100000001b3u;
  }
  void addNumber(uint64_t number) { add(std::to_string(number)); }
  std::string text() const {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%016llx%016llx", static_cast<unsigned long long>(first),
                  static_cast<unsigned long long>(second));
    return buffer;
  }

private:
  uint64_t first = 0xcbf29ce484222325u, second = 0x84222325cbf29ce4u;
};

std::string readFile(const fs::path &path) {
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// Adds a source and, whatever conditions they stand under, all the files it includes.
void addSource(const fs::path &path, ContentHash &hash, std::vector<fs::path> &sources) {
  if (std::find(sources.begin(), sources.end(), path) != sources.end())
    return;
  sources.push_back(path);
  std::string text = readFile(path);
  hash.add(text);
  for (size_t line = 0; line < text.size();) {
    size_t end = std::min(text.find('\n', line), text.size());
    std::string_view rest(text.data() + line, end - line);
    line = end + 1;
    auto skip = [&] { rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size())); };
    skip();
    if (rest.empty() || rest[0] != '#')
      continue;
    rest.remove_prefix(1);
    skip();
    if (!rest.starts_with("include"))
      continue;
    size_t open = rest.find_first_of("\"<");
    size_t close = open == rest.npos ? open : rest.find_first_of("\">", open + 1);
    if (close == rest.npos)
      continue;
    fs::path included = path.parent_path() / rest.substr(open + 1, close - open - 1);
    std::error_code error;
    if (fs::is_regular_file(included, error))
      addSource(included, hash, sources);
  }
}

/// Runs a program and waits for it; its messages go where ours go. Returns its exit status, or -1
/// if it did not start or was killed.
int run(const std::vector<std::string> &command) {
  std::vector<char *> arguments;
  for (const std::string &word : command)
    arguments.push_back(const_cast<char *>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child;
  if (posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
    return -1;
  int status;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR)
      return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

fs::path anysl::render::programFolder() {
  std::error_code error;
  fs::path program = fs::read_symlink("/proc/self/exe", error);
  return program.parent_path();
}

ShaderCache::ShaderCache(fs::path given, ShaderTarget target)
    : folder(std::move(given)), tools(programFolder()), target(std::move(target)) {
  if (!folder.empty())
    return;
  if (const char *cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
    folder = fs::path(cache) / "anysl";
  else if (const char *home = std::getenv("HOME"); home && *home)
    folder = fs::path(home) / ".cache" / "anysl";
  else
    folder = fs::temp_directory_path() / ("anysl-" + std::to_string(getuid()));
}

std::optional<fs::path> ShaderCache::find(const std::string &name) const {
  std::error_code error;
  for (const fs::path &place : searchPath)
    for (const char *suffix : {".so", ".stc.bc", ".sl", ""}) {
      fs::path path = place / (name + suffix);
      bool known =
          *suffix || name.ends_with(".so") || name.ends_with(".sl") || name.ends_with(".stc.bc");
      if (known && fs::is_regular_file(path, error))
        return path.lexically_normal();
    }
  return std::nullopt;
}

std::string ShaderCache::toolKey() const {
  // A tool or runtime that is rebuilt gets another time or size.
  ContentHash hash;
  hash.add(ANYSL_VERSION);
  auto addFile = [&](const fs::path &path) {
    std::error_code error;
    auto time = fs::last_write_time(path, error).time_since_epoch().count();
    hash.add(path.string());
    hash.addNumber(uint64_t(time));
    hash.addNumber(fs::file_size(path, error));
  };
  addFile(tools / "rslc");
  addFile(tools / "anysl-link");
  std::error_code error;
  std::set<fs::path> runtimes;
  for (fs::recursive_directory_iterator file(tools.parent_path() / "lib" / "anysl", error), end;
       !error && file != end; file.increment(error))
    if (file->is_regular_file(error))
      runtimes.insert(file->path());
  std::for_each(runtimes.begin(), runtimes.end(), addFile);
  // Shaders are compiled for the processor that runs them, and homes are shared between machines.
  std::ifstream cpu("/proc/cpuinfo");
  for (std::string line; std::getline(cpu, line) && !line.empty();)
    if (line.starts_with("flags") || line.starts_with("model"))
      hash.add(line);
  return hash.text();
}

std::vector<fs::path> ShaderCache::sources() const {
  std::lock_guard guard(lock);
  return used;
}

fs::path ShaderCache::library(const std::string &name, const Location &where,
                              ShaderExtras extras) const {
  std::optional<fs::path> found = find(name);
  if (!found) {
    std::string searched;
    for (const fs::path &place : searchPath) {
      searched += (searched.empty() ? "" : ":") + place.string();
      if (fs::path(name).is_absolute())
        break;
    }
    throw UserError(where, "shader \"" + name + "\" is not found: no " + name +
                               ".so, .stc.bc or .sl in " + searched);
  }
  fs::path source = *found;
  ContentHash hash;
  std::vector<fs::path> sources;
  if (source.extension() == ".so")
    sources = {source};
  else
    addSource(source, hash, sources);
  {
    std::lock_guard guard(lock);
    used.insert(used.end(), sources.begin(), sources.end());
  }
  if (source.extension() == ".so")
    return source;
  for (const std::string &word : {toolKey(), target.runtime, target.real, target.math})
    hash.add(word);
  for (unsigned number : {target.width, unsigned(target.checkNaN), target.maxLoop,
                          unsigned(extras.rayDerivatives), unsigned(extras.tangents)})
    hash.addNumber(number);
  std::string stem = source.filename().string();
  stem = stem.substr(0, stem.find('.'));
  fs::path result = folder / (stem + "-" + hash.text() + ".so");
  std::error_code error;
  if (fs::is_regular_file(result, error))
    return result;

  fs::create_directories(folder, error);
  if (error)
    throw UserError("cannot make the cache folder '" + folder.string() + "': " + error.message());
  std::string base =
      (folder / ("." + stem + "-" + hash.text() + "." + std::to_string(getpid()))).string();
  struct Temporary {
    fs::path path;
    ~Temporary() {
      std::error_code ignored;
      fs::remove(path, ignored);
    }
  } stc{base + ".stc.bc"}, library{base + ".so"};
  auto step = [&](std::vector<std::string> command) {
    if (access(command[0].c_str(), X_OK) != 0)
      throw UserError(where, "shader \"" + name + "\" has to be compiled, but '" + command[0] +
                                 "' is not there");
    if (int status = run(command); status != 0)
      throw UserError(where, "shader \"" + name + "\" (" + source.string() +
                                 ") does not compile: " + fs::path(command[0]).filename().string() +
                                 (status < 0 ? " was stopped"
                                             : " failed with status " + std::to_string(status)));
  };
  ++compiled;
  fs::path linked = source;
  if (source.extension() == ".sl") {
    step({(tools / "rslc").string(), source.string(), "-o", stc.path.string()});
    linked = stc.path;
  }
  std::vector<std::string> link = {(tools / "anysl-link").string(),
                                   linked.string(),
                                   "-o",
                                   library.path.string(),
                                   "--runtime",
                                   target.runtime,
                                   "--real",
                                   target.real,
                                   "--mcpu",
                                   "native",
                                   "--width",
                                   target.width > 1 ? "1," + std::to_string(target.width) : "1"};
  if (!target.math.empty())
    link.insert(link.end(), {"--math", target.math});
  if (target.checkNaN)
    link.push_back("--check-nan");
  if (extras.rayDerivatives)
    link.push_back("--ray-derivatives");
  if (extras.tangents)
    link.push_back("--tangents");
  if (target.maxLoop)
    link.insert(link.end(), {"--max-loop", std::to_string(target.maxLoop)});
  step(std::move(link));
  fs::rename(library.path, result, error);
  if (error)
    throw UserError("cannot write '" + result.string() + "': " + error.message());
  return result;
}
