//===-- tools/anysl-render/Options.h - the command line ---------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_OPTIONS_H
#define ANYSL_RENDER_OPTIONS_H

#include "lib/Rib/SceneDescription.h"
#include "tools/anysl-render/ShaderCache.h"

namespace anysl::render {

struct Options {
  std::string scene;
  std::vector<std::string> outputs; ///< instead of the scene's
  ShaderTarget target;
  unsigned threads = 0; ///< 0: as many as the machine runs at once
  int sizeX = 0, sizeY = 0;
  int samplesX = 0, samplesY = 0;
  int maxDepth = -1;
  std::vector<std::string> shaderFolders;
  CachePlace cache;
  std::string statsFile;
  std::string accuracyReport; ///< its folder; empty: a picture instead
  std::string effectsReport;  ///< likewise
  std::string recordFile;     ///< of shading points; empty: none
  bool stats = false, quiet = false, watch = false;
  bool keepGoing = false;
  bool help = false, version = false;
};

extern const char *const helpText;

/// Throws UserError where the command line cannot be understood.
Options parseOptions(int count, char **arguments);

/// Puts what the command line says about size, samples and outputs over what the scene says.
void applyOptions(const Options &options, SceneDescription &scene);

} // namespace anysl::render

#endif
