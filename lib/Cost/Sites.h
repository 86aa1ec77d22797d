//===-- lib/Cost/Sites.h - what each call of a function costs ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A site is a place in a shader that computes an elementary function. What it costs is measured by
// giving it alone another tier and leaving all else rounded correctly; what arguments it sees, by a
// build that notes them. From that follows a choice:
// the changes that buy the most time for the error that they add are made one after the other, and
// each is kept only if the whole, measured again, is still exact enough.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_SITES_H
#define ANYSL_LIB_COST_SITES_H

#include "lib/Cost/Probes.h"
#include <functional>

namespace anysl::cost {

/// A site with another tier than the exact one.
struct SiteOption {
  std::string tier;
  double saved = 0; ///< nanoseconds for a point of every shader, of the median
  ErrorStats added; ///< against the exact tier everywhere
};

struct SiteStudy {
  Site site;
  std::string op; ///< the operator called there
  SiteArguments arguments{};
  std::vector<SiteOption> options{}; ///< those whose code differs from the exact one's
};

/// How long to measure, and whom to tell.
struct Timing {
  int rounds = 15;
  double secondsPerSample = 2e-3;
  std::function<void(double share, const std::string &what)> progress;
};

/// Studies the sites of shaders that are linked together and share a builder.
class Sites {
public:
  Sites(std::vector<Bench *> benches, std::string real, unsigned width, Timing timing);

  /// Every site by itself, in the order of files and lines.
  std::vector<SiteStudy> study();

  /// Whether a choice is exact enough, given what it computes for each bench.
  using Accepts = std::function<bool(Bench &bench, Bench::Loaded &loaded)>;
  /// The exact tier everywhere, but for sites where a cheaper one is measured to pay and to be
  /// accepted.
  Choice choose(const std::vector<SiteStudy> &studies, const Accepts &accepts);

  /// Nanoseconds for a point of every shader, of each choice, measured by turns: the medians.
  std::vector<double> time(const std::vector<Choice> &choices);

private:
  bool isAccepted(const Choice &choice, const Accepts &accepts);
  /// What tells one library's code from another's.
  std::string codeOf(const Choice &choice);

  std::vector<Bench *> benches;
  std::string real;
  unsigned width;
  Timing timing;
};

} // namespace anysl::cost

#endif
