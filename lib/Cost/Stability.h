//===-- lib/Cost/Stability.h - where a shader loses digits ------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Searches a shader's inputs for points where rounding spoils its results, and finds the operator
// to blame. Every point is computed twice, rounded (with float or double) and exactly (with the
// oracle), operator by operator (Trace.h):
//
//   * An operator's result has lost as many digits as its relative distance from the exact one
//     says; of a triple all components count together.
//   * Of a spoilt result, the chain of operators that its error came through is followed back:
//     always to the operand whose error is most like that of what was made of it, in its own units,
//     as in a sum, or in digits, as in a product. To blame is the operator of the chain that added
//     most to the loss.
//   * Where a condition or an array's index comes out differently, that is to blame for what is
//     computed on one of the two ways only.
//   * Where a result is NaN or infinite, the chain is followed to the first operator that gave
//     such a number.
//
// Whatever is wrong by less than a unit in the last place of the result's largest value over all
// points counts as right. After the given points come others about the worst of them: on the lines
// to each other and some besides, from far to near, again and again. The idea of following errors
// through shadow values is that of A. Sanchez-Stern et al., "Finding Root Causes of Floating Point
// Error", PLDI 2018.
//
// The real `interval` says of how many points it is proven, whatever may be rounded, that no more
// than the limit is lost.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_STABILITY_H
#define ANYSL_LIB_COST_STABILITY_H

#include "lib/Cost/Builder.h"
#include "lib/Cost/Points.h"
#include "lib/Cost/Trace.h"
#include <functional>

namespace anysl::cost {

struct StabilitySettings {
  /// The points, their world, and which results count. Library and width are set here.
  shade::GridOptions grid;
  std::string real = "float"; ///< or "double"
  double limit = 3;           ///< decimal digits that a result may lose
  unsigned rounds = 12;       ///< of points about the worst
};

enum class Cause { LostDigits, Branch, NotFinite };

/// What rounding did at one operator of one point.
struct Incident {
  std::string result; ///< the global or parameter that is wrong; empty: none is, beyond the limit
  double lost = 0;    ///< digits of that
  double added = 0;   ///< digits that this operator lost of what its operands had
  std::vector<std::vector<double>> operands; ///< of the operator
  std::vector<double> value, exactValue;     ///< its result
  /// What was computed of it at last.
  std::vector<double> resultValue, exactResult;
  /// Whether exact arithmetic gives finite numbers there.
  bool isExactFinite = true;
  size_t point = 0; ///< of the given ones, or behind them
  /// The point's inputs: globals and varying parameters.
  Inputs inputs;
};

/// A place in a shader that spoils results.
struct UnstablePlace {
  Cause cause;
  FilePosition position;
  std::string op;         ///< the operator's name in STC
  size_t points = 0;      ///< of the given ones, how many it spoils
  size_t foundPoints = 0; ///< and of those about the worst
  Incident worst;
};

/// A condition that interval bounds do not decide.
struct UndecidedPlace {
  FilePosition position;
  std::string op;
  size_t points = 0;
};

/// What was found about one shader.
struct StabilityReport {
  std::string shader, kind, file, real, oracle;
  double limit = 0, digits = 0; ///< digits that the real has
  size_t points = 0, foundPoints = 0;
  unsigned width = 0, height = 0; ///< of the grid; 0: recorded points
  /// For each given point the digits that its worst result lost; infinity: NaN, or no number where
  /// there should be one.
  std::vector<double> lost;
  /// Where each given point is in a picture, from 0 to 1; empty: nowhere, or in the grid's order.
  std::vector<std::array<float, 2>> places;
  size_t unstable = 0;          ///< given points that lost more than the limit
  std::optional<size_t> proven; ///< given points that surely do not; nothing: not known of the real
  std::vector<UnstablePlace> unstablePlaces; ///< the worst first
  std::vector<UndecidedPlace> undecided;     ///< by file and line
  bool isComplete = true;                    ///< false: loops were too long to follow
};

/// Searches the points of one shader of a builder's files. Throws Failed and shade::UserError.
StabilityReport findInstability(Builder &builder, const std::string &shader,
                                const StabilitySettings &settings,
                                const std::function<void(double share)> &progress);

/// Decimal digits of a real: 7.2 of float.
double digitsOf(llvm::StringRef real);

/// How many of `digits` numbers have lost, given the exact ones: 0 to `digits`, infinity where just
/// one of the two is finite.
double lostDigits(llvm::ArrayRef<double> numbers, llvm::ArrayRef<double> exact, double digits);

} // namespace anysl::cost

#endif
