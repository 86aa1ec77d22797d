//===-- lib/Rib/FileTypes.h - types of displays that are files --------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_FILETYPES_H
#define ANYSL_LIB_RIB_FILETYPES_H

#include <string_view>

namespace anysl::render {

/// What OpenImageIO calls the format of a type of display; empty: the file's suffix decides; null:
/// the type is none of files, but of windows and the like.
const char *fileFormat(std::string_view displayType);

} // namespace anysl::render

#endif
