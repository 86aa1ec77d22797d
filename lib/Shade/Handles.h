//===-- lib/Shade/Handles.h - the loader's objects, owned ---------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_HANDLES_H
#define ANYSL_LIB_SHADE_HANDLES_H

#include "lib/Shade/Options.h"
#include <anysl/anysl.h>
#include <anysl/notes.h>
#include <cstdio>
#include <memory>

namespace anysl::shade {

template <auto function>
struct Free {
  template <class T>
  void operator()(T *object) const {
    function(object);
  }
};
using LibraryHandle = std::unique_ptr<AnyslLibrary, Free<anysl_library_close>>;
using InstanceHandle = std::unique_ptr<AnyslInstance, Free<anysl_instance_free>>;
using NoteLogHandle = std::unique_ptr<AnyslNoteLog, Free<anysl_note_log_free>>;
/// Prints what a library has noted, each place once; nothing for a null log.
void printNotes(AnyslNoteLog *notes, std::FILE *file);
using BatchHandle = std::unique_ptr<AnyslBatch, Free<anysl_batch_free>>;

/// Throws what the loader says as a UserError.
void check(AnyslStatus status);

/// Opens a library. Throws UserError.
LibraryHandle openLibrary(const std::string &path);
/// The shader of a name, or the library's first, with its defaults.
InstanceHandle makeInstance(AnyslLibrary *library, const std::string *shader,
                            const AnyslServices &services, Environment &environment);
/// Sets a parameter from text: numbers (of float precision, if so asked), or text, as its type is.
/// \p option is named in messages.
void setParam(AnyslInstance *instance, ParamText param, const std::string &option,
              bool asFloats = false);

} // namespace anysl::shade

#endif
