//===-- test/unit/Vectorize/Lanes.h - run scalar lanes beside a widened function ----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_UNIT_VECTORIZE_LANES_H
#define ANYSL_TEST_UNIT_VECTORIZE_LANES_H

#include "llvm/IR/Module.h"

#include <memory>
#include <string>

namespace anysl::test {

struct Comparison {
  unsigned width = 8;
  std::string cpu = "x86-64-v3"; ///< what the code is made for
  unsigned rounds = 8;           ///< sets of inputs, each with several masks
  uint64_t seed = 1;
  bool optimizeScalar = false; ///< give the scalar function to LLVM's -O2 first
  bool optimizeCode = true;    ///< as LLVM's -O1 does; else machine code is made in less time
  bool mindFlags = false;      ///< compare floating-point exception flags, too
};

/// Widens `void name(struct Args *args, int lane)` (Kernels.h) and runs it on random inputs beside
/// its scalar self, with all lanes, with random masks, with each single lane, and with none.
/// Everything in memory is compared bit for bit, but that any NaN equals any other. What lanes that
/// are not active would read is chosen to do harm: zero divisors, huge indices, NaN. Returns
/// nothing if all is well, else a description of the first difference.
std::string compareLanes(const llvm::Module &module, llvm::StringRef name, const Comparison &how);

/// Whether this machine can run code for a processor such as "x86-64-v4".
bool canRun(llvm::StringRef cpu);

} // namespace anysl::test

#endif
