//===-- lib/Link/NeutralOps.h - stands in for operators that a renderer declines ----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_NEUTRALOPS_H
#define ANYSL_LIB_LINK_NEUTRALOPS_H

#include "lib/STC/Ops.h"
#include "llvm/IR/Module.h"
#include <memory>

namespace anysl::link {

/// What an operator of Neutral.def gives where nobody defines it, in words; empty for any other.
llvm::StringRef neutralMeaning(stc::Op op);

/// A module that defines every operator of Neutral.def by its neutral value.
std::unique_ptr<llvm::Module> makeNeutralOps(llvm::LLVMContext &context);

/// A module that defines the operators that a scene does without as Unneeded.def says; null if
/// there are none.
std::unique_ptr<llvm::Module> makeUnneededOps(llvm::LLVMContext &context,
                                              llvm::ArrayRef<stc::Op> ops);

} // namespace anysl::link

#endif
