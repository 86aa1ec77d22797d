//===-- tools/anysl-render/ShaderCache.cpp - finding and compiling shaders --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/ShaderCache.h"

#include "lib/Demand/Json.h"
#include "lib/Rib/RibReader.h"

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
namespace demand = anysl::demand;
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

/// Runs a program and waits for it; its messages go where ours go, and what it prints to a file if
/// there is one. Returns its exit status, or -1 if it did not start or was killed.
int runProgram(const std::vector<std::string> &command, const fs::path &output) {
  std::vector<char *> arguments;
  for (const std::string &word : command)
    arguments.push_back(const_cast<char *>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  if (!output.empty())
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0666);
  pid_t child;
  int failed = posix_spawn(&child, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed)
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

ShaderCache::ShaderCache(const CachePlace &place, ShaderTarget target)
    : folder(place), tools(programFolder()), target(std::move(target)), toolsUsed(toolKey()) {}

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
  addFile(tools / "anysl-info");
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

struct ShaderCache::Source {
  std::string name; ///< as the scene has it
  const Location &where;
  fs::path file;
  ContentHash key; ///< of all that it is made of, and of the tools
  std::string stem() const {
    std::string name = file.filename().string();
    return name.substr(0, name.find('.'));
  }
};

ShaderCache::Source ShaderCache::lookUp(const std::string &name, const Location &where) const {
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
  Source source{name, where, *found, {}};
  std::vector<fs::path> sources;
  if (source.file.extension() == ".so")
    sources = {source.file};
  else
    addSource(source.file, source.key, sources);
  source.key.add(toolsUsed);
  std::lock_guard guard(lock);
  used.insert(used.end(), sources.begin(), sources.end());
  return source;
}

std::vector<ShaderCache::Source> ShaderCache::lightsOf(const ShaderVariant &variant,
                                                       const Location &where) const {
  std::vector<Source> result;
  for (const std::string &light : variant.lights)
    if (find(light))
      result.push_back(lookUp(light, where));
  return result;
}

void ShaderCache::run(const Source &source, std::vector<std::string> command,
                      const fs::path &output) const {
  const std::string program = command[0];
  command[0] = (tools / program).string();
  if (access(command[0].c_str(), X_OK) != 0)
    throw UserError(source.where, "shader \"" + source.name + "\" has to be compiled, but '" +
                                      command[0] + "' is not there");
  if (int status = runProgram(command, output); status != 0)
    throw UserError(
        source.where,
        "shader \"" + source.name + "\" (" + source.file.string() +
            ") does not compile: " + program +
            (status < 0 ? " was stopped" : " failed with status " + std::to_string(status)));
}

fs::path ShaderCache::make(const Source &source, const std::string &name,
                           const std::function<void(const fs::path &)> &write) const {
  return folder.file(source.stem() + "-" + name, write);
}

fs::path ShaderCache::threadedCode(const Source &source) const {
  if (source.file.extension() != ".sl")
    return source.file;
  return make(source, source.key.text() + ".stc.bc", [&](const fs::path &path) {
    ++compiled;
    run(source, {"rslc", source.file.string(), "-o", path.string()});
  });
}

ShaderAsking ShaderCache::asking(const std::string &name, const Location &where) const {
  Source source = lookUp(name, where);
  if (source.file.extension() == ".so")
    return {};
  fs::path file = make(source, source.key.text() + ".json", [&](const fs::path &path) {
    run(source, {"anysl-info", "--json", threadedCode(source).string()}, path);
  });
  const demand::Json described = demand::parseJson(loadSourceFile(file.string()));
  ShaderAsking result;
  result.tracesForOthers = demand::member(described, "traces_for_others").truth;
  auto hasEffect = [&](const char *name) {
    const auto &shaders = demand::member(described, "shaders").items;
    return std::any_of(shaders.begin(), shaders.end(), [&](const demand::Json &shader) {
      return demand::hasText(demand::member(shader, "effects"), name);
    });
  };
  result.asksLights = hasEffect("LightValues");
  result.traces = hasEffect("Trace");
  const demand::Json &asked = demand::member(described, "asked");
  if (asked.kind == demand::Json::Array) {
    result.names.emplace();
    for (const demand::Json &name : asked.items)
      result.names->push_back(name.text);
  }
  return result;
}

void ShaderCache::link(const Source &source, const ShaderVariant &variant, const fs::path &output,
                       std::vector<std::string> more) const {
  std::vector<std::string> command = {"anysl-link", threadedCode(source).string(),
                                      "--runtime",  target.runtime,
                                      "--real",     target.real,
                                      "--mcpu",     "native"};
  if (!target.math.empty())
    command.insert(command.end(), {"--math", target.math});
  if (target.checkNaN)
    command.push_back("--check-nan");
  if (variant.rayDerivatives)
    command.push_back("--ray-derivatives");
  if (variant.tangents)
    command.push_back("--tangents");
  if (target.maxLoop)
    command.insert(command.end(), {"--max-loop", std::to_string(target.maxLoop)});
  for (const std::string &effect : target.withoutEffects)
    command.insert(command.end(), {"--without-effect", effect});
  command.insert(command.end(), more.begin(), more.end());
  TemporaryFile manifest{output.string() + ".json"};
  if (!variant.manifest.empty()) {
    std::ofstream(manifest.path) << (variant.withPlaces.empty() ? variant.manifest
                                                                : variant.withPlaces);
    command.insert(command.end(), {"--scene", manifest.path.string()});
    for (const Source &light : lightsOf(variant, source.where))
      command.insert(command.end(), {"--beside", threadedCode(light).string()});
  }
  run(source, std::move(command));
}

std::string ShaderCache::keyOf(const Source &source, const ShaderVariant &variant,
                               const std::string &form) const {
  ContentHash key = source.key;
  for (const std::string &word : {form, target.runtime, target.real, target.math, variant.manifest})
    key.add(word);
  for (const Source &light : lightsOf(variant, source.where))
    key.add(light.key.text());
  for (const std::string &effect : target.withoutEffects)
    key.add(effect);
  for (unsigned number : {target.width, unsigned(target.checkNaN), target.maxLoop,
                          unsigned(variant.rayDerivatives), unsigned(variant.tangents)})
    key.addNumber(number);
  return key.text();
}

fs::path ShaderCache::library(const std::string &name, const Location &where,
                              const ShaderVariant &variant) const {
  Source source = lookUp(name, where);
  if (source.file.extension() == ".so")
    return source.file;
  return make(source, keyOf(source, variant, "library") + ".so", [&](const fs::path &path) {
    ++compiled;
    link(source, variant, path,
         {"-o", path.string(), "--width",
          target.width > 1 ? "1," + std::to_string(target.width) : "1"});
  });
}

LibraryOutline ShaderCache::outline(const std::string &name, const Location &where,
                                    const ShaderVariant &variant) const {
  Source source = lookUp(name, where);
  const bool isLinked = source.file.extension() != ".so";
  if (!isLinked)
    source.key.add(readFile(source.file));
  const std::string key = keyOf(source, isLinked ? variant : ShaderVariant(), "outline");
  fs::path file = make(source, key + ".outline.json", [&](const fs::path &path) {
    if (isLinked)
      link(source, variant, path, {"-w", "--report-only", "--report", path.string()});
    else
      run(source, {"anysl-info", "--json", source.file.string()}, path);
  });
  const demand::Json described = demand::parseJson(loadSourceFile(file.string()));
  LibraryOutline result;
  result.wantsFootprints = demand::member(described, "carriesDerivatives").truth;
  for (const demand::Json &shader : demand::member(described, "shaders").items) {
    const demand::Json &read = demand::member(shader, isLinked ? "globalsRead" : "globals_read");
    result.wantsFootprints |= demand::hasText(read, "du") || demand::hasText(read, "dv");
    result.traces |= demand::hasText(demand::member(shader, "effects"), "Trace");
    result.instructions += demand::member(shader, "expandedInstructions").number;
  }
  return result;
}

demand::Json ShaderCache::report(const std::string &name, const Location &where,
                                 const ShaderVariant &variant) const {
  Source source = lookUp(name, where);
  std::string key = keyOf(source, variant, "report " + variant.withPlaces);
  fs::path file = make(source, key + ".report.json", [&](const fs::path &path) {
    // It tells of code before machine code is made of it, so that there need not be any.
    TemporaryFile code{path.string() + ".bc"};
    link(source, variant, path,
         {"-o", code.path.string(), "--width", "1", "--report", path.string()});
  });
  return demand::parseJson(loadSourceFile(file.string()));
}
