//===-- lib/Cost/Experiment.cpp - what a shader costs in many variants ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Experiment.h"
#include "lib/Cost/Mixtures.h"
#include "lib/Shade/Timing.h"
#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace anysl::cost {

std::string Variant::name() const { return real + " " + math + " \u00d7" + std::to_string(width); }

Experiment::Experiment(Builder &builder, const std::string &shader, Settings given,
                       ProgressFunction progress)
    : bench(builder, shader, given.grid), settings(std::move(given)),
      progress(std::move(progress)) {}

void Experiment::addVariants(const std::string &real, const std::string &math,
                             const std::vector<unsigned> &widths, std::vector<Measurement> &list) {
  Bench::Loaded &loaded = bench.load(real, {math});
  // Of variants with the same code only the first is measured.
  auto [same, isNew] = mathOfCode.try_emplace(real + loaded.build->code, math);
  if (!isNew) {
    for (Measurement &measurement : list)
      if (measurement.variant.real == real && measurement.variant.math == same->second)
        measurement.sameCode.push_back(math);
    return;
  }
  Bench::Loaded &exact = bench.load(real, {tiers()[0].str()});
  for (unsigned width : widths) {
    Measurement measurement;
    measurement.variant = {real, math, width};
    measurement.runtime = loaded.build->runtime;
    measurement.error = bench.error(loaded, width);
    measurement.arithmetic = bench.error(exact, width);
    measurement.tier = compare(bench.results(loaded, width), bench.results(exact, width));
    list.push_back(std::move(measurement));
  }
}

void Experiment::measureAll(std::vector<Measurement> &list, double from, double to) {
  std::vector<shade::Candidate> candidates;
  for (const Measurement &measurement : list) {
    Bench::Loaded &loaded = bench.load(measurement.variant.real, {measurement.variant.math});
    candidates.push_back(Bench::candidate(loaded, measurement.variant.width));
  }
  shade::measure(candidates, settings.rounds, settings.secondsPerSample,
                 [&](double share) { progress(from + (to - from) * share, "timing"); });
  for (size_t i = 0; i < list.size(); ++i) {
    Bench::Loaded &loaded = bench.load(list[i].variant.real, {list[i].variant.math});
    double scale = 1e9 / double(loaded.grid->pointCount());
    list[i].median = candidates[i].quantile(0.5) * scale;
    list[i].lower = candidates[i].quantile(0.25) * scale;
    list[i].upper = candidates[i].quantile(0.75) * scale;
  }
}

/// Single changes of a tier show what each function is worth; the best of them are then made one
/// after the other.
void Experiment::addMixtures(ShaderCost &cost) {
  const std::string real = "float", exactName = tiers()[0].str();
  if (!is_contained(settings.reals, real) || cost.functions.size() < 2)
    return;
  unsigned width = bench.load(real, {exactName}).widths().back();
  std::vector<Measurement> singles;
  size_t done = 0;
  for (const std::string &function : cost.functions)
    for (StringRef tier : tiers().drop_front()) {
      progress(0.45 + 0.15 * double(done++) / double(cost.functions.size() * (tiers().size() - 1)),
               function + "=" + tier.str());
      Mixture mixture{{{function, tier.str()}}};
      addVariants(real, mixture.name(), {width}, singles);
    }
  // The exact one takes part, so that what is saved is told by the same rounds.
  Measurement exact;
  exact.variant = {real, exactName, width};
  singles.push_back(exact);
  measureAll(singles, 0.6, 0.7);
  double exactTime = singles.back().median;
  singles.pop_back();

  std::vector<Move> moves;
  for (const Measurement &single : singles) {
    auto [function, tier] = StringRef(single.variant.math).split(',').second.split('=');
    // Errors of independent functions add up as squares do.
    moves.push_back(
        {function.str(), tier.str(), exactTime - single.median, single.tier.rms * single.tier.rms});
  }
  Mixture mixture;
  std::vector<Measurement> greedy;
  for (const Move &move : greedyOrder(std::move(moves))) {
    mixture.tierOf[move.subject] = move.tier;
    if (mixture.tierOf.size() > 1)
      addVariants(real, mixture.name(), {width}, greedy);
  }
  cost.variants.insert(cost.variants.end(), singles.begin(), singles.end());
  cost.variants.insert(cost.variants.end(), greedy.begin(), greedy.end());
}

