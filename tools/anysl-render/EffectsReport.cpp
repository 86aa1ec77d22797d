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
#include "tools/anysl-render/Lights.h"
#include "tools/anysl-render/Render.h"
#include "tools/anysl-render/ReportFiles.h"
#include "tools/anysl-render/SceneEffects.h"

#include <algorithm>
#include <chrono>
#include <set>

namespace demand = anysl::demand;
namespace fs = std::filesystem;
namespace plot = anysl::plot;
namespace shade = anysl::shade;
using namespace anysl::render;

namespace {

/// How often each picture is rendered at least and at most, and within how many seconds altogether
/// there may be more than at least; the median counts.
constexpr int fewestRounds = 3, mostRounds = 15;
constexpr double secondsForMore = 30;

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

/// An effect in all shaders of the scene, or one of the scene itself.
struct Effect {
  std::set<std::string> asking;   ///< "trace_color mirror.sl:7", kept
  std::set<std::string> outputs;  ///< that it is for
  std::set<std::string> because;  ///< "Kr = 0.5 (scene.rib:9)"
  std::set<std::string> dropped;  ///< "trace_color mirror.sl:7: never reached: Kr = 0"
  std::set<std::string> requests; ///< "mirror (scene.rib:9)": shaders that have it kept
  Size before, after;
  double costBefore = 0, costAfter = 0; ///< seconds of processor time of the picture
  /// How its cost is found: an effect is left out of shaders or of the scene, an input is computed
  /// once more.
  enum { NotMeasured, InShaders, OfScene, Input } how = NotMeasured;
  std::string whyNotMeasured;
  bool isKept() const { return !asking.empty(); }
  bool hasSize() const { return how == InShaders; }
  bool isMeasured() const { return how == OfScene ? isKept() : how != NotMeasured; }
};
using Effects = std::map<std::string, Effect>;

Size sizeOf(const demand::Json &report) {
  Size result;
  for (const demand::Json &shader : demand::member(report, "shaders").items)
    result += {demand::member(shader, "scalarInstructions").number,
               double(demand::member(shader, "callsLeft").items.size())};
  return result;
}

void addUses(const demand::Json &report, const std::string &request, Effects &effects) {
  for (const demand::Json &shader : demand::member(report, "shaders").items)
    for (const demand::Json &use : demand::member(shader, "effectUses").items) {
      Effect &effect = effects[demand::member(use, "effect").text];
      std::string place = demand::member(use, "op").text + " " +
                          fs::path(demand::member(use, "file").text).filename().string() + ":" +
                          std::to_string(int(demand::member(use, "line").number));
      const std::string &why = demand::member(use, "why").text;
      if (!demand::member(use, "kept").truth) {
        effect.dropped.insert(place + ": " + why);
        continue;
      }
      effect.asking.insert(place);
      effect.requests.insert(request);
      if (!why.empty())
        effect.because.insert(why);
      for (const demand::Json &output : demand::member(use, "outputs").items)
        effect.outputs.insert(output.text);
    }
}

/// Notes at each kind of light how many of it are linked into a library, and at loops over lights
/// how many became one round after the other.
void addLinkedLights(const demand::Json &report, const std::string &request,
                     const SceneDescription &scene, Effects &effects) {
  std::map<std::string, int> counts; // by name, not by what a demand calls the kind
  for (const demand::Json &kind : demand::member(report, "linkedLights").items)
    for (const LightUse &light : scene.lights)
      if (kind.text == light.name || kind.text == kindOfShader(light.name)) {
        ++counts[light.name];
        break;
      }
  for (const auto &[name, count] : counts)
    effects["Lights." + name].because.insert(std::to_string(count) + " linked into " + request);
  int loops = int(demand::member(report, "lightLoops").number);
  if (auto found = effects.find("Lights"); found != effects.end() && loops)
    found->second.because.insert(std::to_string(loops) + (loops == 1 ? " loop" : " loops") +
                                 " unrolled in " + request);
}

/// The global variable of an effect "Inputs.NAME"; -1: it is none.
int inputOf(const std::string &effect) {
  constexpr std::string_view prefix = "Inputs.";
  return effect.starts_with(prefix) ? anysl_global_find(effect.c_str() + prefix.size()) : -1;
}

/// The globals that are computed for points of surfaces, whoever asks for them.
uint64_t globalsOf(const Scene &scene) {
  uint64_t result = 0;
  for (uint32_t i = 0; i < scene.groupCount(); ++i) {
    const ShadingGroup &group = scene.group(i);
    result |= group.globalsOfOthers();
    for (const Shader *shader : {group.shader, group.atmosphere, group.interior, group.exterior})
      result |= shader ? shader->needed : 0;
  }
  return result;
}

/// Says how the cost of an effect of shaders is found.
void chooseMeasure(const std::string &name, uint64_t computed, Effect &effect) {
  if (!name.starts_with("Inputs")) {
    effect.how = Effect::InShaders;
    return;
  }
  const int global = inputOf(name);
  if (global < 0)
    effect.whyNotMeasured = "a parameter: the shape's variable, or what the shader has put there";
  else if (anysl_global_is_uniform(global))
    effect.whyNotMeasured = "the same at all points";
  else if (!(computed >> global & 1))
    effect.whyNotMeasured = "not of points that rays meet";
  else
    effect.how = Effect::Input;
}

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
  /// Renders, and adds the time that it takes to `times`. `again`: as in RenderOptions.
  void render(std::vector<double> &times, std::optional<uint64_t> again = std::nullopt) const {
    RenderOptions options;
    options.again = again;
    double begin = shade::processSeconds();
    anysl::render::render(*host, options);
    times.push_back(shade::processSeconds() - begin);
  }

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
    if (!withoutEffect.empty())
      target.withoutEffects.push_back(withoutEffect);
    return target;
  }

  ShaderTarget target;
  ShaderCache cache;
  std::unique_ptr<Host> host;
};

