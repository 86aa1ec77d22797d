//===-- tools/anysl-shade/anysl-shade.cpp - shade a grid without a renderer -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-shade/Output.h"
#include <algorithm>
#include <cstdio>

using namespace anysl::shade;

static void run(Options options) {
  Grid grid(options);
  options.gridWidth = grid.width();
  options.gridHeight = grid.height();
  if (options.bench)
    runBenchmark(options, grid);
  bool print = options.json || !options.print.empty() || options.image.empty();
  if (options.bench && options.image.empty())
    return;
  std::vector<Result> results = grid.shade();
  grid.printNotes();
  if (!options.image.empty())
    writeImage(options, results);
  if (options.bench || !print)
    return;
  // Ci may be there for the image only.
  if (!options.print.empty())
    std::erase_if(results, [&](const Result &result) {
      return std::find(options.print.begin(), options.print.end(), result.name) ==
             options.print.end();
    });
  if (options.json)
    printJson(options, results, grid.isDouble());
  else
    printText(options, results, grid.isDouble());
}

int main(int argc, char **argv) {
  try {
    if (std::optional<Options> options = parseOptions(argc, argv))
      run(*options);
    return 0;
  } catch (const UserError &error) {
    std::fprintf(stderr, "anysl-shade: error: %s\n", error.what());
    return 1;
  } catch (const std::bad_alloc &) {
    std::fputs("anysl-shade: error: out of memory\n", stderr);
    return 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "anysl-shade: internal error: %s; please report this\n", error.what());
    return 2;
  }
}
