//===-- test/unit/STC/Samples.h - modules to test with ------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_UNIT_STC_SAMPLES_H
#define ANYSL_TEST_UNIT_STC_SAMPLES_H

#include "lib/STC/Reader.h"
#include "lib/Support/Diagnostics.h"
#include <memory>
#include <string>
#include <vector>

namespace sample {

/// A small shader with a parameter, an array, a branch, a loop, a function of its own, and a text;
/// it uses every construct that STC has.
std::unique_ptr<llvm::Module> shader(llvm::LLVMContext &context);

/// The module as an STC file, as an LLVM file without checksum, and as text.
std::string withChecksum(const llvm::Module &module);
std::string plainBitcode(const llvm::Module &module);
std::string text(const llvm::Module &module);

/// What reading `contents` gives, and the errors that it reports.
struct ReadResult {
  std::optional<anysl::stc::StcModule> module;
  std::vector<anysl::Diagnostic> errors;

  std::string firstError() const { return errors.empty() ? "" : errors[0].message; }
};
ReadResult read(llvm::LLVMContext &context, llvm::StringRef contents);

} // namespace sample

#endif
