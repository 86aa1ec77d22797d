//===-- lib/Cost/Bench.cpp - one shader on its points, linked in many ways --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Bench.h"
#include "lib/Cost/Mixtures.h"

namespace anysl::cost {

Bench::Bench(Builder &builder, const std::string &shader, shade::GridOptions given)
    : builder(builder), options(std::move(given)) {
  options.shader = shader;
  options.floatInputs = true;
}

std::vector<unsigned> Bench::Loaded::widths() const {
  std::vector<unsigned> result;
  const AnyslShaderInfo &info = grid->shader();
  for (uint32_t i = 0; i < info.entry_count; ++i)
    result.push_back(info.entries[i].width);
  return result;
}

Bench::Loaded &Bench::load(const std::string &real, const Choice &choice) {
  auto [place, isNew] = libraries.try_emplace({real, choice.name()});
  Loaded &loaded = place->second;
  if (!isNew)
    return loaded;
  loaded.build = &builder.build(real, choice);
  shade::GridOptions wanted = options;
  wanted.library = loaded.build->library;
  loaded.grid = std::make_unique<shade::Grid>(wanted);
  loaded.batch = loaded.grid->makeBatch(0, uint32_t(loaded.grid->pointCount()));
  return loaded;
}

const std::vector<shade::Result> &Bench::results(Loaded &loaded, unsigned width) {
  auto [place, isNew] = loaded.results.try_emplace(width);
  if (isNew)
    place->second = loaded.grid->shade(width);
  return place->second;
}

const std::vector<shade::Result> &Bench::truth() {
  return results(load(builder.oracle(), {tiers()[0].str(), {}}), 1);
}

void Bench::runOnce(const std::string &library) const {
  shade::GridOptions wanted = options;
  wanted.library = library;
  (void)shade::Grid(wanted).shade(1);
}

shade::Candidate Bench::candidate(Loaded &loaded, unsigned width) {
  return {[&loaded, width](unsigned times) {
    return loaded.grid->secondsFor(loaded.batch.get(), width, times);
  }};
}

} // namespace anysl::cost
