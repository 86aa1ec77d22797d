//===-- test/hard-cases/Rows.cpp - the table of hard cases as data ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Rows.h"
#include "test/hard-cases/Inputs.h"
#include "test/hard-cases/Kernels.h"
#include <algorithm>
#include <cstdio>

using namespace hardcases;

namespace {

Bound fixed(double limit) { return {Bound::Fixed, limit}; }
Bound scaled(double limit) { return {Bound::Scaled, limit}; }
Bound ulps(double limit) { return {Bound::Ulps, limit}; }
constexpr Bound exactly = {Bound::Exactly, 0};
constexpr bool traps = true, mayRaise = false;

} // namespace

std::string Bound::text() const {
  char number[32];
  std::snprintf(number, sizeof number, "%g", limit);
  switch (kind) {
  case Fixed:
  case Scaled:
    return number;
  case Ulps:
    return std::string(number) + " ulp";
  case Exactly:
    break;
  }
  return "exact";
}

const std::vector<Row> &hardcases::rows() {
  static const std::vector<Row> table = [] {
    std::vector<Row> list = {
#define HARD_CASE(number, shader, operation, inputs, answer, list, judge, bound, naive, traps,     \
                  where)                                                                           \
  {number, #shader, operation,                                                                     \
   inputs, answer,  []([[maybe_unused]] Format f) -> Inputs { return list; },                                   \
   judge,  bound,   naive,                                                                         \
   traps,  where},
#define HARD_KERNEL(number, kernel, operation, inputs, answer, list, judge, bound, naive, where)   \
  {number,   #kernel, operation,                                                                   \
   inputs,   answer,  []([[maybe_unused]] Format f) -> Inputs { return list; },                                 \
   judge,    bound,   naive,                                                                       \
   mayRaise, where,   nullptr,                                                                     \
   nullptr,  kernel},
#define HARD_TEST(number, operation, inputs, answer, naive, where, test)                           \
  {number,  nullptr, operation, inputs, answer, nullptr, nullptr,                                  \
   exactly, nullptr, mayRaise,  where,  test,   naive},
#include "test/hard-cases/Rows.def"
    };
    std::stable_sort(list.begin(), list.end(),
                     [](const Row &a, const Row &b) { return a.number < b.number; });
    return list;
  }();
  return table;
}
