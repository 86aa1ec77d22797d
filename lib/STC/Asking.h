//===-- lib/STC/Asking.h - what shaders ask of each other ---------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_ASKING_H
#define ANYSL_STC_ASKING_H

#include "lib/STC/Reader.h"
#include <optional>
#include <set>

namespace anysl::stc {

/// Names of parameters that shaders of this module may ask others for, or set; nothing: there may
/// be any.
std::optional<std::set<std::string>> askedNames(const llvm::Module &module);

/// Whether a file has shaders that run for points of others (lights, volumes, methods) and trace
/// rays there: rays of a point are numbered, whichever shader asks for them.
bool tracesForOthers(const StcModule &file);

} // namespace anysl::stc

#endif
