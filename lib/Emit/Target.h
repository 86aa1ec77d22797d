//===-- lib/Emit/Target.h - the machine that code is made for -----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_EMIT_TARGET_H
#define ANYSL_LIB_EMIT_TARGET_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Target/TargetMachine.h"
#include <memory>

namespace anysl {

class DiagnosticEngine;

/// The target for a processor's name (LLVM's; `native` is this machine's, whose features are then
/// exactly those that are there) and a triple (empty: this machine's). Code is position-independent
/// and contracts no floating-point operations. Null, with an error reported, if LLVM does not know
/// one of them.
std::unique_ptr<llvm::TargetMachine> makeTarget(DiagnosticEngine &diags, llvm::StringRef cpu,
                                                llvm::StringRef triple);

} // namespace anysl

#endif
