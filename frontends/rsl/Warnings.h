//===-- frontends/rsl/Warnings.h - what rslc warns of ---------------------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_WARNINGS_H
#define ANYSL_FRONTENDS_RSL_WARNINGS_H

#include "lib/Support/Diagnostics.h"

/// The lines of Warnings.def by their names.
namespace anysl::rsl::warn {
#define RSL_WARNING(name, option, onByDefault, about)                                              \
  inline constexpr WarningGroup name{option, onByDefault};
#include "frontends/rsl/Warnings.def"
} // namespace anysl::rsl::warn

#endif
