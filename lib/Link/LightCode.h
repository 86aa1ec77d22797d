//===-- lib/Link/LightCode.h - light shaders that are linked into surfaces ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_LIGHTCODE_H
#define ANYSL_LIB_LINK_LIGHTCODE_H

#include "lib/Link/Session.h"

namespace anysl::link {

/// Which code a shader of a file is, as read: AnyslShaderInfo::code. Two shaders for which it is
/// the same compute the same bits.
uint64_t codeOf(const Session &session, const stc::ShaderInfo &shader);

/// Reads the light shaders that shine on all points of the session's shaders and makes functions of
/// them that surfaces can call. Those that ask a renderer for more than their parameters and their
/// place stay the renderer's. Gives false if a file is wrong.
bool readLightCode(Session &session);

/// Lets a function run the code of the lights whose numbers are constants there.
void callLightCode(Session &session, llvm::Function &function);

} // namespace anysl::link

#endif
