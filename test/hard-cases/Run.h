//===-- test/hard-cases/Run.h - running a row in a library --------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_RUN_H
#define ANYSL_TEST_HARDCASES_RUN_H

#include "test/hard-cases/Rows.h"
#include "test/hard-cases/Subject.h"
#include <map>

namespace hardcases {

/// What a list of inputs gave.
struct Measured {
  size_t count = 0;
  size_t wrong = 0;      ///< infinite errors: NaN, the wrong side, outside the range
  long double worst = 0; ///< of the others
  size_t beyond = 0;     ///< how many are beyond the bound, `wrong` included
  Numbers first;         ///< the first of these
  void add(const Numbers &in, long double error, double limit);
};

/// Complaints, at most a few for each row.
using Complaints = std::vector<std::string>;

/// The results of examples by shader, for comparison between libraries.
using Results = std::map<std::string, std::vector<Numbers>>;

/// Runs a row's shader at every width the library has: alone, beside other examples, and in every
/// lane while the others idle with poison for inputs; all have to give the same bits.
Measured runRow(const Row &row, Subject &subject, const std::vector<uint32_t> &widths,
                Results &results, Complaints &complaints);

/// The row's kernel on its inputs.
Measured runKernel(const Row &row);

/// The row's naive code on the same inputs.
Measured runNaive(const Row &row);

std::string describe(const Numbers &numbers);

} // namespace hardcases

#endif
