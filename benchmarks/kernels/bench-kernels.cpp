//===-- benchmarks/kernels/bench-kernels.cpp - times contestants, compares their results ------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
//   anysl-bench-kernels [--rounds=N] [--only=kernel] REFERENCE=CONTESTANT.so ...
//
// Opens each contestant and prints one line for each kernel that it has: kernel, contestant, the
// median and the quartiles of the time in ns a point, how many points differ in any bit from the
// reference (another contestant's file name without the suffix), and the largest difference in ULP.
//
// All data fits the second-level cache. The rounds visit every contestant in turn, so that what
// disturbs the machine disturbs all alike; the time is the thread's own processor time.
//
//===------------------------------------------------------------------------------------------===//

#include "benchmarks/kernels/Kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <time.h>
#include <vector>

namespace {

constexpr int Count = 4096, Side = 64;

/// The inputs, and one set of outputs.
class Patch {
public:
  Patch() {
    std::mt19937 random(1);
    auto uniform = [&](float low, float high) {
      return low + (high - low) * float(random() >> 8) * 0x1p-24f;
    };
    auto directions = [&](float *x, float *y, float *z) {
      for (int i = 0; i < Count; ++i) {
        float height = uniform(-1, 1), angle = uniform(0, 6.2831853f);
        float radius = std::sqrt(1 - height * height);
        x[i] = radius * std::cos(angle), y[i] = radius * std::sin(angle), z[i] = height;
      }
    };
    float *ix = array(Count), *iy = array(Count), *iz = array(Count);
    directions(ix, iy, iz);
    float *nx = array(Count), *ny = array(Count), *nz = array(Count);
    directions(nx, ny, nz);
    float *px = array(Count), *py = array(Count), *pz = array(Count), *chance = array(Count);
    float *u = array(Count), *v = array(Count), *triples = array(3 * Count);
    for (int i = 0; i < Count; ++i) {
      px[i] = uniform(-4, 4), py[i] = uniform(-4, 4), pz[i] = uniform(-4, 4);
      chance[i] = uniform(0, 1);
      u[i] = float(i % Side) / Side, v[i] = float(i / Side) / Side;
      for (int k = 0; k < 3; ++k)
        triples[3 * i + k] = uniform(-2, 2);
    }
    float *spheres = array(4 * 32), *image = array(Side * Side);
    for (int s = 0; s < 32; ++s) {
      for (int k = 0; k < 3; ++k)
        spheres[4 * s + k] = uniform(-9, 9);
      spheres[4 * s + 3] = uniform(0.2f, 4);
    }
    std::generate_n(image, Side * Side, [&] { return uniform(0, 1); });
    for (int i = 0; i < 256; ++i)
      permutation[i] = i;
    std::shuffle(permutation, permutation + 256, random);
    for (int k = 0; k < 3; ++k)
      outputs.push_back(array(Count));
    outputs.push_back(array(3 * Count));
    points = {ix,      iy,    iz,         nx,         ny,         nz,        px,
              py,      pz,    u,          v,          chance,     triples,   permutation,
              spheres, image, outputs[0], outputs[1], outputs[2], outputs[3]};
  }

  /// What a kernel writes, one value after the other.
  std::vector<float> run(KernelLoop *kernel) {
    for (int k = 0; k < 4; ++k)
      std::fill_n(outputs[k], k < 3 ? Count : 3 * Count, -77.0f);
    kernel(&points, Count);
    std::vector<float> all;
    for (int k = 0; k < 4; ++k)
      all.insert(all.end(), outputs[k], outputs[k] + (k < 3 ? Count : 3 * Count));
    return all;
  }

  KernelPoints points;

private:
  float *array(size_t size) {
    return static_cast<float *>(std::aligned_alloc(64, (size * sizeof(float) + 63) & ~size_t(63)));
  }

