//===-- runtimes/scalar/hit.cpp - what rays meet first, one by one ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/hit-call.h>

namespace {

__attribute__((noinline)) void findHit(ANYSL_HIT_PARAMETERS) {
  anysl::askForHits(ANYSL_HIT_ARGUMENTS, 1, 1);
}

} // namespace

#include <anysl/standard/hit.h>
