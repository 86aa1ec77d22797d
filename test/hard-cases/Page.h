//===-- test/hard-cases/Page.h - docs/hard-cases.md ---------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_PAGE_H
#define ANYSL_TEST_HARDCASES_PAGE_H

#include "test/hard-cases/Run.h"

namespace hardcases {

/// Collects what rows gave, and prints the table with it.
class Page {
public:
  /// Of several libraries the first counts.
  void note(const Row &row, const Measured &measured) { results.emplace(&row, measured); }
  void print() const;

private:
  std::map<const Row *, Measured> results;
};

} // namespace hardcases

#endif
