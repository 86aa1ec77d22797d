//===-- lib/STC/Verifier.h - holds the rules of subroutine-threaded code ------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The rules are in docs/architecture.md, under "Subroutine-threaded code". What passes here never
// crashes a later stage, and a later stage need not ask again: operands have the types of the op
// table, array elements lie within their arrays, numbers of globals, cells and parameters exist.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_VERIFIER_H
#define ANYSL_STC_VERIFIER_H

#include "lib/STC/Shader.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/Error.h"

namespace anysl::stc {

/// A broken rule, and the shader's line where that is known.
struct Problem {
  FilePosition position;
  std::string message;
};

/// Every rule that the module breaks, in the order of the module; none if it is good. LLVM's own
/// verifier runs first, and if it objects, its first objection is all there is.
std::vector<Problem> verify(const llvm::Module &module);

/// The module's shaders. An error if the metadata is missing, malformed or of another version.
llvm::Expected<std::vector<ShaderInfo>> readShaders(const llvm::Module &module);
/// The producer that the metadata names; empty if there is none.
std::string readProducer(const llvm::Module &module);

} // namespace anysl::stc

#endif