void Experiment::addSites(ShaderCost &cost) {
  const std::string real = "float", exactName = tiers()[0].str();
  if (!is_contained(settings.reals, real) || cost.functions.empty())
    return;
  Bench::Loaded &exact = bench.load(real, {exactName});
  unsigned width = exact.widths().back();
  Timing timing{settings.rounds, settings.secondsPerSample,
                [&](double share, const std::string &what) { progress(0.7 + 0.2 * share, what); }};
  Sites sites({&bench}, real, width, timing);
  std::vector<SiteStudy> studies = sites.study();
  double limit = nearFloor * bench.error(exact, width).rms;
  Choice chosen = sites.choose(studies, [&](Bench &, Bench::Loaded &loaded) {
    return bench.error(loaded, width).rms <= limit;
  });
  double exactTime = sites.time({{exactName}}).front(), squares = 0;
  auto cheapest = [](const SiteStudy &study) {
    const SiteOption *best = nullptr;
    for (const SiteOption &option : study.options)
      if (!best || option.saved > best->saved)
        best = &option;
    return best;
  };
  for (const SiteStudy &study : studies)
    if (const SiteOption *option = cheapest(study))
      squares += option->added.rms * option->added.rms;
  for (SiteStudy &study : studies) {
    ShaderCost::SiteCost &site = cost.sites.emplace_back();
    site.chosen = exactName;
    for (const auto &[place, tier] : chosen.sites)
      if (place.name() == study.site.name())
        site.chosen = tier;
    if (const SiteOption *option = cheapest(study)) {
      site.timeShare = option->saved / exactTime;
      site.errorShare = squares > 0 ? option->added.rms * option->added.rms / squares : 0;
    }
    site.study = std::move(study);
  }
}

/// Whether a result has one value, at all points.
static bool isSameEverywhere(const shade::Result &result) {
  for (size_t i = result.perPoint(); i < result.values.size(); ++i)
    if (result.values[i] != result.values[i - result.perPoint()])
      return false;
  return true;
}

ShaderCost Experiment::run() {
  ShaderCost cost;
  std::vector<std::pair<std::string, std::string>> wanted = {
      {bench.builder.oracle(), tiers()[0].str()}};
  for (const std::string &real : settings.reals)
    for (StringRef tier : tiers())
      wanted.push_back({real, tier.str()});
  for (size_t i = 0; i < wanted.size(); ++i) {
    const auto &[real, math] = wanted[i];
    progress(0.45 * double(i) / double(wanted.size()), real + " " + math);
    Bench::Loaded &loaded = bench.load(real, {math});
    if (i)
      addVariants(real, math, loaded.widths(), cost.variants);
    else
      cost.oracle = real;
  }
  Bench::Loaded &first = bench.load(settings.reals.front(), {tiers()[0].str()});
  cost.shader = bench.shader();
  cost.kind = anysl_kind_name(first.grid->shader().kind);
  cost.points = first.grid->pointCount();
  for (const shade::Result &result : bench.results(first, first.widths().front()))
    cost.results.push_back(result.name);
  cost.isSameEverywhere = cost.points > 1 && llvm::all_of(bench.truth(), isSameEverywhere);
  cost.isLit = !settings.grid.lights.empty() || !settings.grid.recorded.empty();
  for (const link::ShaderReport &report : first.build->report.shaders)
    if (report.name == bench.shader()) {
      std::vector<std::string> functions;
      for (const link::MathCall &call : report.mathCalls)
        for (const auto &[function, tier] : call.functions)
          functions.push_back(function);
      cost.functions = functionsWithTiers(functions);
    }
  addMixtures(cost);
  if (settings.sites)
    addSites(cost);
  measureAll(cost.variants, 0.9, 1);
  return cost;
}

} // namespace anysl::cost
