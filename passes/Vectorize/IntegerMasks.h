//===-- passes/Vectorize/IntegerMasks.h - masks where there are no mask registers ---*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_INTEGERMASKS_H
#define ANYSL_PASSES_VECTORIZE_INTEGERMASKS_H

#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/IR/Function.h"

namespace anysl {

/// Keeps a variant's masks as vectors of 32-bit integers, all bits of a lane alike, if it is made
/// for an x86 processor without AVX-512. Returns whether anything changed.
///
/// LLVM holds a vector of i1 that crosses a block, or that logic is done on, in lanes as narrow as
/// fit one small register: eight lanes in 16 bits each. Comparisons make 32 bits a lane and blends
/// want them, so every definition is packed and every use unpacked. The sign bit of a 32-bit lane
/// is what AVX's blends, masked moves and movmskps look at. Blends of a number and its negative
/// become exclusive ors of the sign, as blends are the slower without mask registers.
bool keepMasksAsIntegers(llvm::Function &function, const llvm::TargetTransformInfo &target);

/// Whether a variant is made for a processor with AVX-512's mask registers.
bool hasMaskRegisters(const llvm::Function &function, const llvm::TargetTransformInfo &target);

} // namespace anysl

#endif