/// What is rendered again and again, general and special in turn.
struct Candidate {
  Effect *effect;                ///< null: all
  const Form *general, *special; ///< an input's are those of all
  std::optional<uint64_t> again; ///< for an input
  std::unique_ptr<Form> ownGeneral, ownSpecial;
  std::vector<double> before, after;
  double secondsBefore() const { return shade::quantile(before, 0.5); }
  double secondsAfter() const { return shade::quantile(after, 0.5); }
};

/// What half of the renderings of one picture differ by.
double spread(const std::vector<double> &seconds) {
  return shade::quantile(seconds, 0.75) - shade::quantile(seconds, 0.25);
}

struct Measured {
  Effects effects;
  Size before, after;
  double secondsBefore = 0, secondsAfter = 0;
  double spreadBefore = 0, spreadAfter = 0;
};

/// Names the displays that show outputs among the reasons for these.
void addDisplays(const SceneDescription &scene, Effects &effects) {
  for (const OutputFile &file : scene.outputs)
    for (const OutputVariable &variable : file.variables) {
      std::string name = variable.name == "rgb" ? "Ci"
                         : variable.name == "a" ? "Oi"
                                                : variable.name;
      if (auto found = effects.find("Outputs." + name);
          found != effects.end() && found->second.isKept())
        found->second.because.insert(described("Display", file.name, file.where));
    }
}

