//===-- tools/anysl-shade/Benchmark.cpp - what a shader costs at each width -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// All widths take turns, so that a machine that slows down does so for all alike; the thread's own
// processor time is measured, so that other programs do not count; and medians are compared, so
// that a disturbed round does not matter.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-shade/Output.h"
#include <algorithm>
#include <cstdio>
#include <ctime>

namespace anysl::shade {
namespace {

constexpr int rounds = 21;
constexpr double secondsPerSample = 2e-3;

/// Seconds of processor time that this thread has had: other programs do not count.
double now() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

struct Candidate {
  uint32_t width;
  unsigned repetitions = 1;
  std::vector<double> samples; ///< nanoseconds per point, a round each

  double median() const {
    std::vector<double> sorted = samples;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

class Benchmark {
public:
  explicit Benchmark(const Grid &grid)
      : grid(grid), count(uint32_t(grid.pointCount())), batch(grid.makeBatch(0, count)) {}

  /// Seconds that shading the batch takes, \p repetitions times.
  double run(uint32_t width, unsigned repetitions) {
    // Fresh inputs: a shader may move P at every run.
    grid.fill(batch.get(), 0, count);
    double start = now();
    for (unsigned i = 0; i < repetitions; ++i)
      if (anysl_shade(grid.instance(), batch.get(), 0, count, width))
        throw UserError(anysl_last_error());
    return now() - start;
  }

  /// How often to repeat so that one sample is long enough for the clock. Also warms up.
  unsigned calibrate(uint32_t width) {
    unsigned repetitions = 1;
    while (run(width, repetitions) < secondsPerSample / 2)
      repetitions *= 2;
    double once = run(width, repetitions) / repetitions;
    return std::max(1u, unsigned(secondsPerSample / once));
  }

  void sample(Candidate &candidate) {
    double seconds = run(candidate.width, candidate.repetitions);
    candidate.samples.push_back(seconds / candidate.repetitions / count * 1e9);
  }

private:
  const Grid &grid;
  uint32_t count;
  BatchHandle batch;
};

} // namespace

void runBenchmark(const Options &options, const Grid &grid) {
  Benchmark benchmark(grid);
  std::vector<Candidate> candidates;
  for (uint32_t i = 0; i < grid.shader().entry_count; ++i) {
    uint32_t width = grid.shader().entries[i].width;
    if (!options.width || options.width == width)
      candidates.push_back({width, benchmark.calibrate(width), {}});
  }
  if (candidates.empty()) // asked for one that is not there
    benchmark.run(options.width, 1);
  for (int round = 0; round < rounds; ++round)
    for (Candidate &candidate : candidates)
      benchmark.sample(candidate);
  double reference = candidates[0].median();
  if (options.json) {
    std::printf("{\"shader\":\"%s\",\"points\":%zu,\"rounds\":%d,\"bench\":[", grid.shader().name,
                grid.pointCount(), rounds);
    for (const Candidate &candidate : candidates)
      std::printf("%s{\"width\":%u,\"ns_per_point\":%.6g}", &candidate == &candidates[0] ? "" : ",",
                  candidate.width, candidate.median());
    std::puts("]}");
    return;
  }
  std::printf("%s, %zu points, median of %d rounds\n", grid.shader().name, grid.pointCount(),
              rounds);
  std::printf("%8s %10s %9s\n", "width", "ns/point", "speed-up");
  for (const Candidate &candidate : candidates)
    std::printf("%8u %10.3f %9.2f\n", candidate.width, candidate.median(),
                reference / candidate.median());
}

} // namespace anysl::shade
