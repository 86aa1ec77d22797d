//===-- tools/anysl-render/EffectsReport.cpp - what a scene calls for, and what it costs ------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/EffectsReport.h"

#include "lib/Demand/Demand.h"
#include "lib/Plot/Plot.h"
#include "lib/Shade/Progress.h"
#include "lib/Shade/Timing.h"
#include "tools/anysl-render/Render.h"
#include "tools/anysl-render/ReportFiles.h"

#include <algorithm>
#include <set>

namespace demand = anysl::demand;
namespace fs = std::filesystem;
namespace plot = anysl::plot;
namespace shade = anysl::shade;
using namespace anysl::render;

namespace {

/// How often each picture is rendered; the median counts.
constexpr int rounds = 3;

/// What a library is made of, or what an effect has of it.
struct Size {
  double instructions = 0, calls = 0;
  Size &operator+=(const Size &other) {
    instructions += other.instructions;
    calls += other.calls;
    return *this;
  }
  friend Size operator-(const Size &a, const Size &b) {
    return {a.instructions - b.instructions, a.calls - b.calls};
  }
};

/// An effect in all shaders of the scene.
struct Effect {
  std::set<std::string> asking;   ///< "trace_color mirror.sl:7", kept
  std::set<std::string> outputs;  ///< that it is for
  std::set<std::string> because;  ///< "Kr = 0.5 (scene.rib:9)"
  std::set<std::string> dropped;  ///< "trace_color mirror.sl:7: never reached: Kr = 0"
  std::set<std::string> requests; ///< "mirror (scene.rib:9)": shaders that have it kept
  Size before, after;
  double costBefore = 0, costAfter = 0; ///< seconds of processor time of the picture
  bool isMeasured = false;
  bool isKept() const { return !asking.empty(); }
};
using Effects = std::map<std::string, Effect>;

const demand::Json &member(const demand::Json &object, const char *key) {
  static const demand::Json none;
  auto found = std::find_if(object.members.begin(), object.members.end(),
                            [&](const demand::Json::Member &each) { return each.key == key; });
  return found == object.members.end() ? none : found->value;
}

Size sizeOf(const demand::Json &report) {
  Size result;
  for (const demand::Json &shader : member(report, "shaders").items)
    result += {member(shader, "scalarInstructions").number,
               double(member(shader, "callsLeft").items.size())};
  return result;
}

void addUses(const demand::Json &report, const std::string &request, Effects &effects) {
  for (const demand::Json &shader : member(report, "shaders").items)
    for (const demand::Json &use : member(shader, "effectUses").items) {
      Effect &effect = effects[member(use, "effect").text];
      std::string place = member(use, "op").text + " " +
                          fs::path(member(use, "file").text).filename().string() + ":" +
                          std::to_string(int(member(use, "line").number));
      const std::string &why = member(use, "why").text;
      if (!member(use, "kept").truth) {
        effect.dropped.insert(place + ": " + why);
        continue;
      }
      effect.asking.insert(place);
      effect.requests.insert(request);
      if (!why.empty())
        effect.because.insert(why);
      for (const demand::Json &output : member(use, "outputs").items)
        effect.outputs.insert(output.text);
    }
}

/// Values, inputs and outputs cannot be left out to see what they cost.
bool canBeLeftOut(const std::string &effect) { return effect != "Inputs" && effect != "Outputs"; }

/// The scene with shaders of one kind.
class Form {
public:
  Form(const Options &options, const SceneDescription &scene,
       const std::vector<fs::path> &searchPath, bool specialise, const std::string &withoutEffect,
       Warnings &warnings)
      : target(options.target), cache(options.cache, changed(specialise, withoutEffect)) {
    cache.searchPath = searchPath;
    host = makeHost(scene, cache, target, warnings);
  }

  const Scene &scene() const { return host->scene(); }
  void render() {
    double begin = shade::processSeconds();
    anysl::render::render(*host, {});
    times.push_back(shade::processSeconds() - begin);
  }
  double seconds() const { return shade::quantile(times, 0.5); }

  /// Of the libraries that another form has, linked as this one's are.
  demand::Json report(const WantedLibrary &library) const {
    ShaderVariant variant = library.variant;
    if (!target.specialise)
      for (const WantedLibrary *own : scene().opened())
        if (own->name == library.name)
          variant = own->variant;
    return cache.report(library.name, library.uses[0]->where, variant);
  }

private:
  const ShaderTarget &changed(bool specialise, const std::string &withoutEffect) {
    target.specialise = specialise;
    target.withoutEffect = withoutEffect;
    return target;
  }

