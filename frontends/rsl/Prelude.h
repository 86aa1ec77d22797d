//===-- frontends/rsl/Prelude.h - built-ins that are written in RSL -----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_PRELUDE_H
#define ANYSL_FRONTENDS_RSL_PRELUDE_H

#include "frontends/rsl/Token.h"

namespace anysl::rsl {

/// Functions that stand before a file whose words name one of them, in a scope around its own: what
/// the file defines goes before them. Empty if it names none.
llvm::StringRef preludeFor(llvm::ArrayRef<Token> tokens);

} // namespace anysl::rsl

#endif
