//===-- passes/Vectorize/Remarks.h - telling what became of a function --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_REMARKS_H
#define ANYSL_PASSES_VECTORIZE_REMARKS_H

#include "passes/Vectorize/Vectorize.h"

namespace anysl {

/// Hands a remark to the options' sink and to the context's diagnostic handler, as LLVM's remark of
/// the pass `anysl-vectorize`: passed, missed, or analysis, by its kind.
class Remarks {
public:
  explicit Remarks(const VectorizeOptions &options) : options(options) {}

  void emit(VectorizeRemark::Kind kind, const llvm::Function &function, llvm::DebugLoc location,
            const llvm::Twine &message) const;

private:
  const VectorizeOptions &options;
};

} // namespace anysl

#endif
