//===-- lib/Cost/Points.cpp - points of a shader made of others
//-----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Points.h"
#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace anysl::cost {

void mix(const shade::RecordedShader &pool, const std::vector<Mixed> &wanted,
         shade::RecordedShader &result) {
  result.points = uint32_t(wanted.size());
  auto mixAll = [&](const std::vector<shade::RecordedShader::Values> &all,
                    std::vector<shade::RecordedShader::Values> &mixed) {
    for (const auto &values : all) {
      auto &out =
          mixed.emplace_back(shade::RecordedShader::Values{values.name, values.components, {}});
      for (const Mixed &point : wanted)
        for (size_t c = 0; c < values.components; ++c) {
          double from = values.numbers[point.from * values.components + c];
          double to = values.numbers[point.to * values.components + c];
          // Infinity stays, where all have it.
          out.numbers.push_back(float(from == to ? from : from + (to - from) * point.share));
        }
    }
  };
  for (auto [all, mixed] : zip(pool.lists(), result.lists())) {
    mixed->clear();
    mixAll(*all, *mixed);
  }
  result.seeds.clear();
  for (const Mixed &point : wanted)
    result.seeds.push_back(pool.seeds[point.from]);
}

void append(shade::RecordedShader &pool, const shade::RecordedShader &more) {
  auto appendAll = [](auto &all, const auto &added) {
    for (auto [values, extra] : zip(all, added))
      values.numbers.insert(values.numbers.end(), extra.numbers.begin(), extra.numbers.end());
  };
  for (auto [all, added] : zip(pool.lists(), more.lists()))
    appendAll(*all, *added);
  pool.seeds.insert(pool.seeds.end(), more.seeds.begin(), more.seeds.end());
  pool.points += more.points;
}

void sortBySeed(shade::RecordedShader &shader) {
  shade::RecordedShader sorted = shader;
  std::vector<Mixed> order(shader.points);
  for (uint32_t i = 0; i < shader.points; ++i)
    order[shader.seeds[i]] = {i, i, 0};
  mix(shader, order, sorted);
  shader = std::move(sorted);
}

Inputs inputsOf(const shade::RecordedShader &pool, size_t point, uint64_t globalsRead) {
  Inputs result;
  for (auto *list : {&pool.globals, &pool.varying})
    for (const shade::RecordedShader::Values &values : *list) {
      int global = anysl_global_find(values.name.c_str());
      if (list == &pool.globals && !(globalsRead >> global & 1))
        continue;
      auto from = values.numbers.begin() + std::ptrdiff_t(point * values.components);
      result.push_back({values.name, {from, from + values.components}});
    }
  return result;
}

} // namespace anysl::cost
