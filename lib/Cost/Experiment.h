//===-- lib/Cost/Experiment.h - what a shader costs in many variants --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Shades the same points with each variant of a shader, and says how long that takes and how far
// the results are from the truth: those of the oracle, the real of the highest precision that
// there is. All variants and the oracle get the same inputs, rounded to float. The error has two
// parts:
//
//   arithmetic   the same real with functions rounded correctly (tier `cr`), against the oracle
//   tier         the variant against the same real with `cr`
//
// They add up to no less than the error: rms <= arithmetic.rms + tier.rms, by the triangle
// inequality.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_EXPERIMENT_H
#define ANYSL_LIB_COST_EXPERIMENT_H

#include "lib/Cost/Sites.h"
#include <functional>

namespace anysl::cost {

/// A variant whose RMS error is within this factor of that of the arithmetic counts as on its
/// floor.
constexpr double nearFloor = 1.1;

struct Variant {
  std::string real, math;
  unsigned width = 1;

  /// "float u35 x16"
  std::string name() const;
};

struct Measurement {
  Variant variant;
  std::string runtime;
  /// Other math tiers whose code is the same.
  std::vector<std::string> sameCode;
  /// Nanoseconds of processor time a point: median and quartiles.
  double median = 0, lower = 0, upper = 0;
  ErrorStats error, arithmetic, tier;
};

struct Settings {
  /// The points, their world, and which results count. Library and width are set here.
  shade::GridOptions grid;
  std::vector<std::string> reals = {"float", "double"};
  std::vector<unsigned> widths = {1, 4, 8, 16};
  bool sites = true; ///< study each call of a function
  int rounds = 15;
  double secondsPerSample = 2e-3;
};

/// What one shader costs.
struct ShaderCost {
  std::string shader, kind, file;
  std::string oracle; ///< a real
  size_t points = 0;
  std::vector<std::string> results; ///< names of the outputs that are compared
  /// The truth is the same at every point, so that the variants say little of the shader.
  bool isSameEverywhere = false;
  bool isLit = false;                 ///< lights shine on the points
  std::vector<std::string> functions; ///< of which the tiers differ
  std::vector<Measurement> variants;
  /// Every call of such a function in the shader, for float at the widest width.
  struct SiteCost {
    SiteStudy study;
    std::string chosen; ///< its tier in the mixture that stays near the floor of the arithmetic
    /// Of the time of the exact tier, what its cheapest tier saves; and of the squares of all
    /// sites' errors in their cheapest tiers, its own part.
    double timeShare = 0, errorShare = 0;
  };
  std::vector<SiteCost> sites;
};

/// Measures one shader of a builder's files.
class Experiment {
public:
  using ProgressFunction = std::function<void(double share, const std::string &what)>;

  Experiment(Builder &builder, const std::string &shader, Settings settings,
             ProgressFunction progress);

  /// Every real with every math tier, at every width, mixtures of tiers, and the greedy ones among
  /// them. Throws Failed and shade::UserError.
  ShaderCost run();

private:
  void measureAll(std::vector<Measurement> &list, double from, double to);
  void addVariants(const std::string &real, const std::string &math,
                   const std::vector<unsigned> &widths, std::vector<Measurement> &list);
  void addMixtures(ShaderCost &cost);
  void addSites(ShaderCost &cost);

  Bench bench;
  Settings settings;
  ProgressFunction progress;
  std::map<std::string, std::string> mathOfCode; ///< by real and code, the first tier that gave it
};

} // namespace anysl::cost

#endif
