//===-- lib/Emit/SharedLibrary.h - from an object to a shared library ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_EMIT_SHAREDLIBRARY_H
#define ANYSL_LIB_EMIT_SHAREDLIBRARY_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

namespace anysl {

/// Links the contents of one ELF object into the shared library `path`, by lld inside this process.
/// Equal objects give equal files, byte for byte. With `strip`, only the dynamic symbols stay. An
/// error if the object calls a function that neither libc nor libm has.
llvm::Error linkSharedLibrary(llvm::StringRef object, llvm::StringRef path, bool strip);

} // namespace anysl

#endif
