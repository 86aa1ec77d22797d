//===-- tools/verify-math/verify-math.cpp - check every tier's bound --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Compares each tier with the truth: functions of one float on all 2^32 of them or on a sample,
// functions of two on as many pairs as asked for, functions of double on a random sample. A run can
// be stopped at any time and goes on where it was. Exit status 1: a bound does not hold.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/verify-math/Inputs.h"
#include "tools/verify-math/Statistics.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/InitLLVM.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/raw_ostream.h"

#include <chrono>
#include <cinttypes>
#include <cstring>
#include <map>
#include <string>
#include <vector>

using namespace anysl::verify;
using namespace llvm;

static cl::OptionCategory Options("verify-math options");
static cl::list<std::string> Functions("function", cl::desc("Only this function (repeatable)"),
                                       cl::value_desc("name"), cl::CommaSeparated,
                                       cl::cat(Options));
static cl::list<std::string> TierNames("tier", cl::desc("Only this tier (repeatable)"),
                                       cl::value_desc("name"), cl::CommaSeparated,
                                       cl::cat(Options));
static cl::opt<std::string> Type("type", cl::desc("float, double or both"), cl::init("both"),
                                 cl::cat(Options));
static cl::opt<uint64_t> Sample("sample", cl::desc("Take one float of so many (1: all 2^32)"),
                                cl::init(4099), cl::cat(Options));
static cl::opt<uint64_t> Pairs("pairs", cl::desc("Pairs for functions of two floats"),
                               cl::init(1000000), cl::cat(Options));
static cl::opt<uint64_t> Doubles("doubles", cl::desc("Arguments for functions of double"),
                                 cl::init(20000), cl::cat(Options));
static cl::opt<std::string> StateFolder("state",
                                        cl::desc("Folder that keeps how far a run has come"),
                                        cl::value_desc("folder"), cl::cat(Options));
static cl::opt<std::string> TableFile("table",
                                      cl::desc("CSV file whose rows are replaced by what is "
                                               "measured, if over no fewer inputs"),
                                      cl::value_desc("file"), cl::cat(Options));
static cl::opt<bool> ListMisrounded("list-misrounded",
                                    cl::desc("Print each argument whose result is not correctly "
                                             "rounded (for tiers that round nearly all correctly)"),
                                    cl::cat(Options));

namespace {

constexpr size_t Block = 1 << 14;
using Found = std::vector<Statistics>; // one a tier

/// The arguments of one check: how many, and which.
struct Plan {
  const Function &function;
  bool isDouble;
  uint64_t count;

  Plan(const Function &f, bool isDouble)
      : function(f), isDouble(isDouble),
        count(isDouble           ? uint64_t(Doubles)
              : f.arguments == 1 ? ((uint64_t(1) << 32) + Sample - 1) / Sample
                                 : uint64_t(Pairs)) {}

