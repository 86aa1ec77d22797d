//===-- test/unit/Vectorize/Generator.h - random well-defined functions -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_UNIT_VECTORIZE_GENERATOR_H
#define ANYSL_TEST_UNIT_VECTORIZE_GENERATOR_H

#include "llvm/IR/Module.h"

#include <memory>

namespace anysl::test {

/// A module with a function `void fuzz(struct Args *, int lane)` (Kernels.h) that depends on the
/// seed only.
///
/// Its control flow is a random graph: any block may lead to any other by branches and switches, so
/// loops nest, cross and have several entries; fuel that each step back uses up ends them. It
/// computes with variables of all types, odd widths and pointers among them, some the same in all
/// lanes, reads tables, writes lane-private arrays and its own lane's outputs, and calls helper
/// functions of the same kind, which take and return structures and may be recursive, an opaque
/// function, and one that is declared with variants. All of it is defined for every input: shifts are within range,
/// conversions saturate, divisors are tested. \p mindsFlags leaves out the operations that cannot
/// be made to mind floating-point exception flags.
std::unique_ptr<llvm::Module> generateModule(llvm::LLVMContext &context, uint64_t seed,
                                             bool mindsFlags = false);

} // namespace anysl::test

#endif
