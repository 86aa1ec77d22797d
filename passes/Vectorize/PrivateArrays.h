//===-- passes/Vectorize/PrivateArrays.h - arrays that each lane has for itself -----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_PRIVATEARRAYS_H
#define ANYSL_PASSES_VECTORIZE_PRIVATEARRAYS_H

#include "llvm/IR/Function.h"
#include "llvm/IR/Instructions.h"

namespace anysl {

/// Lays the variables of \p width lanes out element by element: element i of lane 0, of lane 1 …,
/// then element i + 1. An index that is the same for all lanes is then a load or store of a whole
/// vector, where copies that lie one after the other are gathered and scattered.
///
/// That is done to variables that the function uses by itself, and whose elements are all of one
/// size. They are marked, and their alloca has room for all lanes. Returns whether anything
/// changed.
bool interleavePrivateArrays(llvm::Function &function, unsigned width);

/// The size in bytes of an element of a variable laid out element by element; 0 for others.
uint64_t interleavedElementSize(const llvm::AllocaInst &variable);

/// Where control decides which of several variables is loaded from or stored to, moves the access
/// to where each is known, so that the variables may become registers. LLVM leaves such accesses
/// when it unrolls a loop over an array. Returns whether anything changed.
bool accessKnownVariables(llvm::Function &function);

/// The size in bytes of all that is loaded from and stored to a variable, if it is one size; else
/// 0. What copies or fills memory does not count.
uint64_t accessSize(const llvm::AllocaInst &variable);

} // namespace anysl

#endif