  int permutation[256];
  std::vector<float *> outputs;
};

struct Contestant {
  std::string name, reference;
  void *library;
};

struct Entry {
  std::string kernel;
  const Contestant *contestant;
  KernelLoop *loop;
  int repetitions = 1;
  std::vector<double> times;
  size_t differing = 0;
  double distance = 0;
};

double processorSeconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// ns a point.
double timeOnce(const Entry &entry, const KernelPoints &points) {
  double start = processorSeconds();
  for (int i = 0; i < entry.repetitions; ++i)
    entry.loop(&points, Count);
  return 1e9 * (processorSeconds() - start) / (double(entry.repetitions) * Count);
}

/// How many floats lie between a and b.
double ulpsBetween(float a, float b) {
  if (std::isnan(a) || std::isnan(b))
    return std::isnan(a) && std::isnan(b) ? 0 : INFINITY;
  auto place = [](float x) {
    int32_t bits = std::bit_cast<int32_t>(x);
    return int64_t(bits < 0 ? INT32_MIN - int64_t(bits) : bits);
  };
  return double(std::abs(place(a) - place(b)));
}

} // namespace

int main(int argc, char **argv) {
  int rounds = 15;
  std::string only;
  std::vector<Contestant> contestants;
  for (int i = 1; i < argc; ++i) {
    std::string argument = argv[i];
    if (argument.starts_with("--rounds=")) {
      rounds = std::max(1, std::atoi(argument.c_str() + 9));
      continue;
    }
    if (argument.starts_with("--only=")) {
      only = argument.substr(7);
      continue;
    }
    size_t equals = argument.find('=');
    std::filesystem::path file = argument.substr(equals == std::string::npos ? 0 : equals + 1);
    void *library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (equals == std::string::npos || !library) {
      std::fprintf(stderr, "anysl-bench-kernels: %s\n",
                   library ? "REFERENCE=CONTESTANT.so expected" : dlerror());
      return 1;
    }
    contestants.push_back({file.stem().string(), argument.substr(0, equals), library});
  }

  Patch patch;
  std::vector<Entry> entries;
  std::map<std::pair<std::string, std::string>, std::vector<float>> results;
  auto add = [&](const char *kernel) {
    if (!only.empty() && only != kernel)
      return;
    for (const Contestant &contestant : contestants)
      if (void *loop = dlsym(contestant.library, (std::string(kernel) + "_points").c_str())) {
        entries.push_back({kernel, &contestant, reinterpret_cast<KernelLoop *>(loop), 1, {}, 0, 0});
        results[{kernel, contestant.name}] = patch.run(entries.back().loop);
      }
  };
#define KERNEL_ENTRY(name, description) add(#name);
#include "benchmarks/kernels/Kernels.def"

  constexpr double sliceSeconds = 5e-4;
  for (Entry &entry : entries) {
    const auto &own = results[{entry.kernel, entry.contestant->name}];
    const auto &reference = results[{entry.kernel, entry.contestant->reference}];
    for (size_t i = 0; i < std::min(own.size(), reference.size()); ++i) {
      entry.differing += std::bit_cast<uint32_t>(own[i]) != std::bit_cast<uint32_t>(reference[i]);
      entry.distance = std::max(entry.distance, ulpsBetween(own[i], reference[i]));
    }
    double once = timeOnce(entry, patch.points) * 1e-9 * Count;
    entry.repetitions = std::clamp(int(sliceSeconds / once), 1, 10000);
  }
  for (int round = 0; round < rounds; ++round)
    for (Entry &entry : entries)
      entry.times.push_back(timeOnce(entry, patch.points));

  for (Entry &entry : entries) {
    std::sort(entry.times.begin(), entry.times.end());
    auto quantile = [&](double q) {
      return entry.times[size_t(q * double(entry.times.size() - 1) + 0.5)];
    };
    std::printf("%s\t%s\t%.4f\t%.4f\t%.4f\t%zu\t%.0f\n", entry.kernel.c_str(),
                entry.contestant->name.c_str(), quantile(0.5), quantile(0.25), quantile(0.75),
                entry.differing, entry.distance);
  }
}
