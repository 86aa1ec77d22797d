//===-- lib/Rib/RibReader.h - RIB file to scene -----------------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_RIBREADER_H
#define ANYSL_LIB_RIB_RIBREADER_H

#include "lib/Rib/SceneDescription.h"

namespace anysl::render {

class RibState;

/// Reads a scene in the RenderMan Interface Bytestream: one description for each WorldBegin ...
/// WorldEnd. Requests that are not known get one warning a name and are passed over.
/// Throws UserError where the text cannot be understood.
std::vector<SceneDescription> readRib(std::shared_ptr<const SourceFile> file, Warnings &warnings);

/// Hands the requests of a file to the state, one after the other.
void readRequests(const std::shared_ptr<const SourceFile> &file, RibState &state);

/// Reads the file with this name, unpacked if it is gzip'ed; throws UserError where it cannot.
std::shared_ptr<const SourceFile> loadSourceFile(const std::string &path);

} // namespace anysl::render

#endif
