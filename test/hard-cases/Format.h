//===-- test/hard-cases/Format.h - float and double as a test sees them -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_FORMAT_H
#define ANYSL_TEST_HARDCASES_FORMAT_H

#include <cmath>
#include <limits>
#include <vector>

namespace hardcases {

/// The number format that a library computes in. Numbers of either travel as double.
struct Format {
  bool isDouble;

  int digits() const { return isDouble ? 53 : 24; }
  /// Half a unit in the last place of 1.
  double eps() const { return std::ldexp(1.0, -digits()); }
  double largest() const {
    return isDouble ? std::numeric_limits<double>::max() : std::numeric_limits<float>::max();
  }
  double smallestNormal() const {
    return isDouble ? std::numeric_limits<double>::min() : std::numeric_limits<float>::min();
  }
  double smallest() const {
    return isDouble ? std::numeric_limits<double>::denorm_min()
                    : std::numeric_limits<float>::denorm_min();
  }
  double round(double x) const { return isDouble ? x : double(float(x)); }
  double after(double x) const {
    double up = std::numeric_limits<double>::infinity();
    return isDouble ? std::nextafter(x, up) : double(std::nextafter(float(x), float(up)));
  }
  double before(double x) const { return -after(-x); }
  /// The distance between the numbers about x.
  long double ulp(long double x) const {
    int exponent;
    std::frexp(x, &exponent);
    int least = isDouble ? -1021 : -125;
    return x == 0 ? smallest() : std::ldexp(1.0L, (exponent < least ? least : exponent) - digits());
  }
};

/// All numbers that one call of a shader takes or gives, in order of declaration.
using Numbers = std::vector<double>;
using Inputs = std::vector<Numbers>;

/// One call of a shader, as it was computed.
struct Example {
  const double *in; ///< rounded to the format
  const double *out;
  Format format;
};

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace hardcases

#endif
