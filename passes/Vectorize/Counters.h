//===-- passes/Vectorize/Counters.h - counters that lanes leave a loop with ---------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_COUNTERS_H
#define ANYSL_PASSES_VECTORIZE_COUNTERS_H

#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/IR/Function.h"

namespace anysl {

/// Simplifies what lanes keep of a loop that they leave at different times. Where that is the
/// loop's counter and the processor has no mask registers, it is counted in each active lane, by
/// one addition, in place of a broadcast and a blend at each exit; and what lanes have already is
/// not blended again. Returns whether anything changed.
bool countInLanes(llvm::Function &function, const llvm::TargetTransformInfo &target);

} // namespace anysl

#endif
