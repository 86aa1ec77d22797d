//===-- tools/anysl-cost/SceneShaders.cpp - the shaders of a RIB scene ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-cost/SceneShaders.h"
#include "lib/Shade/Options.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/Program.h"
#include <set>
#include <tuple>

using namespace llvm;

namespace anysl::cost {
namespace {

/// Runs a program, which says itself what is wrong.
void runProgram(const std::string &path, ArrayRef<StringRef> arguments) {
  SmallVector<StringRef> words = {path};
  words.append(arguments.begin(), arguments.end());
  std::string message;
  if (int status = sys::ExecuteAndWait(path, words, std::nullopt, {}, 0, 0, &message))
    throw shade::UserError(
        "'" + path + "' failed" +
        (message.empty() ? " with status " + std::to_string(status) : ": " + message));
}

} // namespace

SceneShaders::Folder::Folder() {
  if (std::error_code error = sys::fs::createUniqueDirectory("anysl-scene", path))
    throw shade::UserError("cannot make a folder for temporary files: " + error.message());
}

SceneShaders::Folder::~Folder() { sys::fs::remove_directories(path); }

SceneShaders::SceneShaders(const std::string &programs, const std::string &scene) {
  auto temporary = [&](const Twine &name) { return (folder.path + "/" + name).str(); };
  std::string points = temporary("points");
  runProgram(programs + "/anysl-render",
             {scene, "-o", temporary("picture.exr"), "--record", points, "--quiet"});
  for (shade::RecordedShader &part : shade::readRecording(points))
    recorded.push_back(std::make_shared<shade::RecordedShader>(std::move(part)));
  llvm::sort(recorded, [](auto &a, auto &b) {
    return std::tie(b->points, a->name, a->seeds) < std::tie(a->points, b->name, b->seeds);
  });
  std::set<std::string> sources;
  for (const auto &part : recorded)
    sources.insert(part->file);
  for (const std::string &source : sources) {
    StringRef path = source;
    if (path.ends_with(".so")) {
      leftOut.push_back(source);
    } else if (path.ends_with(".sl")) {
      stcFiles.push_back(
          temporary(Twine(stcFiles.size()) + "-" + sys::path::stem(path) + ".stc.bc"));
      runProgram(programs + "/rslc", {source, "-o", stcFiles.back()});
    } else {
      stcFiles.push_back(source);
    }
  }
}

} // namespace anysl::cost
