//===-- frontends/rsl/Condition.h - the conditions of #if ---------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_CONDITION_H
#define ANYSL_FRONTENDS_RSL_CONDITION_H

#include "frontends/rsl/Token.h"
#include "lib/Support/Diagnostics.h"

namespace anysl::rsl {

/// Whether the integer expression behind #if or #elif is not 0. Macros are expanded already; names
/// that are left count as 0. An error is reported, at \p loc where nothing better is known, and
/// does not hold.
bool conditionHolds(llvm::ArrayRef<Token> tokens, llvm::SMLoc loc, DiagnosticEngine &diags);

} // namespace anysl::rsl

#endif
