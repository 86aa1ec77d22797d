//===-- tools/anysl-cost/Summary.cpp - what one should know first -----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Mixtures.h"
#include "tools/anysl-cost/Report.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace anysl::cost {
namespace {

std::string ratio(double value) { return formatv("{0:f1}", value).str(); }
std::string small(double value) { return formatv("{0}", format("%.2g", value)).str(); }

/// The fastest of the variants that fit; null if none does.
template <typename Fits>
const Measurement *fastest(const ShaderCost &cost, Fits fits) {
  const Measurement *best = nullptr;
  for (const Measurement &measurement : cost.variants)
    if (fits(measurement) && (!best || measurement.median < best->median))
      best = &measurement;
  return best;
}

} // namespace

std::vector<std::string> summary(const ShaderCost &cost) {
  std::vector<std::string> lines;
  auto uniform = [&](StringRef real, StringRef tier) {
    return fastest(cost, [&](const Measurement &m) {
      return m.variant.real == real && (m.variant.math == tier || is_contained(m.sameCode, tier));
    });
  };
  if (cost.isSameEverywhere)
    lines.push_back("Results are the same at every point, which says little of the shader" +
                    std::string(cost.isLit ? "." : ": there are no lights (--light)."));
  const Measurement *exact = uniform("float", tiers().front());
  const Measurement *cheapest = uniform("float", tiers().back());
  const Measurement *wide = uniform("double", tiers().front());
  if (exact && exact->arithmetic.rms > 0) {
    double floor = exact->arithmetic.rms;
    lines.push_back("Float arithmetic alone sets a floor: with every function rounded correctly "
                    "the error is still " +
                    small(floor) + " (RMS), " + small(exact->arithmetic.max) + " at worst.");
    const Measurement *good = fastest(cost, [&](const Measurement &m) {
      return m.variant.real == "float" && m.error.rms <= nearFloor * floor;
    });
    if (good && good->median < exact->median)
      lines.push_back("The fastest variant on that floor is " + good->variant.name() + ": " +
                      ratio(good->median) + " ns a point, " + ratio(exact->median / good->median) +
                      " times as fast as " + exact->variant.name() + ".");
    else if (good)
      lines.push_back("No cheaper tier stays on that floor and saves time.");
  } else if (exact) {
    lines.push_back("Float arithmetic with every function rounded correctly makes no error here.");
  }
  if (exact && cheapest && cheapest != exact)
    lines.push_back("From " + exact->variant.name() + " to " + cheapest->variant.name() +
                    " time falls by " + ratio(exact->median / cheapest->median) +
                    " times; the error becomes " + small(cheapest->error.rms) + ", of which " +
                    small(cheapest->tier.rms) + " is due to the functions.");
  else if (exact && cost.functions.empty())
    lines.push_back("It calls no elementary function in which the math tiers differ.");
  if (exact && wide)
    lines.push_back("Double lowers the error to " + small(wide->error.rms) + " and takes " +
                    ratio(wide->median / exact->median) + " times as long as " +
                    exact->variant.name() + ".");
  const Measurement *unseen =
      fastest(cost, [](const Measurement &m) { return m.error.changed8 == 0; });
  if (unseen)
    lines.push_back("The fastest variant that changes no 8-bit pixel value is " +
                    unseen->variant.name() + ", " + ratio(unseen->median) + " ns a point.");
  return lines;
}

void printTable(const ShaderCost &cost, raw_ostream &out) {
  std::vector<size_t> front = paretoFront(cost);
  unsigned widest = 0;
  for (const Measurement &measurement : cost.variants)
    widest = std::max(widest, measurement.variant.width);
  out << cost.shader << ", " << cost.points << " points, truth: " << cost.oracle << '\n';
  out << formatv("  {0,-44} {1,9} {2,10} {3,10} {4,10} {5,9}\n", "", "ns/point", "error RMS",
                 "arithmetic", "functions", "8-bit");
  for (size_t i = 0; i < cost.variants.size(); ++i) {
    const Measurement &m = cost.variants[i];
    bool isFront = is_contained(front, i);
    bool isPlain = m.variant.width == widest && is_contained(tiers(), StringRef(m.variant.math));
    if (!isFront && !isPlain)
      continue;
    // The sign of multiplication is one column wide and two bytes long.
    std::string name = m.variant.name();
    out << (isFront ? "* " : "  ") << name;
    out.indent(name.size() < 45 ? unsigned(45 - name.size()) : 1);
    out << format(" %9.2f %10.3g %10.3g %10.3g %7.2f %%\n", m.median, m.error.rms, m.arithmetic.rms,
                  m.tier.rms, 100 * m.error.changed8);
  }
  out << "  * nothing is both faster and more exact; 8-bit: the share of pixel values that "
         "change\n";
  for (const std::string &line : summary(cost))
    out << "  - " << line << '\n';
}

} // namespace anysl::cost
