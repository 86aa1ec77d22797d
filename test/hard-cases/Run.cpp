//===-- test/hard-cases/Run.cpp - running a row in a library ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Run.h"
#include <algorithm>
#include <bit>
#include <cfloat>
#include <cstdio>

using namespace hardcases;

namespace {

/// What the inputs of idle lanes are. The finite ones raise no flag where a row promises so.
constexpr double finitePoison[] = {0, -2147483648.0, 1e15, -1e-40};
constexpr double anyPoison[] = {notANumber, infinite, 0, -2147483648.0, 1e30};

Numbers rounded(const Numbers &numbers, Format f) {
  Numbers result = numbers;
  for (double &x : result)
    x = f.round(x);
  return result;
}

/// NaNs have any payload.
bool isSame(const Numbers &a, const Numbers &b) {
  for (size_t i = 0; i < a.size(); ++i)
    if (std::bit_cast<uint64_t>(a[i]) != std::bit_cast<uint64_t>(b[i]) &&
        !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return true;
}

class RowRun {
public:
  RowRun(const Row &row, Subject &subject, Complaints &complaints)
      : row(row), subject(subject), complaints(complaints) {}

  void alone();
  void together(uint32_t width);
  void besidePoison(uint32_t width);

  std::vector<Numbers> inputs, expected;

private:
  /// Whether an example may be shaded with traps on: its own inputs are finite.
  bool trapsFor(const Numbers &in) const {
    return row.traps && subject.keepsFlags() &&
           std::all_of(in.begin(), in.end(), [](double x) { return std::isfinite(x); });
  }
  void complain(uint32_t width, size_t example, const std::string &what) {
    if (told++ < 3)
      complaints.push_back(std::string(row.shader) + ", width " + std::to_string(width) +
                           ", inputs" + describe(inputs[example]) + ": " + what);
  }
  void compare(uint32_t width, uint32_t point, size_t example, const char *where) {
    Numbers out;
    subject.get(point, out);
    if (!isSame(out, expected[example]))
      complain(width, example,
               std::string("gives") + describe(out) + " " + where + ", but alone" +
                   describe(expected[example]));
  }

  const Row &row;
  Subject &subject;
  Complaints &complaints;
  int told = 0;
};

void RowRun::alone() {
  for (size_t i = 0; i < inputs.size(); ++i) {
    subject.clearOutputs();
    subject.set(0, true, inputs[i]);
    std::string trouble = subject.shade(1, 0, 1, trapsFor(inputs[i]));
    if (!trouble.empty())
      complain(1, i, trouble);
    Numbers out;
    subject.get(0, out);
    expected.push_back(out);
  }
}

void RowRun::together(uint32_t width) {
  // Two groups at once, starting from every third example.
  for (size_t first = 0; first < inputs.size(); first += 3) {
    subject.clearOutputs();
    bool traps = true;
    for (uint32_t p = 0; p < 2 * width && p < Subject::capacity; ++p) {
      const Numbers &in = inputs[(first + p) % inputs.size()];
      traps &= trapsFor(in);
      subject.set(p, true, in);
    }
    uint32_t count = std::min(2 * width, Subject::capacity);
    std::string trouble = subject.shade(width, 0, count, traps);
    if (!trouble.empty())
      complain(width, first, trouble);
    for (uint32_t p = 0; p < count; ++p)
      compare(width, p, (first + p) % inputs.size(), "beside other points");
  }
}

void RowRun::besidePoison(uint32_t width) {
  // The behaviour of a lane does not depend on the example as it does on the poison: of long lists
  // some will do.
  size_t step = std::max<size_t>(1, inputs.size() / 24);
  for (size_t i = 0; i < inputs.size(); i += step) {
    bool traps = trapsFor(inputs[i]);
    auto run = [&](double poison) {
      Numbers filled(subject.inputs(), poison);
      for (uint32_t lane = 0; lane < width; ++lane) {
        subject.clearOutputs();
        for (uint32_t p = 0; p < Subject::capacity; ++p)
          subject.set(p, p >= lane + 1,
                      filled); // idle up to the lane; behind `last` points do not exist
        subject.set(lane, true, inputs[i]);
        // In turn to the group's end, where all other lanes idle, and to the lane, with the rest
        // cut off.
        bool isWhole = (lane + i) % 2 == 0;
        for (uint32_t p = lane + 1; isWhole && p < width; ++p)
          subject.set(p, false, filled);
        std::string trouble = subject.shade(width, 0, isWhole ? width : lane + 1, traps);
        if (!trouble.empty())
          complain(width, i,
                   trouble + " in lane " + std::to_string(lane) + " beside idle lanes of" +
                       describe({poison}));
        compare(width, lane, i, "beside idle lanes");
      }
    };
    if (traps)
      std::for_each(std::begin(finitePoison), std::end(finitePoison), run);
    traps = false;
    std::for_each(std::begin(anyPoison), std::end(anyPoison), run);
  }
}

} // namespace

std::string hardcases::describe(const Numbers &numbers) {
  std::string text;
  for (double x : numbers) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, " %.9g", x);
    text += buffer;
  }
  return text;
}

