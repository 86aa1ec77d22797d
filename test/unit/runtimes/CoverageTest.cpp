//===-- test/unit/runtimes/CoverageTest.cpp - each operator is called by a test ---------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"

// In this file references are weak, so that the table can name operators which other modules
// define.
extern "C" {
#define STC_OP(id, name, ...) __attribute__((weak)) decltype(anysl_##name) anysl_##name;
#include <anysl/StcOps.def>
}

TEST_CASE("every operator of the table that is defined here is tested") {
  struct Entry {
    const char *name;
    void *address;
  };
  const Entry table[] = {
#define STC_OP(id, name, ...) {#name, reinterpret_cast<void *>(anysl_##name)},
#include <anysl/StcOps.def>
  };
  int defined = 0;
  for (const Entry &entry : table) {
    if (!entry.address)
      continue;
    ++defined;
    INFO(entry.name);
    CHECK(calledOperators().count(entry.address) == 1);
  }
  CHECK(defined > 20);
}
