//===-- lib/Shade/Pictures.h - pictures, once something asks for them ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_PICTURES_H
#define ANYSL_LIB_SHADE_PICTURES_H

#include "lib/Textures/Textures.h"
#include <mutex>
#include <string>
#include <vector>

namespace anysl::shade {

/// A function of the module that knows OpenImageIO (ImageModule.h), which is loaded for it. Throws
/// UserError.
void *imageFunction(const char *name);

/// The files that a shader looks pictures up in.
class Pictures {
public:
  /// Loads what reads them the first time. Null, after a message, where that is not there: this is
  /// called in the middle of a shader, which no exception passes.
  textures::Textures *get();

  std::vector<std::string> searchPath;

private:
  std::once_flag once;
  std::unique_ptr<textures::Textures> textures;
};

} // namespace anysl::shade

#endif
