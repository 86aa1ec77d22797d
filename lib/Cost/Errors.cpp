//===-- lib/Cost/Errors.cpp - how far results are from others ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Errors.h"
#include "lib/Shade/Timing.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace anysl::cost {

double floatUlp(double value) {
  int exponent = std::numeric_limits<float>::min_exponent;
  if (value != 0 && std::isfinite(value))
    std::frexp(value, &exponent);
  exponent = std::max(exponent, std::numeric_limits<float>::min_exponent);
  return std::ldexp(1.0, exponent - std::numeric_limits<float>::digits);
}

/// A number as a pixel of so many steps.
static int64_t pixel(double value, double steps) {
  // NaN, which no file can hold, becomes 0 as the lower limit does.
  double limited = value > 0 ? std::min(value, 1.0) : 0;
  return int64_t(std::floor(limited * steps + 0.5));
}

ErrorStats compare(const std::vector<shade::Result> &results,
                   const std::vector<shade::Result> &truth) {
  ErrorStats stats;
  std::vector<double> distances;
  double squares = 0, ulpSquares = 0, changed8 = 0, changed16 = 0;
  for (size_t r = 0; r < results.size(); ++r)
    for (size_t i = 0; i < results[r].values.size(); ++i) {
      double value = results[r].values[i], exact = truth[r].values[i];
      ++stats.numbers;
      changed8 += pixel(value, 255) != pixel(exact, 255);
      changed16 += pixel(value, 65535) != pixel(exact, 65535);
      bool same = value == exact || (std::isnan(value) && std::isnan(exact));
      if (!same && !(std::isfinite(value) && std::isfinite(exact))) {
        ++stats.notNumbers;
        stats.max = std::numeric_limits<double>::infinity();
        continue;
      }
      double distance = same ? 0 : std::fabs(value - exact);
      double ulps = distance / floatUlp(exact);
      distances.push_back(distance);
      squares += distance * distance;
      ulpSquares += ulps * ulps;
      stats.max = std::max(stats.max, distance);
      stats.maxUlps = std::max(stats.maxUlps, ulps);
    }
  if (!stats.numbers)
    return stats;
  double count = double(std::max<size_t>(distances.size(), 1));
  stats.rms = std::sqrt(squares / count);
  stats.rmsUlps = std::sqrt(ulpSquares / count);
  stats.p999 = shade::quantile(std::move(distances), 0.999);
  stats.changed8 = changed8 / double(stats.numbers);
  stats.changed16 = changed16 / double(stats.numbers);
  return stats;
}

} // namespace anysl::cost
