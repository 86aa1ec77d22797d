//===-- lib/Cost/Sites.cpp - what each call of a function costs -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Sites.h"
#include "lib/Cost/Mixtures.h"
#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace anysl::cost {
namespace {

const std::string &exactTier() {
  static const std::string name = tiers()[0].str();
  return name;
}

Choice withSites(std::vector<std::pair<Site, std::string>> sites) {
  return {exactTier(), std::move(sites)};
}

} // namespace

Sites::Sites(std::vector<Bench *> benches, std::string real, unsigned width, Timing timing)
    : benches(std::move(benches)), real(std::move(real)), width(width), timing(std::move(timing)) {}

std::string Sites::codeOf(const Choice &choice) {
  return benches.front()->load(real, choice).build->code;
}

std::vector<double> Sites::time(const std::vector<Choice> &choices) {
  std::vector<shade::Candidate> candidates;
  std::vector<double> scales;
  for (const Choice &choice : choices)
    for (Bench *bench : benches) {
      Bench::Loaded &loaded = bench->load(real, choice);
      candidates.push_back(Bench::candidate(loaded, width));
      scales.push_back(1e9 / double(loaded.grid->pointCount()));
    }
  shade::measure(candidates, timing.rounds, timing.secondsPerSample,
                 [&](double share) { timing.progress(0.6 + 0.4 * share, "timing"); });
  std::vector<double> result(choices.size());
  for (size_t i = 0; i < candidates.size(); ++i)
    result[i / benches.size()] += candidates[i].quantile(0.5) * scales[i];
  return result;
}

std::vector<SiteStudy> Sites::study() {
  std::vector<SiteStudy> studies;
  const Build &exact = benches.front()->builder.build(real, {exactTier()});
  for (Bench *bench : benches)
    for (const link::ShaderReport &report : exact.report.shaders)
      if (report.name == bench->shader())
        for (const link::MathCall &call : report.mathCalls) {
          std::vector<std::string> functions;
          for (const auto &[function, tier] : call.functions)
            functions.push_back(function);
          for (const std::string &function : functionsWithTiers(functions)) {
            SiteStudy study{{call.position, function}, call.op};
            if (none_of(studies, [&](const SiteStudy &other) {
                  return other.site.name() == study.site.name();
                }))
              studies.push_back(std::move(study));
          }
        }

  // One library for each site and tier; those that come out alike need no measuring.
  std::vector<Choice> choices = {{exactTier()}};
  std::vector<std::pair<SiteStudy *, StringRef>> owners;
  std::vector<std::string> codes = {exact.code};
  size_t done = 0;
  for (SiteStudy &study : studies)
    for (StringRef tier : tiers().drop_front()) {
      timing.progress(0.6 * double(done++) / double(studies.size() * (tiers().size() - 1)),
                      study.site.name() + "=" + tier.str());
      Choice choice = withSites({{study.site, tier.str()}});
      std::string code = codeOf(choice);
      if (is_contained(codes, code))
        continue;
      codes.push_back(code);
      choices.push_back(choice);
      owners.push_back({&study, tier});
    }
  if (owners.empty())
    return studies;
  std::vector<double> times = time(choices);
  for (size_t i = 0; i < owners.size(); ++i) {
    SiteOption option{owners[i].second.str(), times[0] - times[i + 1], {}};
    for (Bench *bench : benches) {
      ErrorStats added = compare(bench->results(bench->load(real, choices[i + 1]), width),
                                 bench->results(bench->load(real, choices[0]), width));
      if (added.rms >= option.added.rms)
        option.added = added;
    }
    owners[i].first->options.push_back(std::move(option));
  }
  std::vector<SiteArguments> arguments = probe(benches, real);
  for (SiteStudy &study : studies)
    for (const SiteArguments &seen : arguments)
      if (seen.site.name() == study.site.name())
        study.arguments = seen;
  return studies;
}

bool Sites::isAccepted(const Choice &choice, const Accepts &accepts) {
  return all_of(benches, [&](Bench *bench) { return accepts(*bench, bench->load(real, choice)); });
}

Choice Sites::choose(const std::vector<SiteStudy> &studies, const Accepts &accepts) {
  std::vector<Move> moves;
  std::map<std::string, const Site *> siteOf;
  for (const SiteStudy &study : studies) {
    siteOf[study.site.name()] = &study.site;
    for (const SiteOption &option : study.options)
      // Errors of independent functions add up as squares do.
      moves.push_back(
          {study.site.name(), option.tier, option.saved, option.added.rms * option.added.rms});
  }
  std::map<std::string, std::string> tierOf;
  auto choiceOf = [&](const std::map<std::string, std::string> &wanted) {
    Choice choice{exactTier()};
    for (const auto &[name, tier] : wanted)
      choice.sites.push_back({*siteOf.at(name), tier});
    return choice;
  };
  std::vector<Move> order = greedyOrder(std::move(moves));
  for (size_t i = 0; i < order.size(); ++i) {
    timing.progress(double(i) / double(order.size()), order[i].subject + "=" + order[i].tier);
    auto tried = tierOf;
    tried[order[i].subject] = order[i].tier;
    if (isAccepted(choiceOf(tried), accepts))
      tierOf = std::move(tried);
  }
  return choiceOf(tierOf);
}

} // namespace anysl::cost
