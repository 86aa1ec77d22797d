//===-- lib/Support/Output.cpp - files that are whole or not there ------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Support/Output.h"
#include "lib/Support/Diagnostics.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Signals.h"

using namespace llvm;

namespace anysl {
namespace {

bool isSpecialFile(StringRef path) {
  sys::fs::file_status status;
  return !sys::fs::status(path, status) && sys::fs::exists(status) &&
         !sys::fs::is_regular_file(status);
}

/// Reports and gives false.
bool fail(DiagnosticEngine &diags, StringRef path, const Twine &reason) {
  diags.error(FilePosition{path.str()}, reason);
  return false;
}

bool cannotWrite(DiagnosticEngine &diags, StringRef path, std::error_code code) {
  return fail(diags, path, "cannot write the file: " + code.message());
}

/// Writes to a stream that is no file of ours: standard output, a device.
bool writeDirectly(DiagnosticEngine &diags, StringRef path,
                   function_ref<Error(raw_pwrite_stream &)> write) {
  std::error_code code;
  raw_fd_ostream out(path, code);
  if (code)
    return cannotWrite(diags, path, code);
  // Standard output may be a pipe, in which nothing can be overwritten.
  SmallString<0> contents;
  raw_svector_ostream buffer(contents);
  if (Error error = write(buffer))
    return fail(diags, path, toString(std::move(error)));
  out << contents;
  out.flush();
  if (out.has_error()) {
    code = out.error();
    out.clear_error();
    return cannotWrite(diags, path, code);
  }
  return true;
}

} // namespace

bool writeNamedFile(DiagnosticEngine &diags, StringRef path, function_ref<Error(StringRef)> write) {
  SmallString<128> temporary;
  if (std::error_code code = sys::fs::createUniqueFile(path + ".tmp-%%%%%%%%", temporary))
    return cannotWrite(diags, path, code);
  sys::RemoveFileOnSignal(temporary);
  auto finish = [&](bool good) {
    if (!good)
      sys::fs::remove(temporary);
    sys::DontRemoveFileOnSignal(temporary);
    return good;
  };
  if (Error error = write(temporary))
    return finish(fail(diags, path, toString(std::move(error))));
  if (isSpecialFile(path)) {
    std::error_code code = sys::fs::copy_file(temporary, path);
    finish(false);
    return code ? cannotWrite(diags, path, code) : true;
  }
  if (std::error_code code = sys::fs::rename(temporary, path))
    return finish(cannotWrite(diags, path, code));
  return finish(true);
}

bool writeFile(DiagnosticEngine &diags, StringRef path,
               function_ref<Error(raw_pwrite_stream &)> write) {
  if (path == "-" || isSpecialFile(path))
    return writeDirectly(diags, path, write);
  return writeNamedFile(diags, path, [&](StringRef temporary) -> Error {
    std::error_code code;
    raw_fd_ostream out(temporary, code);
    if (code)
      return createStringError("cannot write the file: " + code.message());
    if (Error error = write(out)) {
      out.clear_error();
      return error;
    }
    out.close();
    if (out.has_error()) {
      code = out.error();
      out.clear_error();
      return createStringError("cannot write the file: " + code.message());
    }
    return Error::success();
  });
}

} // namespace anysl
