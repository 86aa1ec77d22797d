//===-- tools/anysl-cost/anysl-cost.cpp - what accuracy costs in time -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Emit/Target.h"
#include "lib/Shade/Progress.h"
#include "lib/Support/Output.h"
#include "lib/Support/Tool.h"
#include "tools/anysl-cost/Report.h"
#include "tools/anysl-cost/SceneShaders.h"
#include "tools/anysl-cost/Stability.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/Path.h"

using namespace llvm;
using namespace anysl;
using namespace anysl::cost;

namespace {

cl::OptionCategory category("anysl-cost");

cl::list<std::string> inputs(cl::Positional, cl::ZeroOrMore, cl::desc("FILE.stc.bc..."),
                             cl::cat(category));
cl::opt<std::string> scene("scene",
                           cl::desc("Take the surface and volume shaders of a RIB scene, at the "
                                    "points where they run"),
                           cl::value_desc("FILE.rib"), cl::cat(category));
cl::opt<std::string> output("o",
                            cl::desc("Write report.html, report.json and report.csv there "
                                     "(stability.html and .json with --stability)"),
                            cl::value_desc("FOLDER"), cl::cat(category));
cl::list<std::string> shaders("shader", cl::desc("Only this shader (repeatable; default: all)"),
                              cl::value_desc("NAME"), cl::cat(category));
cl::list<std::string> prints("print",
                             cl::desc("Compare this global or output parameter (repeatable; "
                                      "default: every global that the shader writes)"),
                             cl::value_desc("NAME"), cl::cat(category));
cl::opt<std::string> runtime("runtime",
                             cl::desc("The renderer's runtime (default: packet, and scalar for "
                                      "reals that it does not work with)"),
                             cl::value_desc("NAME"), cl::cat(category));
cl::list<std::string> reals("real", cl::desc("What a float is (default: float,double)"),
                            cl::CommaSeparated, cl::value_desc("NAME,..."), cl::cat(category));
cl::list<unsigned> widths("width", cl::desc("Points at once (default: 1,4,8,16)"),
                          cl::CommaSeparated, cl::value_desc("N,..."), cl::cat(category));
cl::opt<int> rounds("rounds", cl::desc("How often each variant is timed (default: 15)"),
                    cl::init(15), cl::value_desc("N"), cl::cat(category));
cl::opt<std::string> cpu("mcpu", cl::desc("The processor, as LLVM names it (default: native)"),
                         cl::init("native"), cl::value_desc("CPU"), cl::cat(category));
cl::opt<bool> noSites("no-sites",
                      cl::desc("Do not study each call of a function by itself, which takes a "
                               "build for each and tier"),
                      cl::cat(category));
cl::opt<bool>
    stability("stability",
              cl::desc("Search the points, and others about the worst of them, for places "
                       "in the shader where rounding spoils results"),
              cl::cat(category));
cl::opt<double> digits("digits",
                       cl::desc("With --stability: decimal digits that a result may lose "
                                "(default: 3)"),
                       cl::init(3), cl::value_desc("N"), cl::cat(category));
cl::opt<unsigned>
    searchRounds("search-rounds",
                 cl::desc("With --stability: how often to look about the worst points "
                          "(default: 12)"),
                 cl::init(12), cl::value_desc("N"), cl::cat(category));
cl::opt<bool> quiet("quiet", cl::desc("No progress"), cl::cat(category));

/// What grids of points have in common for all programs, with help of its own.
std::vector<std::unique_ptr<cl::list<std::string>>> gridOptions;
cl::extrahelp gridHelp("");

void makeGridOptions() {
  for (const shade::GridOption &option : shade::gridOptions())
    gridOptions.push_back(std::make_unique<cl::list<std::string>>(StringRef(option.name).ltrim('-'),
                                                                  cl::Hidden, cl::cat(category)));
  static const std::string help = std::string("\nPOINTS:\n\n") + shade::gridHelp +
                                  "  --grid=WxH               default: 64x64\n" +
                                  shade::pointsHelp + "\n" + shade::worldHelp;
  gridHelp.morehelp = help;
}

Settings makeSettings() {
  Settings settings;
  auto shared = shade::gridOptions();
  for (size_t i = 0; i < shared.size(); ++i)
    for (const std::string &value : *gridOptions[i])
      shared[i].read(settings.grid, value);
  if (!settings.grid.gridWidth)
    settings.grid.gridWidth = settings.grid.gridHeight = 64;
  settings.grid.print.assign(prints.begin(), prints.end());
  settings.grid.environment.printTo = stderr;
  if (!reals.empty())
    settings.reals.assign(reals.begin(), reals.end());
  if (!widths.empty())
    settings.widths.assign(widths.begin(), widths.end());
  settings.sites = !noSites;
  settings.rounds = std::max(1, int(rounds));
  return settings;
}

/// The shaders of a library that can be run by themselves.
std::vector<std::string> shadersIn(const Build &build) {
  std::vector<std::string> names;
  for (const link::ShaderReport &shader : build.report.shaders)
    if (shader.kind != "method" && !is_contained(names, shader.name))
      names.push_back(shader.name);
  return names;
}

/// Writes files into the output folder, each with its name and text.
void writeReports(DiagnosticEngine &diags, ArrayRef<std::pair<StringRef, std::string>> files) {
  if (output.empty())
    return;
  if (std::error_code error = sys::fs::create_directories(output)) {
    diags.error("cannot make the folder '" + output + "': " + error.message());
    throw Failed();
  }
  for (const auto &[name, text] : files) {
    SmallString<128> path(output);
    sys::path::append(path, name);
    if (!writeFile(diags, path, [&](raw_pwrite_stream &out) {
          out << text;
          return Error::success();
        }))
      throw Failed();
  }
}

/// Whether a shader can be run at the points of a recording; at those of a grid all can.
bool hasPoints(const Settings &settings, StringRef name) {
  const auto &recorded = settings.grid.recorded;
  return scene.empty() || any_of(recorded, [&](auto &part) { return part->name == name; });
}

/// Looks at each wanted shader of each file.
void forEachShader(DiagnosticEngine &diags, TargetMachine &target, const link::LinkOptions &options,
                   ArrayRef<std::string> files, const Settings &settings, const std::string &real,
                   function_ref<void(Builder &builder, const std::string &name,
                                     const std::string &file, shade::Progress &progress)>
                       study) {
  std::vector<std::string> wanted(shaders.begin(), shaders.end()), met;
  for (const std::string &file : files) {
    Builder builder(diags, target, {file}, options);
    for (const std::string &name : shadersIn(builder.build(real, {"cr"}))) {
      if ((!wanted.empty() && !is_contained(wanted, name)) || !hasPoints(settings, name))
        continue;
      met.push_back(name);
      shade::Progress progress(name, quiet);
      study(builder, name, file, progress);
    }
  }
  for (const std::string &name : wanted)
    if (!is_contained(met, name))
      throw shade::UserError("there is no shader '" + name + "' in these files");
}

/// --stability
void searchAll(DiagnosticEngine &diags, TargetMachine &target, link::LinkOptions options,
               ArrayRef<std::string> files, const Settings &settings) {
  StabilitySettings search;
  search.grid = settings.grid;
  search.real = reals.empty() ? "float" : reals.front();
  search.limit = digits;
  search.rounds = searchRounds;
  if (reals.size() > 1 || (search.real != "float" && search.real != "double"))
    throw shade::UserError("--stability looks at one real, float or double");
  if (!(digits > 0))
    throw shade::UserError("--digits: a result may lose more than 0 digits");
  options.widths = {1};
  std::vector<StabilityReport> reports;
  forEachShader(diags, target, options, files, settings, search.real,
                [&](Builder &builder, const std::string &name, const std::string &file,
                    shade::Progress &progress) {
                  reports.push_back(findInstability(builder, name, search,
                                                    [&](double share) { progress.show(share); }));
                  reports.back().file = file;
                  progress.finish();
                  printStability(reports.back(), outs());
                  outs().flush();
                });
  writeReports(diags, {{"stability.html", stabilityToHtml(reports)},
                       {"stability.json", formatv("{0:2}\n", stabilityToJson(reports)).str()}});
}

/// Without it.
void measureAll(DiagnosticEngine &diags, TargetMachine &target, const link::LinkOptions &options,
                ArrayRef<std::string> files, const Settings &settings) {
  cost::Report report;
  report.cpu = target.getTargetCPU().str();
  report.rounds = settings.rounds;
  forEachShader(diags, target, options, files, settings, settings.reals.front(),
                [&](Builder &builder, const std::string &name, const std::string &file,
                    shade::Progress &progress) {
                  Experiment experiment(
                      builder, name, settings,
                      [&](double share, const std::string &) { progress.show(share); });
                  report.shaders.push_back(experiment.run());
                  report.shaders.back().file = file;
                  progress.finish();
                  printTable(report.shaders.back(), outs());
                  outs().flush();
                });
  writeReports(diags, {{"report.html", toHtml(report)},
                       {"report.json", formatv("{0:2}\n", toJson(report)).str()},
                       {"report.csv", toCsv(report)}});
}

void run(DiagnosticEngine &diags, const Tool &tool) {
  auto target = makeTarget(diags, cpu, "");
  if (!target)
    throw Failed();
  link::LinkOptions options;
  options.resourceDir = tool.resourceDir();
  options.runtime = runtime;
  Settings settings = makeSettings();
  options.widths = settings.widths;

  // A copy: lld, when it runs, forgets what the command line said.
  std::vector<std::string> files(inputs.begin(), inputs.end());
  std::optional<SceneShaders> fromScene;
  if (!scene.empty()) {
    fromScene.emplace(tool.programFolder(), scene);
    for (const std::string &library : fromScene->libraries())
      diags.warning(FilePosition(), {"library", true},
                    "'" + library + "' cannot be linked anew; it is left out");
    files.insert(files.end(), fromScene->files().begin(), fromScene->files().end());
    settings.grid.recorded = fromScene->points();
  }
  if (files.empty())
    throw shade::UserError("no shader: give STC files, or a scene with --scene");
  if (stability)
    searchAll(diags, *target, options, files, settings);
  else
    measureAll(diags, *target, options, files, settings);
}

} // namespace

int main(int argc, char **argv) {
  makeGridOptions();
  Tool tool(argc, argv, "anysl-cost",
            "Measures what a shader's accuracy costs in time: every real, math tier and width "
            "against an oracle; or\nsearches for where it loses digits (--stability).\n",
            category);
  DiagnosticEngine diags("anysl-cost");
  try {
    run(diags, tool);
    return success;
  } catch (const Failed &) {
    return userError;
  } catch (const shade::UserError &error) {
    diags.error(error.what());
    return userError;
  }
}
