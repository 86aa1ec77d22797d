//===-- tools/anysl-cost/Html.cpp - a report as a page ----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Mixtures.h"
#include "lib/Plot/Plot.h"
#include "tools/anysl-cost/Report.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/raw_ostream.h"
#include <numeric>

using namespace llvm;

namespace anysl::cost {
namespace {

using plot::escaped;
using plot::shortNumber;

std::string text(const format_object_base &formatted) {
  std::string result;
  raw_string_ostream(result) << formatted;
  return result;
}
std::string nanoseconds(double value) { return text(format("%.2f", value)); }
std::string percent(double share) { return text(format("%.3g %%", 100 * share)); }

bool isMixture(const Measurement &m) { return StringRef(m.variant.math).contains(','); }

/// Which colour a variant has: that of its tier, one for mixtures, one where tiers do not matter.
unsigned seriesOf(const Measurement &m) {
  auto count = unsigned(tiers().size());
  if (isMixture(m))
    return count;
  if (m.sameCode.size() + 1 == count)
    return count + 1;
  return unsigned(find(tiers(), m.variant.math) - tiers().begin());
}

/// "u35", "cr, sin=fast", "double".
std::string labelOf(const Measurement &m) {
  std::string label = seriesOf(m) == tiers().size() + 1 ? "" : m.variant.math;
  if (m.variant.real != "float" || label.empty())
    label = label.empty() ? m.variant.real : m.variant.real + " " + label;
  return label;
}

plot::Plot makePlot(const ShaderCost &cost) {
  plot::Plot result;
  result.title = cost.shader + ": what exactness costs";
  result.xLabel = "error against the " + cost.oracle + " oracle (RMS, in the output\u2019s units)";
  result.yLabel = "nanoseconds a point";
  for (StringRef tier : tiers())
    result.series.push_back(tier.str());
  result.series[0] += " (correctly rounded)";
  result.series[1] += " (\u2264 1 ULP)";
  result.series[2] += " (\u2264 3.5 ULP)";
  result.series[3] += " (about 12 bits)";
  result.series.push_back("mixture of tiers");
  result.series.push_back("the same code in all tiers");
  for (size_t series = 0; series < result.series.size(); ++series)
    if (none_of(cost.variants, [&](const Measurement &m) { return seriesOf(m) == series; }))
      result.series[series].clear();
  std::vector<std::string> reals;
  for (const Measurement &m : cost.variants)
    if (!is_contained(reals, m.variant.real))
      reals.push_back(m.variant.real);
  result.shapes = reals;
  result.markMeaning = "points at once (width)";
  std::vector<size_t> front = paretoFront(cost);
  unsigned widest = 0;
  for (const Measurement &m : cost.variants)
    widest = std::max(widest, m.variant.width);
  for (size_t i = 0; i < cost.variants.size(); ++i) {
    const Measurement &m = cost.variants[i];
    plot::Point point;
    point.x = m.error.rms;
    point.y = m.median;
    point.name = m.variant.name();
    if (m.variant.width == widest || is_contained(front, i))
      point.label = labelOf(m);
    point.mark = std::to_string(m.variant.width);
    point.series = seriesOf(m);
    point.shape = unsigned(find(reals, m.variant.real) - reals.begin());
    point.details = {{"ns a point", nanoseconds(m.median)},
                     {"quartiles", nanoseconds(m.lower) + " \u2013 " + nanoseconds(m.upper)},
                     {"error, RMS", shortNumber(m.error.rms)},
                     {"of it arithmetic", shortNumber(m.arithmetic.rms)},
                     {"of it functions", shortNumber(m.tier.rms)},
                     {"error, 99.9 %", shortNumber(m.error.p999)},
                     {"error, largest", shortNumber(m.error.max)},
                     {"in ULP: RMS, largest",
                      shortNumber(m.error.rmsUlps) + ", " + shortNumber(m.error.maxUlps)},
                     {"8-bit values changed", percent(m.error.changed8)},
                     {"16-bit values changed", percent(m.error.changed16)}};
    result.points.push_back(std::move(point));
    if (m.variant.math == tiers().front() && m.variant.width == widest)
      result.guides.push_back({m.arithmetic.rms, m.variant.real + " arithmetic alone"});
  }
  return result;
}

std::string cell(const std::string &value) { return value; }

std::string variantTable(const ShaderCost &cost) {
  std::vector<size_t> order(cost.variants.size()), front = paretoFront(cost), highlighted;
  std::iota(order.begin(), order.end(), size_t(0));
  llvm::sort(order, [&](size_t a, size_t b) {
    return std::pair(cost.variants[a].median, a) < std::pair(cost.variants[b].median, b);
  });
  std::vector<std::vector<std::string>> rows;
  for (size_t i : order) {
    const Measurement &m = cost.variants[i];
    if (is_contained(front, i))
      highlighted.push_back(rows.size());
    std::string math = escaped(m.variant.math);
    for (const std::string &other : m.sameCode)
      math += " = " + escaped(other);
    const ErrorStats &e = m.error;
    rows.push_back({escaped(m.variant.real), math, std::to_string(m.variant.width),
                    cell(nanoseconds(m.median)),
                    cell(nanoseconds(m.lower) + " \u2013 " + nanoseconds(m.upper)),
                    cell(shortNumber(e.rms)), cell(shortNumber(m.arithmetic.rms)),
                    cell(shortNumber(m.tier.rms)), cell(shortNumber(e.p999)),
                    cell(shortNumber(e.max)), cell(shortNumber(e.rmsUlps)),
                    cell(shortNumber(e.maxUlps)), cell(percent(e.changed8)),
                    cell(percent(e.changed16)), e.notNumbers ? std::to_string(e.notNumbers) : ""});
  }
  return plot::table({"real", "math", "width", "ns a point", "quartiles", "error RMS", "arithmetic",
                      "functions", "99.9 %", "largest", "RMS ULP", "largest ULP", "8-bit", "16-bit",
                      "NaN/inf"},
                     rows, highlighted);
}

std::string rangeText(const SiteArguments &arguments) {
  std::string result;
  for (unsigned i = 0; i < arguments.count && arguments.calls; ++i)
    result += (i ? "; " : "") + shortNumber(arguments.low[i]) + " \u2026 " +
              shortNumber(arguments.high[i]);
  return result;
}

std::string siteTable(const ShaderCost &cost) {
  if (cost.sites.empty())
    return "";
  std::vector<std::vector<std::string>> rows;
  for (const ShaderCost::SiteCost &site : cost.sites) {
    const Site &place = site.study.site;
    std::string function = "<code>" + escaped(place.function) + "</code>";
    if (site.study.op != place.function)
      function += " in " + escaped(site.study.op);
    rows.push_back({escaped(sys::path::filename(place.position.file).str()) + ":" +
                        std::to_string(place.position.line),
                    function, shortNumber(double(site.study.arguments.calls) / double(cost.points)),
                    rangeText(site.study.arguments), site.chosen, percent(site.timeShare),
                    percent(site.errorShare)});
  }
  return "<h3>Each call of a function, in float</h3>\n" +
         plot::table({"line", "function", "calls a point", "arguments seen", "tier chosen",
                      "share of time", "share of error"},
                     rows) +
         "<p class=\"soft\">Share of time: of a point with all functions rounded correctly, what "
         "is "
         "saved if this call alone has its cheapest tier, measured. Share of error: of the squares "
         "of the errors that these changes make. Chosen: the tiers that together save the most "
         "while the error stays within 10&nbsp;% of that of the arithmetic alone.</p>\n";
}

std::string section(const ShaderCost &cost) {
  std::string body =
      "<section>\n" + plot::svg(makePlot(cost), false) + "<div class=\"glance\"><ul>\n";
  for (const std::string &line : summary(cost))
    body += "<li>" + escaped(line) + "</li>\n";
  body += "</ul></div>\n<p class=\"soft\">" + escaped(cost.kind) + " shader <b>" +
          escaped(cost.shader) + "</b> of " + escaped(cost.file) + ", " +
          std::to_string(cost.points) + " points, compared: ";
  for (const std::string &name : cost.results)
    body += (&name == &cost.results.front() ? "" : ", ") + escaped(name);
  if (!cost.functions.empty()) {
    body += "; functions that depend on the tier: ";
    for (const std::string &name : cost.functions)
      body += (&name == &cost.functions.front() ? "" : ", ") + escaped(name);
  }
  body += ".</p>\n" + siteTable(cost) +
          "<h3>All variants, the fastest first; those on the Pareto front are marked</h3>\n" +
          variantTable(cost) + "</section>\n";
  return body;
}

constexpr const char *notes = R"(<details><summary>How to read this</summary>
<ul>
<li><b>Time</b> is processor time of one thread, the median over rounds in which all variants take turns in random order.</li>
<li><b>Error</b> is the distance from what the oracle gives for the same inputs, which are floats for all. RMS, 99.9 % (one number in a thousand
is further off) and the largest are in the output&#8217;s own units; a ULP is the distance from one float to the next at the true value.</li>
<li><b>Arithmetic</b> is the part that is there even if every function is rounded correctly (tier cr); <b>functions</b> is the distance from that. The
whole is at most their sum.</li>
<li><b>8-bit, 16-bit</b>: the share of numbers that change once they are stored as a pixel, without a gamma.</li>
<li>A variant is on the <b>Pareto front</b> if no other is at least as fast and as exact.</li>
</ul></details>
)";

} // namespace

std::string toHtml(const Report &report) {
  std::string names;
  for (const ShaderCost &cost : report.shaders)
    names += (names.empty() ? "" : ", ") + cost.shader;
  std::string body;
  for (const ShaderCost &cost : report.shaders)
    body += section(cost);
  body += notes;
  body += "<p class=\"soft\">anysl-cost " ANYSL_VERSION " on " + escaped(report.cpu) + ", " +
          std::to_string(report.rounds) + " rounds.</p>\n";
  return plot::page("What exactness costs: " + names, body);
}

} // namespace anysl::cost
