//===-- lib/Cost/Bench.h - one shader on its points, linked in many ways ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_BENCH_H
#define ANYSL_LIB_COST_BENCH_H

#include "lib/Cost/Builder.h"
#include "lib/Cost/Errors.h"
#include "lib/Shade/Timing.h"

namespace anysl::cost {

/// Runs one shader of a builder's files on the same points with one library after the other. Every
/// library gets the same inputs, rounded to float. Its functions throw Failed and shade::UserError.
class Bench {
public:
  /// \p options says which points, in which world, and which results count; library and shader are
  /// set here.
  Bench(Builder &builder, const std::string &shader, shade::GridOptions options);

  /// A library that is open, with the points in it.
  struct Loaded {
    const Build *build;
    std::unique_ptr<shade::Grid> grid;
    shade::BatchHandle batch;
    std::map<unsigned, std::vector<shade::Result>> results; ///< by width

    std::vector<unsigned> widths() const;
  };

  Loaded &load(const std::string &real, const Choice &choice);
  /// What a library gives, shaded once.
  const std::vector<shade::Result> &results(Loaded &loaded, unsigned width);
  /// What the oracle gives.
  const std::vector<shade::Result> &truth();

  ErrorStats error(Loaded &loaded, unsigned width) {
    return compare(results(loaded, width), truth());
  }
  /// Shades all points with a library from elsewhere, one at a time.
  void runOnce(const std::string &library) const;
  /// To be measured: seconds for all points.
  static shade::Candidate candidate(Loaded &loaded, unsigned width);

  const std::string &shader() const { return options.shader.value(); }
  Builder &builder;

private:
  shade::GridOptions options;
  std::map<std::pair<std::string, std::string>, Loaded> libraries; ///< by real and choice
};

} // namespace anysl::cost

#endif
