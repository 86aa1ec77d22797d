//===-- tools/anysl-cost/Data.cpp - a report as CSV and JSON ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Plot/Plot.h"
#include "tools/anysl-cost/Report.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/raw_ostream.h"
#include <cmath>

using namespace llvm;

namespace anysl::cost {
namespace {

json::Value number(double value) {
  return std::isfinite(value) ? json::Value(value) : json::Value(nullptr);
}

json::Value toJson(const ErrorStats &stats) {
  return json::Object{{"numbers", int64_t(stats.numbers)},
                      {"max", number(stats.max)},
                      {"p999", number(stats.p999)},
                      {"rms", number(stats.rms)},
                      {"maxUlps", number(stats.maxUlps)},
                      {"rmsUlps", number(stats.rmsUlps)},
                      {"changed8", stats.changed8},
                      {"changed16", stats.changed16},
                      {"notNumbers", int64_t(stats.notNumbers)}};
}

json::Value toJson(const Measurement &measurement, bool onFront) {
  const Variant &variant = measurement.variant;
  return json::Object{{"name", variant.name()},
                      {"real", variant.real},
                      {"math", variant.math},
                      {"width", variant.width},
                      {"runtime", measurement.runtime},
                      {"sameCode", json::Array(measurement.sameCode)},
                      {"nsPerPoint", json::Object{{"median", measurement.median},
                                                  {"lowerQuartile", measurement.lower},
                                                  {"upperQuartile", measurement.upper}}},
                      {"error", toJson(measurement.error)},
                      {"arithmetic", toJson(measurement.arithmetic)},
                      {"tier", toJson(measurement.tier)},
                      {"onFront", onFront}};
}

} // namespace

static json::Value toJson(const ShaderCost::SiteCost &site) {
  json::Array options, arguments;
  for (const SiteOption &option : site.study.options)
    options.push_back(json::Object{
        {"tier", option.tier}, {"savedNsPerPoint", option.saved}, {"added", toJson(option.added)}});
  const SiteArguments &seen = site.study.arguments;
  for (unsigned i = 0; i < seen.count; ++i)
    arguments.push_back(json::Array{number(seen.low[i]), number(seen.high[i])});
  const FilePosition &position = site.study.site.position;
  return json::Object{{"file", position.file},
                      {"line", position.line},
                      {"column", position.column},
                      {"function", site.study.site.function},
                      {"op", site.study.op},
                      {"calls", int64_t(seen.calls)},
                      {"arguments", std::move(arguments)},
                      {"chosen", site.chosen},
                      {"timeShare", site.timeShare},
                      {"errorShare", site.errorShare},
                      {"options", std::move(options)}};
}

std::vector<size_t> paretoFront(const ShaderCost &cost) {
  std::vector<plot::Point> points;
  for (const Measurement &measurement : cost.variants)
    points.push_back({measurement.error.rms, measurement.median});
  return plot::paretoFront(points);
}

json::Value toJson(const Report &report) {
  json::Array shaders;
  for (const ShaderCost &cost : report.shaders) {
    std::vector<size_t> front = paretoFront(cost);
    json::Array variants;
    for (size_t i = 0; i < cost.variants.size(); ++i)
      variants.push_back(toJson(cost.variants[i], is_contained(front, i)));
    json::Array sites;
    for (const ShaderCost::SiteCost &site : cost.sites)
      sites.push_back(toJson(site));
    shaders.push_back(json::Object{{"shader", cost.shader},
                                   {"kind", cost.kind},
                                   {"file", cost.file},
                                   {"oracle", cost.oracle},
                                   {"points", int64_t(cost.points)},
                                   {"results", json::Array(cost.results)},
                                   {"functions", json::Array(cost.functions)},
                                   {"summary", json::Array(summary(cost))},
                                   {"variants", std::move(variants)},
                                   {"sites", std::move(sites)}});
  }
  return json::Object{{"version", 1},
                      {"cpu", report.cpu},
                      {"rounds", report.rounds},
                      {"shaders", std::move(shaders)}};
}

std::string toCsv(const Report &report) {
  std::string text;
  raw_string_ostream out(text);
  out << "shader,real,math,width,runtime,ns_per_point,ns_lower_quartile,ns_upper_quartile";
  for (StringRef part : {"error", "arithmetic", "tier"})
    for (StringRef column :
         {"max", "p999", "rms", "max_ulps", "rms_ulps", "changed8", "changed16", "not_numbers"})
      out << ',' << part << '_' << column;
  out << ",on_front\n";
  auto cell = [&](double value) {
    out << ',';
    if (std::isfinite(value))
      out << formatv("{0:e}", value);
  };
  for (const ShaderCost &cost : report.shaders) {
    std::vector<size_t> front = paretoFront(cost);
    for (size_t i = 0; i < cost.variants.size(); ++i) {
      const Measurement &m = cost.variants[i];
      // A mixture's name has commas.
      out << cost.shader << ',' << m.variant.real << ",\"" << m.variant.math << "\","
          << m.variant.width << ',' << m.runtime;
      for (double value : {m.median, m.lower, m.upper})
        cell(value);
      for (const ErrorStats *s : {&m.error, &m.arithmetic, &m.tier}) {
        for (double value :
             {s->max, s->p999, s->rms, s->maxUlps, s->rmsUlps, s->changed8, s->changed16})
          cell(value);
        out << ',' << s->notNumbers;
      }
      out << ',' << is_contained(front, i) << '\n';
    }
  }
  return out.str();
}

} // namespace anysl::cost