  bool all() const { return !isDouble && function.arguments == 1 && Sample == 1; }
  Arguments<float> floats(uint64_t i) const {
    return function.arguments == 1 ? Arguments<float>{floatAt(i * Sample), 0} : pairAt(function, i);
  }
};

/// Shows how far a check is, twice a second on a terminal, else every half minute.
class Progress {
public:
  explicit Progress(const Plan &plan, uint64_t start) : plan(plan), start(start) {}
  void show(uint64_t done, bool force = false) {
    auto now = Clock::now();
    bool terminal = errs().is_displayed();
    auto pause = terminal ? std::chrono::milliseconds(500) : std::chrono::milliseconds(30000);
    if (!force && now - last < pause)
      return;
    last = now;
    double seconds = std::chrono::duration<double>(now - began).count();
    double left = done > start ? seconds / double(done - start) * double(plan.count - done) : 0;
    errs() << (terminal ? "\r" : "") << plan.function.name
           << (plan.isDouble ? " (double)" : " (float)")
           << format(" %5.1f %%, %.0f s left   ", 100.0 * double(done) / double(plan.count), left)
           << (terminal ? "" : "\n");
  }
  void finish() {
    if (errs().is_displayed())
      errs() << "\r                                                  \r";
  }

private:
  using Clock = std::chrono::steady_clock;
  const Plan &plan;
  uint64_t start;
  Clock::time_point began = Clock::now(), last = began;
};

//===-- State of a stopped run ----------------------------------------------//

std::string statePath(const Plan &plan) {
  SmallString<128> path(StateFolder);
  sys::path::append(path, std::string(plan.function.name) + (plan.isDouble ? ".double" : ".float"));
  return std::string(path);
}

void saveState(const Plan &plan, const std::vector<const Tier *> &used, const Found &found,
               uint64_t next) {
  if (StateFolder.empty())
    return;
  std::string path = statePath(plan), temporary = path + ".new";
  if (FILE *file = fopen(temporary.c_str(), "w")) {
    fprintf(file, "%" PRIu64 " %" PRIu64 "\n", next, plan.count);
    for (size_t t = 0; t < used.size(); ++t) {
      const Statistics &s = found[t];
      fprintf(file, "%s %" PRIu64 " %" PRIu64 " %" PRIu64 " %a %a %a %a\n", used[t]->name.data(),
              s.inputs, s.misrounded, s.wrong, s.maxUlp, s.x, s.y, s.maxRelative);
    }
    fclose(file);
    rename(temporary.c_str(), path.c_str());
  }
}

/// The input to go on with: 0 unless the same check of the same tiers was stopped before.
uint64_t loadState(const Plan &plan, const std::vector<const Tier *> &used, Found &found) {
  if (StateFolder.empty())
    return 0;
  FILE *file = fopen(statePath(plan).c_str(), "r");
  if (!file)
    return 0;
  uint64_t next = 0, count = 0;
  bool good = fscanf(file, "%" SCNu64 " %" SCNu64, &next, &count) == 2 && count == plan.count;
  for (size_t t = 0; good && t < used.size(); ++t) {
    char name[32];
    Statistics &s = found[t];
    good = fscanf(file, "%31s %" SCNu64 " %" SCNu64 " %" SCNu64 " %la %la %la %la", name, &s.inputs,
                  &s.misrounded, &s.wrong, &s.maxUlp, &s.x, &s.y, &s.maxRelative) == 8 &&
           used[t]->name == name;
  }
  fclose(file);
  if (!good)
    found.assign(used.size(), {});
  return good ? next : 0;
}

//===-- Checking ------------------------------------------------------------//

/// Whether this processor runs the tiers' second compilation, the one with fused multiply-adds.
const bool hasFused = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");

bool sameBits(float a, float b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

void checkFloats(const Plan &plan, const std::vector<const Tier *> &used, size_t index,
                 uint64_t first, uint64_t last, Found &found) {
  static std::vector<float> x(Block), y(Block), result(Block), fused(Block);
  static std::vector<Truth> truth(Block);
  size_t n = last - first;
  for (size_t i = 0; i < n; ++i) {
    auto a = plan.floats(first + i);
    x[i] = a.x;
    y[i] = a.y;
    truth[i] = truthOf(plan.function, a.x, a.y);
  }
  for (size_t t = 0; t < used.size(); ++t) {
    used[t]->batches[index].ofFloats(x.data(), y.data(), result.data(), n);
    if (hasFused)
      used[t]->fused[index].ofFloats(x.data(), y.data(), fused.data(), n);
    for (size_t i = 0; i < n; ++i) {
      uint64_t before = found[t].misrounded;
      found[t].add(truth[i], result[i], x[i], y[i]);
      found[t].wrong += hasFused && !sameBits(result[i], fused[i]);
      if (ListMisrounded && found[t].misrounded != before)
        outs() << format("%s %s %a %a: %a, not %a\n", used[t]->name.data(),
                         plan.function.name.data(), x[i], y[i], result[i], truth[i].rounded);
    }
  }
}

void checkDoubles(const Plan &plan, const std::vector<const Tier *> &used, size_t index,
                  uint64_t first, uint64_t last, Found &found) {
  static std::vector<double> x(Block), y(Block), result(Block);
  size_t n = last - first;
  for (size_t i = 0; i < n; ++i) {
    auto a = doublesAt(plan.function, first + i);
    x[i] = a.x;
    y[i] = a.y;
  }
  for (size_t t = 0; t < used.size(); ++t) {
    used[t]->batches[index].ofDoubles(x.data(), y.data(), result.data(), n);
    for (size_t i = 0; i < n; ++i)
      found[t].addDouble(plan.function, x[i], y[i], result[i]);
  }
}

Found check(const Plan &plan, const std::vector<const Tier *> &used) {
  Found found(used.size());
  size_t index = &plan.function - functions().data();
  uint64_t next = loadState(plan, used, found);
  Progress progress(plan, next);
  for (uint64_t blocks = 0; next < plan.count; ++blocks) {
    uint64_t last = std::min<uint64_t>(next + Block, plan.count);
    (plan.isDouble ? checkDoubles : checkFloats)(plan, used, index, next, last, found);
    next = last;
    if (blocks % 256 == 255 || next == plan.count)
      saveState(plan, used, found, next);
    progress.show(next);
  }
  progress.finish();
  return found;
}

//===-- Results -------------------------------------------------------------//

constexpr const char *Header =
    "function,type,tier,bound,domain,inputs,max error in ULP,at x,at y,share not correctly rounded,"
    "max relative error";

std::string key(const Plan &plan, const Tier &tier) {
  return formatv("{0},{1},{2}", std::string(plan.function.name), plan.isDouble ? "double" : "float",
                 std::string(tier.name));
}

std::string row(const Plan &plan, const Tier &tier, const Statistics &s) {
  const Function &f = plan.function;
  double bound = plan.isDouble ? tier.boundForDouble : tier.bound;
  const char *domain = plan.all()         ? "all floats"
                       : plan.isDouble    ? "structured and random"
                       : f.arguments == 2 ? "structured and random pairs"
                                          : "a sample of all floats";
  std::string text;
  raw_string_ostream out(text);
  out << key(plan, tier) << ',';
  if (bound > 0)
    out << format("%.4g ULP", bound);
  else
    out << "2^-" << f.fastBits;
  out << ',' << domain << ',' << s.inputs << format(",%.5f,%a,", s.maxUlp, s.x);
  if (f.arguments == 2)
    out << format("%a", s.y);
  out << format(",%.3g,", double(s.misrounded) / double(s.inputs));
  if (s.maxRelative > 0)
    out << format("2^%.1f", std::log2(s.maxRelative));
  return text;
}

/// The rows of the CSV file by their first three fields; none if there is no such file.
std::map<std::string, std::string> readTable(const std::string &path) {
  std::map<std::string, std::string> rows;
  auto buffer = MemoryBuffer::getFile(path);
  if (!buffer)
    return rows;
  SmallVector<StringRef> lines;
  (*buffer)->getBuffer().split(lines, '\n', -1, false);
  for (StringRef line : ArrayRef(lines).drop_front(lines.empty() ? 0 : 1)) {
    SmallVector<StringRef> fields;
    line.split(fields, ',');
    if (fields.size() > 5)
      rows[(fields[0] + "," + fields[1] + "," + fields[2]).str()] = line.str();
  }
  return rows;
}

uint64_t inputsOf(StringRef row) {
  SmallVector<StringRef> fields;
  row.split(fields, ',');
  uint64_t inputs = 0;
  return fields.size() > 5 && !fields[5].getAsInteger(10, inputs) ? inputs : 0;
}

/// Writes the table in the order of the functions and tiers.
bool writeTable(const std::string &path, const std::map<std::string, std::string> &rows) {
  std::error_code error;
  raw_fd_ostream out(path, error);
  if (error) {
    errs() << "verify-math: " << path << ": " << error.message() << '\n';
    return false;
  }
  out << Header << '\n';
  for (const Function &f : functions())
    for (bool isDouble : {false, true})
      for (const Tier &tier : tiers())
        if (auto found = rows.find(key(Plan(f, isDouble), tier)); found != rows.end())
          out << found->second << '\n';
  return true;
}

/// The entries named, or all where none is; exits on a name that does not exist.
template <class T>
std::vector<const T *> chosen(const cl::list<std::string> &names, std::span<const T> all,
                              const T *(*find)(std::string_view), const char *kind) {
  std::vector<const T *> result;
  for (const std::string &name : names) {
    if (!find(name)) {
      errs() << "verify-math: there is no " << kind << " '" << name << "'\n";
      exit(1);
    }
    result.push_back(find(name));
  }
  if (names.empty())
    for (const T &entry : all)
      result.push_back(&entry);
  return result;
}

} // namespace

int main(int argc, char **argv) {
  InitLLVM init(argc, argv);
  cl::HideUnrelatedOptions(Options);
  cl::ParseCommandLineOptions(argc, argv, "Checks the bounds of the math tiers\n");
  if (Sample == 0 || (Type != "float" && Type != "double" && Type != "both")) {
    errs() << "verify-math: --sample wants a number above 0, --type one of float, double, both\n";
    return 1;
  }
  auto used = chosen<Tier>(TierNames, tiers(), findTier, "tier");
  auto checked = chosen<Function>(Functions, functions(), findFunction, "function");
  if (!StateFolder.empty())
    if (std::error_code error = sys::fs::create_directories(StateFolder)) {
      errs() << "verify-math: " << StateFolder << ": " << error.message() << '\n';
      return 1;
    }

  bool allHold = true;
  outs() << Header << '\n';
  for (const Function *f : checked)
    for (bool isDouble : {false, true}) {
      if (Type == (isDouble ? "float" : "double"))
        continue;
      Plan plan(*f, isDouble);
      Found found = check(plan, used);
      auto rows = readTable(TableFile);
      for (size_t t = 0; t < used.size(); ++t) {
        std::string line = row(plan, *used[t], found[t]);
        outs() << line << '\n';
        if (!found[t].holds(*used[t], *f, isDouble)) {
          allHold = false;
          errs() << "verify-math: the bound of " << key(plan, *used[t]) << " does not hold ("
                 << found[t].wrong
                 << " wrong special values or differences between instruction sets)\n";
        }
        std::string &old = rows[key(plan, *used[t])];
        if (inputsOf(old) <= found[t].inputs)
          old = line;
      }
      outs().flush();
      if (!TableFile.empty() && !writeTable(TableFile, rows))
        return 1;
    }
  return allHold ? 0 : 1;
}
