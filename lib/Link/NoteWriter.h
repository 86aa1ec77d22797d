//===-- lib/Link/NoteWriter.h - calls that tell a host of something ----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_NOTEWRITER_H
#define ANYSL_LIB_LINK_NOTEWRITER_H

#include "lib/Link/Session.h"
#include "llvm/IR/IRBuilder.h"
#include <anysl/notes.h>

namespace anysl::link {

/// The runtime's function that hands notes on.
inline constexpr llvm::StringLiteral noteName = "anysl_note";

/// Puts calls of anysl_note into one function of a shader.
class NoteWriter {
public:
  /// \p context is the function's shading context.
  NoteWriter(Session &session, const Shader &shader, llvm::Value *context);

  /// A note with at most as many numbers, doubles, as <anysl/notes.h> has room for.
  void write(llvm::IRBuilder<> &builder, const FilePosition &position, uint32_t kind,
             llvm::StringRef name, llvm::ArrayRef<llvm::Value *> results,
             llvm::ArrayRef<llvm::Value *> operands);

private:
  llvm::Constant *text(llvm::StringRef value);

  Session &session;
  const Shader &shader;
  llvm::Value *context;
  llvm::StructType *type; ///< AnyslNoteSite
  llvm::StringMap<llvm::GlobalVariable *> texts;
};

/// The shader and those of its functions that have a shading context, with that.
void forEachWithContext(const Shader &shader,
                        llvm::function_ref<void(llvm::Function &, llvm::Value *context)> visit);

} // namespace anysl::link

#endif
