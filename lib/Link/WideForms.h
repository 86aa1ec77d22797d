//===-- lib/Link/WideForms.h - where widening leaves its results --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_WIDEFORMS_H
#define ANYSL_LIB_LINK_WIDEFORMS_H

#include "lib/Link/Session.h"

namespace anysl::link {

/// The form of a shader for `width` points, void (ptr args, i32 first) and with a mask as its last
/// argument void (ptr args, i32 first, <width x i1> mask). Made by the stage `widen`.
llvm::Function *wideForm(const Shader &shader, unsigned width, bool masked);

} // namespace anysl::link

#endif