void Measured::add(const Numbers &in, long double error, double limit) {
  ++count;
  if (std::isfinite(error))
    worst = std::max(worst, error);
  else
    ++wrong;
  if (error <= limit)
    return;
  if (beyond++ == 0)
    first = in;
}

Measured hardcases::runRow(const Row &row, Subject &subject, const std::vector<uint32_t> &widths,
                           Results &results, Complaints &complaints) {
  Format format = subject.format();
  RowRun run(row, subject, complaints);
  for (const Numbers &in : row.inputs(format)) {
    if (in.size() != subject.inputs()) {
      complaints.push_back(std::string(row.shader) + " takes " + std::to_string(subject.inputs()) +
                           " numbers, not " + std::to_string(in.size()));
      return {};
    }
    run.inputs.push_back(rounded(in, format));
  }
  run.alone();
  for (uint32_t width : widths)
    if (width > 1) {
      run.together(width);
      run.besidePoison(width);
    }

  Measured measured;
  for (size_t i = 0; i < run.inputs.size(); ++i) {
    Numbers in = run.inputs[i], out = run.expected[i];
    in.resize(32), out.resize(32); // judges read as much as they need
    long double error = row.judge({in.data(), out.data(), format});
    measured.add(run.inputs[i], error, row.bound.in(format));
  }
  std::vector<Numbers> &before = results[row.shader + std::string(row.operation)];
  if (before.empty())
    before = run.expected;
  for (size_t i = 0; i < before.size(); ++i)
    if (!isSame(before[i], run.expected[i])) {
      complaints.push_back(std::string(row.shader) + ", inputs" + describe(run.inputs[i]) +
                           ": gives" + describe(run.expected[i]) + ", but in the first library" +
                           describe(before[i]));
      break;
    }
  return measured;
}

Measured hardcases::runKernel(const Row &row) {
  Measured measured;
  for (const Numbers &given : row.inputs({false})) {
    Numbers in = rounded(given, {false}), out(32);
    in.resize(32);
    row.kernel(in.data(), out.data());
    measured.add(given, row.judge({in.data(), out.data(), {false}}), row.bound.limit);
  }
  return measured;
}

Measured hardcases::runNaive(const Row &row) {
  Measured measured;
  for (const Numbers &given : row.inputs({false})) {
    Numbers in(32), out(32);
    float single[32] = {}, result[32] = {};
    for (size_t i = 0; i < given.size(); ++i)
      in[i] = single[i] = float(given[i]);
    row.naive(single, result);
    std::copy_n(result, 32, out.begin());
    measured.add(given, row.judge({in.data(), out.data(), {false}}), row.bound.limit);
  }
  return measured;
}
