//===-- lib/Host/Library.cpp - opening a shader library ---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include <cerrno>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

using namespace anysl::host;

namespace {

/// Keeps the floating-point control word as it is. Objects linked with -ffast-math carry start-up
/// code that makes every later computation of the calling thread flush denormals.
class KeepFloatingPointMode {
#if defined(__x86_64__)
public:
  KeepFloatingPointMode() : mode(_mm_getcsr()) {}
  ~KeepFloatingPointMode() { _mm_setcsr(mode); }

private:
  unsigned mode;
#endif
};

AnyslStatus checkFile(const std::string &path) {
  int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
    return fail(ANYSL_ERROR_OPEN, path + ": cannot open: " + std::strerror(errno));
  struct stat status;
  bool isFile = !fstat(file, &status) && S_ISREG(status.st_mode);
  close(file);
  return isFile ? ANYSL_OK : fail(ANYSL_ERROR_OPEN, path + ": not a regular file");
}

/// The dynamic linker's complaint without the file's name, which is ours to say.
std::string loaderError(const std::string &path) {
  std::string text = dlerror();
  if (text.compare(0, path.size() + 2, path + ": ") == 0)
    text.erase(0, path.size() + 2);
  return text;
}

/// The descriptor in a loaded object, or null. Its size is looked at so that a foreign object that
/// happens to have such a symbol is not read beyond its end.
const AnyslLibraryInfo *findDescriptor(void *handle) {
  void *symbol = dlsym(handle, ANYSL_LIBRARY_SYMBOL);
  if (!symbol)
    return nullptr;
  Dl_info found;
  const ElfW(Sym) *entry = nullptr;
  if (!dladdr1(symbol, &found, reinterpret_cast<void **>(const_cast<ElfW(Sym) **>(&entry)),
               RTLD_DL_SYMENT) ||
      !entry || entry->st_size < offsetof(AnyslLibraryInfo, layout))
    return nullptr;
  return static_cast<const AnyslLibraryInfo *>(symbol);
}

AnyslStatus load(const char *givenPath, LoadedLibrary &library) {
  library.path = givenPath;
  // The dynamic linker searches its own folders for a name without a slash.
  std::string path = std::strchr(givenPath, '/') ? givenPath : std::string("./") + givenPath;
  if (AnyslStatus status = checkFile(path)) {
    return fail(status, library.path + std::string(anysl_last_error() + path.size()));
  }
  KeepFloatingPointMode keep;
  library.handle = dlopen(path.c_str(), RTLD_LOCAL | RTLD_NOW);
  if (!library.handle)
    return fail(ANYSL_ERROR_OPEN, library.path + ": cannot load: " + loaderError(path));
  library.info = findDescriptor(library.handle);
  if (!library.info)
    return fail(ANYSL_ERROR_NOT_A_LIBRARY, library.path +
                                               ": not a shader library: it has no symbol '" +
                                               ANYSL_LIBRARY_SYMBOL + "'");
  library.demand = findDemand(library.handle);
  return ANYSL_OK;
}

/// Hands out a handle once the descriptor has been checked.
AnyslStatus finish(std::shared_ptr<LoadedLibrary> loaded, uint32_t flags, AnyslLibrary **library) {
  loaded->inspectOnly = flags & ANYSL_OPEN_INSPECT;
  if (AnyslStatus status = checkDescriptor(*loaded))
    return status;
  *library = new AnyslLibrary{std::move(loaded)};
  return ANYSL_OK;
}

} // namespace

LoadedLibrary::~LoadedLibrary() {
  KeepFloatingPointMode keep;
  if (handle)
    dlclose(handle);
}

uint32_t anysl::host::cellsOf(const AnyslParamInfo &param) {
  return anysl_type_components(param.type) * (param.array_length ? param.array_length : 1);
}

std::string anysl::host::context(const LoadedLibrary &library, const AnyslShaderInfo &shader) {
  return library.path + ": shader '" + shader.name + "': ";
}

int anysl::host::findParam(const LoadedLibrary &library, const AnyslShaderInfo &shader,
                           const char *name) {
  std::string known;
  for (uint32_t i = 0; i < shader.param_count; ++i) {
    if (!std::strcmp(shader.params[i].name, name))
      return int(i);
    known += (i ? ", " : "") + std::string(shader.params[i].name);
  }
  fail(ANYSL_ERROR_NAME, context(library, shader) + "no parameter '" + name + "'; it has " +
                             (known.empty() ? "none" : known));
  return -1;
}

extern "C" {

AnyslStatus anysl_library_open(const char *path, uint32_t flags, AnyslLibrary **library) {
  return guarded([&] {
    auto loaded = std::make_shared<LoadedLibrary>();
    AnyslStatus status = load(path, *loaded);
    return status ? status : finish(std::move(loaded), flags, library);
  });
}

AnyslStatus anysl_library_adopt(const AnyslLibraryInfo *info, const char *name, uint32_t flags,
                                AnyslLibrary **library) {
  return guarded([&] {
    auto loaded = std::make_shared<LoadedLibrary>();
    loaded->path = name;
    loaded->info = info;
    return finish(std::move(loaded), flags, library);
  });
}

void anysl_library_close(AnyslLibrary *library) { delete library; }

const AnyslLibraryInfo *anysl_library_info(const AnyslLibrary *library) {
  return library->loaded->info;
}

const char *anysl_library_path(const AnyslLibrary *library) {
  return library->loaded->path.c_str();
}

const AnyslShaderInfo *anysl_library_shader(const AnyslLibrary *library, const char *name) {
  const AnyslLibraryInfo &info = *library->loaded->info;
  if (!name && info.shader_count)
    return &info.shaders[0];
  const char *colon = name ? std::strchr(name, ':') : nullptr;
  const char *own = colon ? colon + 1 : name;
  for (uint32_t i = 0; name && i < info.shader_count; ++i) {
    const char *kind = anysl_kind_name(info.shaders[i].kind);
    bool isKind = !colon || (std::strlen(kind) == size_t(colon - name) &&
                             !std::strncmp(kind, name, size_t(colon - name)));
    if (isKind && !std::strcmp(info.shaders[i].name, own))
      return &info.shaders[i];
  }
  guarded([&] {
    std::string known;
    for (uint32_t i = 0; i < info.shader_count; ++i)
      known += (i ? ", " : "") +
               (colon ? anysl_kind_name(info.shaders[i].kind) + std::string(":") : std::string()) +
               info.shaders[i].name;
    return fail(ANYSL_ERROR_NAME, library->loaded->path + ": no shader '" + (name ? name : "") +
                                      "'; it has " + (known.empty() ? "none" : known));
  });
  return nullptr;
}

const AnyslParamInfo *anysl_shader_param(const AnyslShaderInfo *shader, const char *name) {
  for (uint32_t i = 0; i < shader->param_count; ++i)
    if (!std::strcmp(shader->params[i].name, name))
      return &shader->params[i];
  return nullptr;
}

AnyslShadeFunction anysl_shader_entry(const AnyslShaderInfo *shader, uint32_t width) {
  if (!width)
    width = anysl_shader_widest(shader);
  for (uint32_t i = 0; i < shader->entry_count; ++i)
    if (shader->entries[i].width == width)
      return shader->entries[i].shade;
  return nullptr;
}

uint32_t anysl_shader_widest(const AnyslShaderInfo *shader) {
  uint32_t widest = 0;
  for (uint32_t i = 0; i < shader->entry_count; ++i)
    widest = widest > shader->entries[i].width ? widest : shader->entries[i].width;
  return widest;
}

} // extern "C"
