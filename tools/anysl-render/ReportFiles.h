//===-- tools/anysl-render/ReportFiles.h - files that reports are written to --------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_REPORTFILES_H
#define ANYSL_RENDER_REPORTFILES_H

#include "lib/Demand/Json.h"

#include <filesystem>
#include <fstream>

namespace anysl::render {

/// Makes a report's folder if it is not there. Throws UserError where that cannot be.
inline void makeReportFolder(const std::filesystem::path &folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw UserError("cannot make the folder '" + folder.string() + "': " + error.message());
}

/// Throws UserError where the file cannot be written.
inline void writeReportFile(const std::filesystem::path &path, const std::string &text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out)
    throw UserError("cannot write '" + path.string() + "'");
}

} // namespace anysl::render

#endif
