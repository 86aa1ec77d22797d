//===-- runtimes/scalar/texture.cpp - pictures out of files, one point at a time --------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/texture-call.h>

namespace {

__attribute__((noinline)) void lookUpTexture(ANYSL_TEXTURE_PARAMETERS) {
  anysl::askForTextures(ANYSL_TEXTURE_ARGUMENTS, 1, 1);
}

} // namespace

#include <anysl/standard/texture.h>
