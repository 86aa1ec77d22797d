//===-- passes/Vectorize/StridedAccess.h - records in memory, lane by lane ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_STRIDEDACCESS_H
#define ANYSL_PASSES_VECTORIZE_STRIDEDACCESS_H

#include "llvm/IR/Function.h"

namespace anysl {

/// Replaces gathers and scatters of all lanes whose addresses lie two, three or four elements
/// apart, as the x of an array of points does, by loads and stores of whole vectors and shuffles.
/// Returns whether anything changed.
///
/// A gather may stand alone: what lies between two lanes is in the same object, and reading it does
/// no harm. Scatters have to be all members of the record.
bool widenStridedAccess(llvm::Function &function);

} // namespace anysl

#endif
