//===-- lib/Support/VerifyDiagnostics.h - expected messages in the source that causes them -*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A test states what a compiler must say in comments of its input:
//
//     color c = "red";     // expected-error {{a value of type 'string' is no 'color'}}
//     f(1);                // expected-error@+2 {{unknown function 'f'}} expected-note@-3 {{…}}
//
// The text in braces must occur in a message of that severity on that line. A number before the
// braces
// (`expected-error 2 {{…}}`) says how often; `expected-note@*` means any
// place. Messages that nothing expects, and expectations that nothing
// meets, are failures; notes only count where some are expected.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SUPPORT_VERIFYDIAGNOSTICS_H
#define ANYSL_LIB_SUPPORT_VERIFYDIAGNOSTICS_H

#include "lib/Support/Diagnostics.h"

namespace anysl {

/// Holds messages against the expectations in all loaded sources; true if they agree, else the
/// differences are printed.
bool verifyDiagnostics(DiagnosticEngine &engine, llvm::ArrayRef<Diagnostic> messages,
                       llvm::raw_ostream &out);

} // namespace anysl

#endif
