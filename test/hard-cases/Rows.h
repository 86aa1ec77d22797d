//===-- test/hard-cases/Rows.h - the table of hard cases as data --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_ROWS_H
#define ANYSL_TEST_HARDCASES_ROWS_H

#include "test/hard-cases/Judges.h"
#include "test/hard-cases/Naive.h"
#include <string>

namespace hardcases {

/// How far off a result may be, in the unit of its judge.
struct Bound {
  enum Kind { Fixed, Scaled, Ulps, Exactly } kind;
  double limit;
  double in(Format f) const { return kind == Scaled ? limit * f.eps() * 0x1p24 : limit; }
  std::string text() const;
};

using Kernel = void (*)(const double *in, double *out);

struct Row {
  int number;
  const char *shader;
  const char *operation, *inputsText, *answer;
  Inputs (*inputs)(Format);
  Judge judge;
  Bound bound;
  Naive naive;
  bool traps;
  const char *where;
  const char *test =
      nullptr; ///< of HARD_TEST: where it is proved, and `naiveText` in place of a figure
  const char *naiveText = nullptr;
  Kernel kernel = nullptr;
};

const std::vector<Row> &rows();

} // namespace hardcases

#endif
