//===-- lib/Cost/Blame.cpp - which operator spoilt a result -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Blame.h"
#include "llvm/ADT/STLExtras.h"
#include <cmath>
#include <cstring>
#include <tuple>

using namespace llvm;

namespace anysl::cost {
namespace {

/// Errors that differ by less, in decimal digits, may be the same error.
constexpr double sameError = 0.5;
/// Traces have met again when so many steps are alike, and are not looked for farther than so many
/// steps away.
constexpr uint32_t alikeForLong = 4, farthestMeeting = 512;

bool isSameSite(const AnyslNoteSite &a, const AnyslNoteSite &b) {
  return std::tie(a.line, a.column, a.kind) == std::tie(b.line, b.column, b.kind) &&
         !std::strcmp(a.op, b.op) && !std::strcmp(a.file, b.file);
}

bool areFinite(ArrayRef<double> numbers) {
  return all_of(numbers, [](double x) { return std::isfinite(x); });
}

/// Whether an operator only moves numbers, or takes some of several: if one component has lost more
/// than all together, that is not its fault.
bool isMove(const AnyslNoteSite &site) {
  StringRef op = site.op;
  return any_of(ArrayRef<StringRef>{"copy_", "get_", "set_", "make_", "splat_", "color_from_",
                                    "vector_from_"},
                [&](StringRef prefix) { return op.starts_with(prefix); });
}

/// The largest distance between numbers, and the largest exact one.
std::pair<double, double> distance(ArrayRef<double> numbers, ArrayRef<double> exact) {
  double error = 0, magnitude = 0;
  for (auto [a, b] : zip(numbers, exact)) {
    bool isSame = a == b || (std::isnan(a) && std::isnan(b));
    double off = isSame ? 0 : std::fabs(a - b);
    error = std::max(error, std::isnan(off) ? HUGE_VAL : off);
    magnitude = std::max(magnitude, std::isnan(b) ? 0 : std::fabs(b));
  }
  return {error, magnitude};
}

/// The steps that stored results, the last of each name.
std::map<std::string, uint32_t> storesOf(const Trace &trace) {
  std::map<std::string, uint32_t> result;
  for (auto [i, step] : enumerate(trace.steps))
    if (step.isStore())
      result[step.site->op] = uint32_t(i);
  return result;
}

/// The step that computed what another stored or copied.
uint32_t originOf(const Trace &trace, uint32_t step) {
  for (;;) {
    const TraceStep &current = trace.steps[step];
    bool isCopy = current.isStore() || StringRef(current.site->op).starts_with("copy_");
    if (!isCopy || current.readsFrom.size() != 1)
      return step;
    step = current.readsFrom.front();
  }
}

} // namespace

double digitsOf(StringRef real) { return (real == "double" ? 53 : 24) * std::log10(2.0); }

double lostDigits(ArrayRef<double> numbers, ArrayRef<double> exact, double digits) {
  auto [error, magnitude] = distance(numbers, exact);
  if (error == 0)
    return 0;
  if (!std::isfinite(error))
    return HUGE_VAL;
  return std::clamp(digits + std::log10(error / magnitude), 0.0, digits);
}

TraceComparison::TraceComparison(const Trace &rounded, const Trace &exact, double digits)
    : rounded(rounded), exact(exact), steps(rounded.steps.size()) {
  align(digits);
  std::map<std::string, uint32_t> exactStores = storesOf(exact);
  for (const auto &[name, step] : storesOf(rounded)) {
    auto found = exactStores.find(name);
    if (found == exactStores.end())
      continue;
    ComparedResult result = {name, 0, 0, 0, step, found->second};
    ArrayRef<double> numbers = rounded.steps[step].numbers(),
                     truth = exact.steps[found->second].numbers();
    std::tie(result.error, result.magnitude) = distance(numbers, truth);
    result.lost = lostDigits(numbers, truth, digits);
    // It is wrong even if exact arithmetic does not do better.
    if (!areFinite(numbers) || !areFinite(truth))
      result.error = result.lost = HUGE_VAL;
    compared.push_back(std::move(result));
  }
}

/// Finds each step's like, also behind branches, where the two have met again.
void TraceComparison::align(double digits) {
  std::optional<uint32_t> branch;
  auto roundedCount = uint32_t(rounded.steps.size()), exactCount = uint32_t(exact.steps.size());
  uint32_t i = 0, j = 0;
  while (i < roundedCount && j < exactCount) {
    const TraceStep &a = rounded.steps[i], &b = exact.steps[j];
    bool isSame = isSameSite(*a.site, *b.site);
    if (isSame) {
      steps[i].exact = j;
      steps[i].branch = branch;
      if (!a.isDecision()) {
        steps[i].lost = lostDigits(a.numbers(), b.numbers(), digits);
        steps[i].error = distance(a.numbers(), b.numbers()).first;
      } else if (a.results[0] != b.results[0]) {
        branch = i;
        firstBranch = firstBranch.value_or(i);
      }
      ++i, ++j;
      continue;
    }
    auto met = meetAgain(i, j);
    uint32_t end = met ? met->first : roundedCount;
    for (; i < end; ++i)
      steps[i].branch = branch;
    j = met ? met->second : exactCount;
  }
  for (; i < roundedCount; ++i)
    steps[i].branch = branch;
}

/// The nearest steps from which on both do the same again.
std::optional<std::pair<uint32_t, uint32_t>> TraceComparison::meetAgain(uint32_t i,
                                                                        uint32_t j) const {
  auto isAlike = [&](uint32_t a, uint32_t b) {
    for (uint32_t k = 0; k < alikeForLong; ++k) {
      bool ended[] = {a + k >= rounded.steps.size(), b + k >= exact.steps.size()};
      if (ended[0] || ended[1])
        return k && ended[0] && ended[1];
      if (!isSameSite(*rounded.steps[a + k].site, *exact.steps[b + k].site))
        return false;
    }
    return true;
  };
  for (uint32_t distance = 1; distance < farthestMeeting; ++distance)
    for (uint32_t a = 0; a <= distance; ++a)
      if (isAlike(i + a, j + distance - a))
        return std::pair(i + a, j + distance - a);
  return std::nullopt;
}

std::optional<Culprit> TraceComparison::branch() const {
  if (!firstBranch)
    return std::nullopt;
  return Culprit{Cause::Branch, *firstBranch, *steps[*firstBranch].exact, 0};
}

std::optional<Culprit> TraceComparison::branchBefore(uint32_t step) const {
  if (!steps[step].branch)
    return std::nullopt;
  uint32_t branch = *steps[step].branch;
  return Culprit{Cause::Branch, branch, *steps[branch].exact, 0};
}

bool TraceComparison::isFinite(uint32_t step) const {
  return areFinite(rounded.steps[step].numbers());
}

/// Back to the first operator that made what is not finite of what is.
std::optional<Culprit> TraceComparison::followNotFinite(uint32_t step) const {
  for (;;) {
    if (!steps[step].exact)
      return branchBefore(step);
    auto &reads = rounded.steps[step].readsFrom;
    auto *from = find_if(reads, [&](uint32_t read) { return !isFinite(read); });
    if (from == reads.end())
      return Culprit{Cause::NotFinite, step, *steps[step].exact, 0};
    step = *from;
  }
}

/// How unlike the error of an operand is to that of what was computed of it, in digits: it went on
/// as it is, as in a sum, or in proportion, as in a product.
double TraceComparison::unlikeness(uint32_t operand, uint32_t step) const {
  const Compared &a = steps[operand], &b = steps[step];
  // What was computed on another way may well be it.
  if (!a.exact)
    return sameError;
  if (a.error == 0 || !std::isfinite(a.error))
    return HUGE_VAL;
  return std::min(std::fabs(std::log10(a.error / b.error)), std::fabs(a.lost - b.lost));
}

/// The operand that the error of a step came with; nothing if it reads none.
std::optional<uint32_t> TraceComparison::carrier(uint32_t step) const {
  auto &reads = rounded.steps[step].readsFrom;
  auto rank = [&](uint32_t read) {
    // Of several that may be it, the one that has lost most.
    double unlike = unlikeness(read, step);
    return std::pair(unlike < sameError ? 0 : unlike, -steps[read].lost);
  };
  auto *found = llvm::min_element(reads, [&](uint32_t a, uint32_t b) { return rank(a) < rank(b); });
  return found == reads.end() ? std::nullopt : std::optional(*found);
}

/// Back along the error, to where most digits were lost at once.
std::optional<Culprit> TraceComparison::followDigits(uint32_t step) const {
  std::optional<Culprit> worst;
  for (;;) {
    if (!steps[step].exact)
      return branchBefore(step);
    std::optional<uint32_t> from = carrier(step);
    double lost = steps[step].lost;
    double added = lost - (from ? std::min(steps[*from].lost, lost) : 0);
    const AnyslNoteSite &site = *rounded.steps[step].site;
    if ((!worst || added > worst->added) && !isMove(site) && !rounded.steps[step].isStore())
      worst = {Cause::LostDigits, step, *steps[step].exact, added};
    if (!from)
      return worst;
    step = *from;
  }
}

std::optional<Culprit> TraceComparison::blame(const ComparedResult &result) const {
  // What is stored behind a branch may have been computed before it.
  uint32_t step = originOf(rounded, result.rounded);
  if (steps[step].exact != originOf(exact, result.exact))
    return branchBefore(step);
  if (!isFinite(step))
    return followNotFinite(step);
  return followDigits(step);
}

} // namespace anysl::cost
