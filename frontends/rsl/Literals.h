//===-- frontends/rsl/Literals.h - numbers and strings as values --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_LITERALS_H
#define ANYSL_FRONTENDS_RSL_LITERALS_H

#include "llvm/ADT/StringRef.h"
#include <string>

namespace anysl::rsl {

/// The characters that a quoted string stands for. \n \t \r \b \f \v \a \\ \" and octal \ooo are
/// known; any other escaped character stands for itself. An escaped NUL and all behind it is left
/// out, because texts end there.
std::string unquote(llvm::StringRef quoted);

/// The value of a number's spelling; false if it is none.
bool parseNumber(llvm::StringRef text, double &value);

} // namespace anysl::rsl

#endif
