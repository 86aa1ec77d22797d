//===-- benchmarks/shading/ShadingBenchmark.cpp - shading alone, by width ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
//   anysl-bench-shading [Google Benchmark's options] [--agree] LIBRARY.so...
//
// Registers one benchmark for each shader of each library at each width it was built for, named
// <file>/<shader>/<width>; `points` counts points a second. Each is checked against the first width
// of the same shader before anything is timed; with --agree, shaders of one name in several
// libraries are checked against the first library's.
//
//===------------------------------------------------------------------------------------------===//

#include "ShadingPoints.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace anysl::benchmarks;

namespace {

struct Free {
  void operator()(AnyslLibrary *library) const { anysl_library_close(library); }
  void operator()(AnyslInstance *instance) const { anysl_instance_free(instance); }
  void operator()(AnyslBatch *batch) const { anysl_batch_free(batch); }
};

/// One shader with its points, shared by the benchmarks of all its widths.
struct Subject {
  std::unique_ptr<AnyslInstance, Free> instance;
  std::unique_ptr<AnyslBatch, Free> batch;

  std::vector<float> shade(uint32_t width) {
    std::vector<float> color(3 * pointCount);
    if (anysl_shade(instance.get(), batch.get(), 0, pointCount, width) != ANYSL_OK ||
        anysl_batch_read_float(batch.get(), ANYSL_Ci, 0, pointCount, color.data(), 3) != ANYSL_OK)
      return {};
    return color;
  }
};

[[noreturn]] void fail(const std::string &message) {
  std::fprintf(stderr, "anysl-bench-shading: error: %s\n", message.c_str());
  std::exit(1);
}

/// What the first of each shader gives, by the name of file and shader, or of the shader alone.
using Expectations = std::map<std::string, std::vector<float>>;

void registerShader(const std::string &file, AnyslLibrary *library, const AnyslShaderInfo &shader,
                    const std::string &key, Expectations &expectations) {
  AnyslInstance *instance;
  AnyslBatch *batch;
  if (anysl_instance_create(library, shader.name, &services(), nullptr, &instance) != ANYSL_OK ||
      anysl_batch_create(instance, pointCount, 1ull << ANYSL_Ci, &batch) != ANYSL_OK)
    fail(anysl_last_error());
  auto subject = std::make_shared<Subject>();
  subject->instance.reset(instance);
  subject->batch.reset(batch);
  fillBatch(batch);

  std::vector<float> &expected = expectations[key];
  if (expected.empty())
    expected = subject->shade(shader.entries[0].width);
  for (uint32_t i = 0; i < shader.entry_count; ++i) {
    uint32_t width = shader.entries[i].width;
    std::vector<float> color = subject->shade(width);
    if (color.size() != expected.size())
      fail(anysl_last_error());
    for (size_t k = 0; k < color.size(); ++k)
      if (!(std::fabs(color[k] - expected[k]) <= 1e-5f * (1 + std::fabs(expected[k]))))
        fail(file + ": width " + std::to_string(width) + " differs at point " +
             std::to_string(k / 3));
    std::string name = file + "/" + shader.name + "/" + std::to_string(width);
    benchmark::RegisterBenchmark(name.c_str(), [subject, width](benchmark::State &state) {
      for (auto iteration : state) {
        anysl_shade(subject->instance.get(), subject->batch.get(), 0, pointCount, width);
        benchmark::ClobberMemory();
      }
      state.counters["points"] = benchmark::Counter(double(pointCount) * double(state.iterations()),
                                                    benchmark::Counter::kIsRate);
    });
  }
}

} // namespace

int main(int argc, char **argv) {
  benchmark::Initialize(&argc, argv);
  std::vector<std::string> files(argv + 1, argv + argc);
  bool agree = std::erase(files, "--agree") > 0;
  if (files.empty())
    fail("no shader library given");
  std::vector<std::unique_ptr<AnyslLibrary, Free>> libraries;
  Expectations expectations;
  for (const std::string &path : files) {
    AnyslLibrary *library;
    if (anysl_library_open(path.c_str(), 0, &library) != ANYSL_OK)
      fail(anysl_last_error());
    libraries.emplace_back(library);
    const AnyslLibraryInfo *info = anysl_library_info(library);
    std::string file = std::filesystem::path(path).stem().string();
    for (uint32_t k = 0; k < info->shader_count; ++k) {
      std::string name = info->shaders[k].name;
      registerShader(file, library, info->shaders[k], agree ? name : path + "/" + name,
                     expectations);
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
