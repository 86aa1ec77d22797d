//===-- runtimes/packet/hit.cpp - what rays meet first, in packets ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/hit-call.h>

extern "C" {
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M4" ANYSL_HIT_LETTERS "_packet_hit", packet_hit_4)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M8" ANYSL_HIT_LETTERS "_packet_hit", packet_hit_8)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M16" ANYSL_HIT_LETTERS "_packet_hit", packet_hit_16)
__attribute__((noinline)) void packet_hit(ANYSL_HIT_PARAMETERS);
}

void packet_hit(ANYSL_HIT_PARAMETERS) { anysl::askForHits(ANYSL_HIT_ARGUMENTS, 1, 1); }

#define WIDE_FORM(W, Mask)                                                                         \
  extern "C" void packet_hit_##W(ANYSL_HIT_PARAMETERS, Mask mask);                                 \
  void packet_hit_##W(ANYSL_HIT_PARAMETERS, Mask mask) {                                           \
    anysl::askForHits(ANYSL_HIT_ARGUMENTS, W, mask);                                               \
  }

WIDE_FORM(4, uint8_t)
WIDE_FORM(8, uint8_t)
WIDE_FORM(16, uint16_t)

namespace {
inline void findHit(ANYSL_HIT_PARAMETERS) { packet_hit(ANYSL_HIT_ARGUMENTS); }
} // namespace

#include <anysl/standard/hit.h>
