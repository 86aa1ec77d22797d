//===-- runtimes/packet/texture.cpp - pictures out of files, for packets of points ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/texture-call.h>

extern "C" {
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M4" ANYSL_TEXTURE_LETTERS "_packet_texture", packet_texture_4)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M8" ANYSL_TEXTURE_LETTERS "_packet_texture", packet_texture_8)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M16" ANYSL_TEXTURE_LETTERS "_packet_texture", packet_texture_16)
__attribute__((noinline)) void packet_texture(ANYSL_TEXTURE_PARAMETERS);
}

void packet_texture(ANYSL_TEXTURE_PARAMETERS) {
  anysl::askForTextures(ANYSL_TEXTURE_ARGUMENTS, 1, 1);
}

#define WIDE_FORM(W, Mask)                                                                         \
  extern "C" void packet_texture_##W(ANYSL_TEXTURE_PARAMETERS, Mask mask);                         \
  void packet_texture_##W(ANYSL_TEXTURE_PARAMETERS, Mask mask) {                                   \
    anysl::askForTextures(ANYSL_TEXTURE_ARGUMENTS, W, mask);                                       \
  }

WIDE_FORM(4, uint8_t)
WIDE_FORM(8, uint8_t)
WIDE_FORM(16, uint16_t)

namespace {
inline void lookUpTexture(ANYSL_TEXTURE_PARAMETERS) { packet_texture(ANYSL_TEXTURE_ARGUMENTS); }
} // namespace

#include <anysl/standard/texture.h>
