//===-- tools/anysl-shade/Benchmark.cpp - what a shader costs at each width -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Timing.h"
#include "tools/anysl-shade/Output.h"
#include <cstdio>

namespace anysl::shade {
namespace {

constexpr int rounds = 21;
constexpr double secondsPerSample = 2e-3;

} // namespace

void runBenchmark(const Options &options, const Grid &grid) {
  BatchHandle batch = grid.makeBatch(0, uint32_t(grid.pointCount()));
  std::vector<uint32_t> widths;
  for (uint32_t i = 0; i < grid.shader().entry_count; ++i)
    if (uint32_t width = grid.shader().entries[i].width; !options.width || options.width == width)
      widths.push_back(width);
  if (widths.empty()) // asked for one that is not there
    grid.secondsFor(batch.get(), options.width, 1);
  std::vector<Candidate> candidates;
  for (uint32_t width : widths)
    candidates.push_back(
        {[&, width](unsigned times) { return grid.secondsFor(batch.get(), width, times); }});
  measure(candidates, rounds, secondsPerSample);
  auto median = [&](size_t i) {
    return candidates[i].quantile(0.5) / double(grid.pointCount()) * 1e9;
  };
  if (options.json) {
    std::printf("{\"shader\":\"%s\",\"points\":%zu,\"rounds\":%d,\"bench\":[", grid.shader().name,
                grid.pointCount(), rounds);
    for (size_t i = 0; i < widths.size(); ++i)
      std::printf("%s{\"width\":%u,\"ns_per_point\":%.6g}", i ? "," : "", widths[i], median(i));
    std::puts("]}");
    return;
  }
  std::printf("%s, %zu points, median of %d rounds\n", grid.shader().name, grid.pointCount(),
              rounds);
  std::printf("%8s %10s %9s\n", "width", "ns/point", "speed-up");
  for (size_t i = 0; i < widths.size(); ++i)
    std::printf("%8u %10.3f %9.2f\n", widths[i], median(i), median(0) / median(i));
}

} // namespace anysl::shade