  ShaderTarget target;
  ShaderCache cache;
  std::unique_ptr<Host> host;
  std::vector<double> times;
};

struct Measured {
  Effects effects;
  Size before, after;
  double secondsBefore = 0, secondsAfter = 0;
};

Measured measure(const Options &options, const SceneDescription &scene,
                 const std::vector<fs::path> &searchPath, Warnings &warnings) {
  auto make = [&](bool specialise, const std::string &without) {
    return std::make_unique<Form>(options, scene, searchPath, specialise, without, warnings);
  };
  Measured result;
  std::unique_ptr<Form> general = make(false, ""), special = make(true, "");
  std::vector<const WantedLibrary *> libraries = special->scene().opened();
  // Who links a library elsewhere knows what is in it.
  ShaderCache files(options.cache, options.target);
  files.searchPath = searchPath;
  std::erase_if(libraries, [&](const WantedLibrary *library) {
    return files.find(library->name)->extension() == ".so";
  });
  for (const WantedLibrary *library : libraries) {
    demand::Json report = special->report(*library);
    result.after += sizeOf(report);
    result.before += sizeOf(general->report(*library));
    addUses(report, library->name + " (" + demand::placeOf(library->uses[0]->where) + ")",
            result.effects);
  }
  std::vector<std::unique_ptr<Form>> without; // of each effect that is measured
  for (auto &[name, effect] : result.effects) {
    if (!canBeLeftOut(name))
      continue;
    effect.isMeasured = true;
    std::unique_ptr<Form> generalWithout = make(false, name), specialWithout = make(true, name);
    effect.before = result.before;
    effect.after = result.after;
    for (const WantedLibrary *library : libraries) {
      effect.before = effect.before - sizeOf(generalWithout->report(*library));
      effect.after = effect.after - sizeOf(specialWithout->report(*library));
    }
    without.push_back(std::move(generalWithout));
    without.push_back(std::move(specialWithout));
  }
  shade::Progress progress(fs::path(options.scene).filename().string(), options.quiet);
  for (int round = 0; round < rounds; ++round) {
    general->render();
    special->render();
    for (size_t i = 0; i < without.size(); ++i) {
      without[i]->render();
      progress.show((round + double(i + 1) / double(without.size())) / rounds);
    }
  }
  progress.finish();
  result.secondsBefore = general->seconds();
  result.secondsAfter = special->seconds();
  size_t next = 0;
  for (auto &[name, effect] : result.effects)
    if (effect.isMeasured) {
      effect.costBefore = result.secondsBefore - without[next++]->seconds();
      effect.costAfter = effect.isKept() ? result.secondsAfter - without[next]->seconds() : 0;
      ++next;
    }
  return result;
}

std::string join(const std::set<std::string> &texts, const char *separator = ", ") {
  std::string result;
  for (const std::string &text : texts)
    result += (result.empty() ? "" : separator) + text;
  return result;
}

/// Who asked, and why; or why nobody did.
std::string reason(const Effect &effect) {
  if (!effect.isKept())
    return join(effect.dropped, "; ");
  std::string result = join(effect.requests) + " at " + join(effect.asking);
  if (!effect.outputs.empty())
    result += "; for " + join(effect.outputs);
  if (!effect.because.empty())
    result += "; " + join(effect.because);
  return result;
}

void printTable(const Measured &measured) {
  std::printf("%-12s %-8s %16s %12s %20s  %s\n", "effect", "", "instructions", "calls",
              "milliseconds", "who asks, or why nobody does");
  auto line = [](const char *name, const char *state, const Size &before, const Size &after,
                 double costBefore, double costAfter, const std::string &why) {
    std::printf("%-12s %-8s %7.0f > %6.0f %5.0f > %4.0f %9.2f > %8.2f  %s\n", name, state,
                before.instructions, after.instructions, before.calls, after.calls,
                1e3 * costBefore, 1e3 * costAfter, why.c_str());
  };
  for (const auto &[name, effect] : measured.effects) {
    const char *state = effect.isKept() ? "kept" : "dropped";
    if (effect.isMeasured)
      line(name.c_str(), state, effect.before, effect.after, effect.costBefore, effect.costAfter,
           reason(effect));
    else
      std::printf("%-12s %-60s %s\n", name.c_str(), state, reason(effect).c_str());
  }
  line("all", "", measured.before, measured.after, measured.secondsBefore, measured.secondsAfter,
       "of the whole picture");
}

std::string number(double value) { return demand::shortest(value); }

std::string makeJson(const std::string &name, const Measured &measured) {
  auto list = [](const char *key, const std::set<std::string> &texts) {
    std::string items;
    for (const std::string &text : texts)
      items += (items.empty() ? "" : ", ") + demand::quoted(text);
    return std::string(", \"") + key + "\": [" + items + "]";
  };
  auto pair = [](const char *key, double before, double after) {
    return std::string(", \"") + key + "\": [" + number(before) + ", " + number(after) + "]";
  };
  auto sizes = [&](const Size &before, const Size &after) {
    return pair("instructions", before.instructions, after.instructions) +
           pair("calls", before.calls, after.calls);
  };
  std::string text =
      "{\"scene\": " + demand::quoted(name) + sizes(measured.before, measured.after) +
      pair("seconds", measured.secondsBefore, measured.secondsAfter) + ",\n\"effects\": [";
  bool isFirst = true;
  for (const auto &[effect, its] : measured.effects) {
    text += std::string(isFirst ? "" : ",") + "\n{\"effect\": " + demand::quoted(effect) +
            ", \"kept\": " + (its.isKept() ? "true" : "false") + list("requests", its.requests) +
            list("asking", its.asking) + list("outputs", its.outputs) +
            list("because", its.because) + list("dropped", its.dropped);
    if (its.isMeasured)
      text += sizes(its.before, its.after) + pair("seconds", its.costBefore, its.costAfter);
    text += "}";
    isFirst = false;
  }
  return text + "\n]}\n";
}

std::string makePage(const std::string &name, const Measured &measured) {
  double longest = 1e-9;
  for (const auto &[effect, its] : measured.effects)
    longest = std::max({longest, its.costBefore, its.costAfter});
  auto bar = [&](double seconds, const char *color) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "<div style=\"background: var(%s); height: 9px; margin: 2px 0; width: %.0fpx\" "
                  "title=\"%.2f ms\"></div>",
                  color, 240 * std::max(0.0, seconds) / longest, 1e3 * seconds);
    return std::string(text);
  };
  auto figures = [](double before, double after) {
    char text[80];
    std::snprintf(text, sizeof text, "%.0f \u2192 %.0f", before, after);
    return std::string(text);
  };
  std::vector<std::vector<std::string>> rows;
  std::vector<size_t> kept;
  for (const auto &[effect, its] : measured.effects) {
    if (its.isKept())
      kept.push_back(rows.size());
    rows.push_back({plot::escaped(effect), its.isKept() ? "kept" : "dropped",
                    its.isMeasured ? bar(its.costBefore, "--s5") + bar(its.costAfter, "--s0") : "",
                    its.isMeasured ? figures(its.before.instructions, its.after.instructions) : "",
                    its.isMeasured ? figures(its.before.calls, its.after.calls) : "",
                    "<div style=\"white-space: normal; min-width: 30em\">" +
                        plot::escaped(reason(its)) + "</div>"});
  }
  char summary[300];
  std::snprintf(summary, sizeof summary,
                "<p>The picture takes %.1f ms of processor time with shaders for any scene (grey "
                "bars), %.1f ms with those linked for it (blue). An effect's bar is what the "
                "picture takes less without it; instructions and calls are those of the shaders "
                "for one point.</p>",
                1e3 * measured.secondsBefore, 1e3 * measured.secondsAfter);
  return plot::page(plot::escaped(name) + ": what the scene calls for",
                    summary + ("<div class=\"scroll\">" +
                               plot::table({"effect", "", "cost in time", "instructions", "calls",
                                            "who asks, or why nobody does"},
                                           rows, kept) +
                               "</div>"));
}

} // namespace

void anysl::render::writeEffectsReport(const Options &options, const SceneDescription &scene,
                                       const std::vector<fs::path> &searchPath,
                                       Warnings &warnings) {
  std::string name = fs::path(options.scene).filename().string();
  makeReportFolder(options.effectsReport);
  Measured measured = measure(options, scene, searchPath, warnings);
  fs::path folder = options.effectsReport;
  writeReportFile(folder / "effects.json", makeJson(name, measured));
  writeReportFile(folder / "effects.html", makePage(name, measured));
  printTable(measured);
}
