//===-- test/hard-cases/Page.cpp - docs/hard-cases.md -----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Page.h"
#include <cstdio>

using namespace hardcases;

namespace {

constexpr const char *introduction = R"(# Inputs that break ordinary shading code

Printed by the test of `test/hard-cases` from its table; `ninja hard-cases-docs` writes this page.

Each line is a kind of input for which the obvious code gives NaN, infinity or nonsense, what the right answer is, and how close to it results
stay. *Obvious code* is measured: a few lines of plain float C++ (`test/hard-cases/Naive.cpp`), compiled with this project's options, run on the same inputs
and judged by the same closed forms in long double (`Judges.h`). *AnySL* is the worst result of the shader in `float` at tier `u10`; "wrong" counts results that are wrong in kind: NaN, the wrong side, outside the
range. The threshold holds for `float`, `double` and both with derivatives, in every math tier, at widths 1, 4, 8 and 16, in every lane, while the other lanes idle with NaN,
infinity, 0, -2³¹ and 1e30 for inputs. Where a line says *no trap*, neither an invalid operation nor a division by zero is raised, also not in idle lanes with finite inputs, in any tier but `fast`. All buffers end at guard pages, and MXCSR is the same before and after each call.

Thresholds in units in the last place are those of the format. Of the others, those near a float's precision are as many such units in double. Where the right answer depends on an elementary function, the
threshold is that of the tier `fast`, 2⁻¹².

| | operation | inputs | obvious code | right answer | AnySL | threshold | where |
|---|---|---|---|---|---|---|---|
)";

std::string figure(const Measured &m, const Bound &bound) {
  if (m.count == 0)
    return "";
  char text[80];
  std::string result;
  if (m.wrong > 0) {
    std::snprintf(text, sizeof text, "%zu of %zu wrong", m.wrong, m.count);
    result = text;
  }
  if (bound.kind != Bound::Exactly && m.wrong < m.count) {
    std::snprintf(text, sizeof text, "%.1Lg%s", m.worst, bound.kind == Bound::Ulps ? " ulp" : "");
    result += (result.empty() ? "" : ", else up to ") + std::string(m.worst == 0 ? "0" : text);
  } else if (bound.kind == Bound::Exactly && m.wrong == 0) {
    result = "right";
  }
  return result;
}

std::string escaped(const std::string &text) {
  std::string result;
  for (char c : text)
    result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

} // namespace

void Page::print() const {
  std::fputs(introduction, stdout);
  for (const Row &row : rows()) {
    std::string naive = row.naive       ? figure(runNaive(row), row.bound)
                        : row.naiveText ? row.naiveText
                                        : "reads outside";
    auto entry = results.find(&row);
    std::string ours = row.test                 ? "holds, `" + std::string(row.test) + "`"
                       : entry == results.end() ? ""
                                                : figure(entry->second, row.bound);
    std::string bound = row.test ? "" : row.bound.text();
    if (row.traps)
      bound += ", no trap";
    std::printf("| %d | %s | %s | %s | %s | %s | %s | %s |\n", row.number,
                escaped(row.operation).c_str(), escaped(row.inputsText).c_str(), naive.c_str(),
                escaped(row.answer).c_str(), ours.c_str(), bound.c_str(), row.where);
  }
}
