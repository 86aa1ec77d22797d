//===-- test/hard-cases/Sweeps.cpp - what holds of each built-in function ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
//   sweep-builtins --write FILE.sl     a shader for each built-in function that takes and gives
//   numbers sweep-builtins LIBRARY.so…         runs them on random and structured operands
//
// The shaders are made from frontends/rsl/Builtins.def, so that a new built-in is swept, or has to
// be excluded in Sweeps.def with a reason. Operands are every exponent of the format with
// neighbours, the breakpoints of shading functions with theirs, and random mixtures of both, the
// same in every run.
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Inputs.h"
#include "test/hard-cases/Run.h"
#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstring>
#include <random>
#include <set>

using namespace hardcases;

namespace {

//===-- The built-ins -------------------------------------------------------------------------===//

struct Operand {
  std::string type;
  bool isIn, isOut;
};

struct Builtin {
  std::string shader, name, op, result;
  std::vector<Operand> operands;
  bool isOfNumbers;
};

int componentsOf(const std::string &type) {
  return type == "float" ? 1 : type == "matrix" ? 16 : 3;
}

/// One line of Builtins.def. Operands that the caller does not write are left out.
Builtin parse(int number, const char *result, const char *name, const std::string &list,
              const char *op) {
  static const std::set<std::string> types = {"float",  "color",  "point",
                                              "vector", "normal", "matrix"};
  Builtin builtin{"sweep_" + std::to_string(number) + "_" + name, name, op, result, {}, true};
  for (size_t begin = 1; begin < list.size();) {
    size_t end = std::min(list.find(',', begin), list.size() - 1);
    std::string word = list.substr(begin, end - begin);
    begin = end + 1;
    word.erase(0, word.find_first_not_of(' '));
    if (word.empty() || word[0] == '=') {
      builtin.isOfNumbers &= word != "=light";
      continue;
    }
    bool isOut = word.rfind("out ", 0) == 0, isBoth = word.rfind("inout ", 0) == 0;
    std::string type = isOut ? word.substr(4) : isBoth ? word.substr(6) : word;
    builtin.isOfNumbers &= types.count(type) > 0;
    builtin.operands.push_back({type, !isOut, isOut || isBoth});
  }
  builtin.isOfNumbers &= types.count(result) > 0 || std::strcmp(result, "void") == 0;
  return builtin;
}

std::vector<Builtin> allBuiltins() {
  std::vector<Builtin> list;
#define RSL_BUILTIN(result, name, operands, op, meaning)                                           \
  list.push_back(parse(int(list.size()), #result, #name, #operands, #op));
#include "frontends/rsl/Builtins.def"
  return list;
}

//===-- The table -----------------------------------------------------------------------------===//

using Condition = bool (*)(const double *in, const double *out, Format f, bool isCoarse);

bool within(double x, double low, double high) { return x >= low && x <= high; }
bool allWithin(const double *x, int count, double low, double high) {
  return std::all_of(x, x + count, [&](double c) { return within(c, low, high); });
}
bool isZero(const double *v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }
long double lengthOf(const double *v) {
  return std::sqrt(static_cast<long double>(v[0]) * v[0] + v[1] * v[1] + v[2] * v[2]);
}
long double distanceOf(const double *a, const double *b) {
  double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return lengthOf(d);
}
bool obeysSnell(const double *in, const double *out, Format f) {
  const double *I = in, *N = in + 3;
  long double eta = in[6], along = 0, outAlong = 0, error = 0;
  for (int k = 0; k < 3; ++k)
    along += static_cast<long double>(I[k]) * N[k],
        outAlong += static_cast<long double>(out[k]) * N[k];
  for (int k = 0; k < 3; ++k)
    error = std::max(error, std::fabs((out[k] - outAlong * N[k]) - eta * (I[k] - along * N[k])));
  return error <= 16 * f.eps() * std::max(1.0L, eta) &&
         std::fabs(lengthOf(out) - 1) <= 32 * f.eps() * std::max(1.0L, eta * eta);
}

#define eachOf3(expression)                                                                        \
  [&] {                                                                                            \
    for (int k = 0; k < 3; ++k)                                                                    \
      if (!(out[k] == (expression)))                                                               \
        return false;                                                                              \
    return true;                                                                                   \
  }()

struct Property {
  const char *op, *meaning;
  bool unitOnly;
  Condition holds;
};
const Property properties[] = {
#define SWEEP_CONDITION(...)                                                                       \
  [](const double *in, const double *out, Format f, bool isCoarse) -> bool {                       \
    (void)in, (void)out, (void)f, (void)isCoarse;                                                  \
    return __VA_ARGS__;                                                                            \
  }
#define SWEEP_PROPERTY(op, meaning, ...) {#op, meaning, false, SWEEP_CONDITION(__VA_ARGS__)},
#define SWEEP_UNIT(op, meaning, ...) {#op, meaning, true, SWEEP_CONDITION(__VA_ARGS__)},
#include "test/hard-cases/Sweeps.def"
};

struct Rise {
  const char *op;
  size_t argument;
  double units;
};
const Rise rises[] = {
#define SWEEP_RISES(op, argument, units) {#op, argument, units},
#include "test/hard-cases/Sweeps.def"
};

struct Limit {
  const char *op;
  double magnitude;
};
const Limit limits[] = {
#define SWEEP_LIMIT(op, magnitude, reason) {#op, magnitude},
#include "test/hard-cases/Sweeps.def"
};

const char *const overflowing[] = {
#define SWEEP_OVERFLOWS(op, reason) #op,
#include "test/hard-cases/Sweeps.def"
};

const char *const excluded[] = {
#define SWEEP_EXCLUDED(op, reason) #op,
#include "test/hard-cases/Sweeps.def"
};

template <size_t count>
bool isAmong(const char *const (&ops)[count], const Builtin &builtin) {
  return std::any_of(std::begin(ops), std::end(ops),
                     [&](const char *op) { return builtin.op == op; });
}
bool isExcluded(const Builtin &builtin) { return isAmong(excluded, builtin); }
bool isSwept(const Builtin &builtin) {
  return builtin.isOfNumbers && !builtin.operands.empty() && !isExcluded(builtin);
}

//===-- Shaders -------------------------------------------------------------------------------===//

void write(std::FILE *file, const Builtin &b) {
  std::string inputs, outputs, locals, call, results;
  for (size_t i = 0; i < b.operands.size(); ++i) {
    const Operand &o = b.operands[i];
    std::string n = std::to_string(i), zero = o.type == "matrix" ? "1" : "0";
    if (o.isIn)
      inputs += " varying " + o.type + " a" + n + " = " + zero + ";";
    locals += "    " + o.type + " l" + n + " = " + (o.isIn ? "a" + n : zero) + ";\n";
    call += (i ? ", l" : "l") + n;
    if (o.isOut) {
      outputs += " output varying " + o.type + " o" + n + " = " + zero + ";";
      results += "    o" + n + " = l" + n + ";\n";
    }
  }
  bool isVoid = b.result == "void";
  if (!isVoid)
    outputs =
        " output varying " + b.result + " r = " + (b.result == "matrix" ? "1;" : "0;") + outputs;
  std::fprintf(file,
               "surface %s(varying float active = 1;%s%s) {\n  if (active > 0.5) {\n%s    "
               "%s%s(%s);\n%s  }\n}\n\n",
               b.shader.c_str(), inputs.c_str(), outputs.c_str(), locals.c_str(),
               isVoid ? "" : "r = ", b.name.c_str(), call.c_str(), results.c_str());
}

//===-- Operands ------------------------------------------------------------------------------===//

class Operands {
public:
  Operands(const Builtin &builtin, Format f)
      : builtin(builtin), f(f), generator(builtin.op.size() + 17 * builtin.operands.size()) {
    for (const Limit &limit : limits)
      if (builtin.op == limit.op)
        most = limit.magnitude;
    for (const Operand &o : builtin.operands)
      count += o.isIn ? size_t(componentsOf(o.type)) : 0;
    for (double x : {0.0, -0.0, 0.5, 1.0, 2.0, 3.0, 1.5707963267948966, 3.141592653589793, 1e-30,
                     1e9, 4294967296.0})
      for (double y : {x, f.after(f.round(x)), f.before(f.round(x))})
        breakpoints.push_back(y), breakpoints.push_back(-y);
    for (const Numbers &n : allExponents(f))
      exponents.push_back(n[0]);
  }

  Inputs any() {
    Inputs result;
    if (count == 1)
      for (double x : exponents)
        result.push_back({bounded(x)});
    for (int i = 0; i < 1500; ++i) {
      Numbers n(count);
      for (size_t k = 0; k < count; ++k)
        n[k] = k > 0 && chance(0.15) ? n[k - 1] : number();
      result.push_back(n);
    }
    return result;
  }

  /// Vectors of unit length, numbers between 0.01 and 100.
  Inputs unit() {
    Inputs result;
    std::normal_distribution<double> component;
    for (int i = 0; i < 800; ++i) {
      Numbers n;
      for (const Operand &o : builtin.operands) {
        if (!o.isIn)
          continue;
        Numbers v(size_t(componentsOf(o.type)));
        double square = 0;
        for (double &c : v)
          c = component(generator), square += c * c;
        for (double &c : v)
          c = v.size() == 1 ? std::pow(10, std::uniform_real_distribution<double>(-2, 2)(generator))
                            : c / std::sqrt(square);
        n.insert(n.end(), v.begin(), v.end());
      }
      result.push_back(n);
    }
    return result;
  }

  /// All operands but one fixed, and that one rising.
  std::vector<Inputs> rising(size_t argument) {
    std::vector<Inputs> result;
    for (int i = 0; i < 12; ++i) {
      Numbers fixed(count), values = breakpoints;
      for (double &x : fixed)
        x = number();
      for (int k = 0; k < 150; ++k)
        values.push_back(number());
      for (double &x : values)
        x = bounded(f.round(x));
      std::sort(values.begin(), values.end());
      Inputs series;
      for (double x : values) {
        series.push_back(fixed);
        series.back()[argument] = x;
      }
      result.push_back(series);
    }
    return result;
  }

private:
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(generator) < p; }
  double bounded(double x) const { return std::clamp(x, -most, most); }
  double number() {
    const auto &list = chance(0.4) ? breakpoints : exponents;
    if (chance(0.6))
      return bounded(list[generator() % list.size()]);
    return std::uniform_real_distribution<double>(-4, 4)(generator);
  }

  const Builtin &builtin;
  Format f;
  std::mt19937 generator;
  double most = infinite;
  size_t count = 0;
  std::vector<double> breakpoints, exponents;
};

//===-- Sweeping ------------------------------------------------------------------------------===//

int failures = 0;

class Sweep {
public:
  Sweep(AnyslLibrary *library, const Builtin &builtin, const char *path)
      : builtin(builtin), path(path), subject(library, builtin.shader) {
    const AnyslShaderInfo *shader = anysl_library_shader(library, builtin.shader.c_str());
    for (uint32_t i = 0; i < shader->entry_count; ++i)
      widths.push_back(shader->entries[i].width);
    isCoarse = std::strcmp(anysl_library_info(library)->math, "fast") == 0;
  }

  void run() {
    Format f = subject.format();
    Operands operands(builtin, f);
    check(operands.any(), false);
    check(operands.unit(), true);
    for (const Rise &rise : rises)
      if (builtin.op == rise.op)
        for (const Inputs &series : operands.rising(rise.argument))
          checkRise(series, isCoarse ? 0x1p-12 : 2 * rise.units * f.eps());
  }

private:
  void report(const Numbers &in, const std::string &what) {
    ++failures;
    if (told++ < 4)
      std::fprintf(stderr, "sweep-builtins: %s: %s of%s: %s\n", path, builtin.shader.c_str(),
                   describe(in).c_str(), what.c_str());
  }

  Numbers call(const Numbers &in) {
    subject.set(0, true, in);
    std::string trouble = subject.shade(1, 0, 1, false);
    if (!trouble.empty())
      report(in, trouble);
    Numbers out;
    subject.get(0, out);
    return out;
  }

  Numbers rounded(Numbers in) const {
    for (double &x : in)
      x = subject.format().round(x);
    return in;
  }

  void check(const Inputs &list, bool isUnit) {
    std::vector<Numbers> inputs, expected;
    for (const Numbers &given : list) {
      Numbers in = rounded(given), out = call(in);
      inputs.push_back(in), expected.push_back(out);
      for (double x : out)
        if (isAmong(overflowing, builtin) ? std::isnan(x) : !std::isfinite(x)) {
          report(in, "gives" + describe(out) + " from finite operands");
          break;
        }
      for (const Property &p : properties)
        if (builtin.op == p.op && (isUnit || !p.unitOnly) &&
            !p.holds(in.data(), out.data(), subject.format(), isCoarse))
          report(in, "gives" + describe(out) + ", not " + p.meaning);
    }
    for (uint32_t width : widths)
      for (size_t first = 0; width > 1 && first < inputs.size(); first += width) {
        for (uint32_t p = 0; p < width; ++p)
          subject.set(p, true, inputs[(first + p) % inputs.size()]);
        subject.shade(width, 0, width, false);
        for (uint32_t p = 0; p < width; ++p) {
          size_t i = (first + p) % inputs.size();
          Numbers out;
          subject.get(p, out);
          for (size_t k = 0; k < out.size(); ++k)
            if (std::bit_cast<uint64_t>(out[k]) != std::bit_cast<uint64_t>(expected[i][k]) &&
                !(std::isnan(out[k]) && std::isnan(expected[i][k])))
              report(inputs[i], "gives" + describe(out) + " at width " + std::to_string(width) +
                                    ", but alone" + describe(expected[i]));
        }
      }
  }

  void checkRise(const Inputs &series, double tolerance) {
    double before = -infinite;
    for (const Numbers &given : series) {
      Numbers in = rounded(given);
      double out = call(in)[0];
      if (out < before - tolerance * std::fabs(before))
        report(in, "falls to " + describe({out}) + " from" + describe({before}));
      before = std::max(before, out);
    }
  }

  const Builtin &builtin;
  const char *path;
  Subject subject;
  std::vector<uint32_t> widths;
  bool isCoarse;
  int told = 0;
};

/// Every operator of the table is swept or excluded, and every name in Sweeps.def is an operator's.
void checkCoverage(const std::vector<Builtin> &builtins) {
  std::set<std::string> known, swept;
  for (const Builtin &b : builtins) {
    known.insert(b.op);
    if (isSwept(b))
      swept.insert(b.op);
  }
  auto complain = [](const std::string &op, const char *what) {
    ++failures;
    std::fprintf(stderr, "sweep-builtins: %s %s\n", op.c_str(), what);
  };
  for (const Builtin &b : builtins)
    if (!swept.count(b.op) && !isExcluded(b))
      complain(b.op, "is neither swept nor excluded");
  for (const char *op : excluded)
    if (!known.count(op))
      complain(op, "is excluded, but is no built-in's operator");
  auto needsSweep = [&](const char *op) {
    if (!swept.count(op))
      complain(op, "has a line in Sweeps.def, but is not swept");
  };
  for (const Property &p : properties)
    needsSweep(p.op);
  for (const Rise &r : rises)
    needsSweep(r.op);
  for (const Limit &l : limits)
    needsSweep(l.op);
}

} // namespace

int main(int argc, char **argv) {
  std::vector<Builtin> builtins = allBuiltins();
  checkCoverage(builtins);
  if (argc == 3 && std::strcmp(argv[1], "--write") == 0) {
    std::FILE *file = std::fopen(argv[2], "w");
    if (!file)
      return std::perror(argv[2]), 1;
    for (const Builtin &b : builtins)
      if (isSwept(b))
        write(file, b);
    return std::fclose(file) != 0 || failures > 0;
  }
  size_t count = 0;
  for (int i = 1; i < argc; ++i) {
    AnyslLibrary *library;
    if (anysl_library_open(argv[i], 0, &library) != ANYSL_OK)
      return std::fprintf(stderr, "sweep-builtins: %s\n", anysl_last_error()), 1;
    for (const Builtin &b : builtins)
      if (isSwept(b)) {
        Sweep(library, b, argv[i]).run();
        ++count;
      }
    anysl_library_close(library);
  }
  if (failures == 0)
    std::printf("%zu sweeps hold\n", count);
  return failures > 0;
}