Measured measure(const Options &options, const SceneDescription &scene,
                 const std::vector<fs::path> &searchPath, Warnings &warnings) {
  auto make = [&](bool specialise, const std::string &without) {
    return std::make_unique<Form>(options, scene, searchPath, specialise, without, warnings);
  };
  Measured result;
  std::unique_ptr<Form> general = make(false, ""), special = make(true, "");
  std::vector<const WantedLibrary *> libraries = special->scene().opened();
  // Who links a library elsewhere knows what is in it. What other rays than the camera's want is
  // less of the same.
  ShaderCache files(options.cache, options.target);
  files.searchPath = searchPath;
  std::erase_if(libraries, [&](const WantedLibrary *library) {
    return files.find(library->name)->extension() == ".so" || library->rays != RayKind::Camera;
  });
  for (const WantedLibrary *library : libraries) {
    demand::Json report = special->report(*library);
    result.after += sizeOf(report);
    result.before += sizeOf(general->report(*library));
    std::string request = library->name + " (" + demand::placeOf(library->uses[0]->where) + ")";
    addUses(report, request, result.effects);
    addLinkedLights(report, request, scene, result.effects);
  }
  addDisplays(scene, result.effects);
  std::map<std::string, SceneDescription> scenesWithout;
  for (const SceneEffect &its : sceneEffects(scene)) {
    Effect &effect = result.effects[its.name];
    effect.how = Effect::OfScene;
    effect.asking = its.asking;
    if (!effect.isKept())
      effect.dropped.insert(its.whyNot);
    else
      its.leaveOut(scenesWithout.try_emplace(its.name, scene).first->second);
  }
  std::vector<Candidate> candidates;
  auto add = [&](Effect *effect, std::optional<uint64_t> again = std::nullopt) -> Candidate & {
    return candidates.emplace_back(effect, general.get(), special.get(), again);
  };
  auto addForms = [&](Effect &effect, std::unique_ptr<Form> ownGeneral,
                      std::unique_ptr<Form> ownSpecial) {
    Candidate &its = add(&effect);
    its.general = ownGeneral.get(), its.special = ownSpecial.get();
    its.ownGeneral = std::move(ownGeneral), its.ownSpecial = std::move(ownSpecial);
  };
  add(nullptr);
  add(nullptr, 0); // what is done once more for every input
  const uint64_t computed = globalsOf(general->scene());
  for (auto &[name, effect] : result.effects) {
    if (effect.how != Effect::OfScene)
      chooseMeasure(name, computed, effect);
    if (effect.how == Effect::Input) {
      add(&effect, uint64_t(1) << inputOf(name));
    } else if (effect.how == Effect::OfScene && effect.isKept()) {
      auto makeOther = [&](bool specialise) {
        return std::make_unique<Form>(options, scenesWithout.at(name), searchPath, specialise, "",
                                      warnings);
      };
      addForms(effect, makeOther(false), makeOther(true));
    } else if (effect.how == Effect::InShaders) {
      std::unique_ptr<Form> generalWithout = make(false, name), specialWithout = make(true, name);
      effect.before = result.before;
      effect.after = result.after;
      for (const WantedLibrary *library : libraries) {
        effect.before = effect.before - sizeOf(generalWithout->report(*library));
        effect.after = effect.after - sizeOf(specialWithout->report(*library));
      }
      addForms(effect, std::move(generalWithout), std::move(specialWithout));
    }
  }
  shade::Progress progress(fs::path(options.scene).filename().string(), options.quiet);
  const auto begin = std::chrono::steady_clock::now();
  int rounds = fewestRounds;
  for (int round = 0; round < rounds; ++round) {
    for (size_t i = 0; i < candidates.size(); ++i) {
      Candidate &its = candidates[i];
      its.general->render(its.before, its.again);
      its.special->render(its.after, its.again);
      progress.show((round + double(i + 1) / double(candidates.size())) / rounds);
    }
    std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    if (round == 0)
      rounds = std::clamp(int(secondsForMore / elapsed.count()), fewestRounds, mostRounds);
  }
  progress.finish();
  const Candidate &all = candidates[0], &nothing = candidates[1];
  result.secondsBefore = all.secondsBefore();
  result.secondsAfter = all.secondsAfter();
  result.spreadBefore = spread(all.before);
  result.spreadAfter = spread(all.after);
  for (const Candidate &its : candidates) {
    if (!its.effect)
      continue;
    bool isInput = its.again.has_value();
    its.effect->costBefore = isInput ? its.secondsBefore() - nothing.secondsBefore()
                                     : result.secondsBefore - its.secondsBefore();
    if (its.effect->isKept())
      its.effect->costAfter = isInput ? its.secondsAfter() - nothing.secondsAfter()
                                      : result.secondsAfter - its.secondsAfter();
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
std::string whoAsked(const Effect &effect) {
  if (!effect.isKept())
    return join(effect.dropped, "; ");
  std::string result =
      (effect.how == Effect::OfScene ? "" : join(effect.requests) + " at ") + join(effect.asking);
  if (!effect.outputs.empty())
    result += "; for " + join(effect.outputs);
  if (!effect.because.empty())
    result += "; " + join(effect.because);
  return result;
}

std::string reason(const Effect &effect) {
  return whoAsked(effect) +
         (effect.whyNotMeasured.empty() ? "" : "; no time: " + effect.whyNotMeasured);
}

void printTable(const Measured &measured) {
  int widest = 6;
  for (const auto &[name, effect] : measured.effects)
    widest = std::max(widest, int(name.size()));
  auto line = [widest](const std::string &name, const char *state, const std::string &size,
                       const std::string &time, const std::string &why) {
    std::printf("%-*s %-8s %29s %20s  %s\n", widest, name.c_str(), state, size.c_str(),
                time.c_str(), why.c_str());
  };
  auto print = [](const char *format, auto... values) {
    char text[80];
    std::snprintf(text, sizeof text, format, values...);
    return std::string(text);
  };
  auto sizes = [&](const Size &before, const Size &after) {
    return print("%7.0f > %6.0f %5.0f > %4.0f", before.instructions, after.instructions,
                 before.calls, after.calls);
  };
  auto times = [&](double before, double after) {
    return print("%9.2f > %8.2f", 1e3 * before, 1e3 * after);
  };
  line("effect", "", print("%16s %12s", "instructions", "calls"), "milliseconds",
       "who asks, or why nobody does");
  for (const auto &[name, effect] : measured.effects) {
    line(name, effect.isKept() ? "kept" : "dropped",
         effect.hasSize() ? sizes(effect.before, effect.after) : "",
         effect.isMeasured() ? times(effect.costBefore, effect.costAfter) : "", reason(effect));
  }
  line("all", "", sizes(measured.before, measured.after),
       times(measured.secondsBefore, measured.secondsAfter), "of the whole picture");
  line("spread", "", "", times(measured.spreadBefore, measured.spreadAfter),
       "what half of its renderings differ by");
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
      pair("seconds", measured.secondsBefore, measured.secondsAfter) +
      pair("spread", measured.spreadBefore, measured.spreadAfter) + ",\n\"effects\": [";
  bool isFirst = true;
  for (const auto &[effect, its] : measured.effects) {
    text += std::string(isFirst ? "" : ",") + "\n{\"effect\": " + demand::quoted(effect) +
            ", \"of\": \"" + (its.how == Effect::OfScene ? "scene" : "shaders") + "\"" +
            ", \"kept\": " + (its.isKept() ? "true" : "false") + list("requests", its.requests) +
            list("asking", its.asking) + list("outputs", its.outputs) +
            list("because", its.because) + list("dropped", its.dropped);
    if (its.hasSize())
      text += sizes(its.before, its.after);
    if (its.isMeasured())
      text += pair("seconds", its.costBefore, its.costAfter);
    if (!its.whyNotMeasured.empty())
      text += ", \"not measured\": " + demand::quoted(its.whyNotMeasured);
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
    rows.push_back(
        {plot::escaped(effect), its.isKept() ? "kept" : "dropped",
         its.isMeasured() ? bar(its.costBefore, "--s5") + bar(its.costAfter, "--s0") : "",
         its.hasSize() ? figures(its.before.instructions, its.after.instructions) : "",
         its.hasSize() ? figures(its.before.calls, its.after.calls) : "",
         "<div style=\"white-space: normal; min-width: 30em\">" + plot::escaped(reason(its)) +
             "</div>"});
  }
  char summary[500];
  std::snprintf(
      summary, sizeof summary,
      "<p>The picture takes %.1f ms of processor time with shaders for any scene (grey "
      "bars), %.1f ms with those linked for it (blue); half of its renderings differ by %.1f "
      "and %.1f ms. An effect's bar is what the "
      "picture takes less without it, that of an input what it takes more to compute it "
      "once more; instructions and calls are those of the shaders "
      "for one point.</p>",
      1e3 * measured.secondsBefore, 1e3 * measured.secondsAfter, 1e3 * measured.spreadBefore,
      1e3 * measured.spreadAfter);
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
