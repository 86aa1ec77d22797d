//===-- passes/Vectorize/LoopExits.h - exits of a loop that may be one --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_LOOPEXITS_H
#define ANYSL_PASSES_VECTORIZE_LOOPEXITS_H

namespace llvm {
class Function;
}

namespace anysl {

/// Makes one exit of exits of a loop that meet after little more than a computation of their own:
/// it is done before the loop is left. Widened, each exit would keep its lanes' values and which
/// lanes they are in registers of its own for as long as the loop runs. Returns whether anything
/// has changed.
bool mergeLoopExits(llvm::Function &function);

} // namespace anysl

#endif
