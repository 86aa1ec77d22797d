//===-- lib/Shade/Pictures.cpp - pictures, once something asks for them -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Pictures.h"
#include "lib/Shade/ImageModule.h"
#include "lib/Shade/Options.h"
#include <cstdio>
#include <dlfcn.h>
#include <filesystem>

namespace anysl::shade {

/// The module lies in lib/anysl, beside the folder of this program.
void *imageFunction(const char *name) {
  auto program = std::filesystem::read_symlink("/proc/self/exe");
  auto path = program.parent_path().parent_path() / "lib/anysl/anysl-shade-image.so";
  void *module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void *function = module ? dlsym(module, name) : nullptr;
  if (!function)
    throw UserError(std::string("cannot load what reads and writes images: ") + dlerror());
  return function;
}

textures::Textures *Pictures::get() {
  auto warn = [](const std::string &message) {
    std::fprintf(stderr, "anysl-shade: warning: %s\n", message.c_str());
  };
  std::call_once(once, [&] {
    try {
      auto make =
          reinterpret_cast<decltype(&anyslMakeTextures)>(imageFunction("anyslMakeTextures"));
      make({searchPath, warn}, &textures);
    } catch (const std::exception &error) {
      warn(error.what());
    }
  });
  return textures.get();
}

} // namespace anysl::shade
