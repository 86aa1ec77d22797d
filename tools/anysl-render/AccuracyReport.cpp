//===-- tools/anysl-render/AccuracyReport.cpp - what buys a better picture --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/AccuracyReport.h"
#include "lib/Plot/Plot.h"
#include "lib/Shade/Progress.h"
#include "lib/Shade/Timing.h"
#include "tools/anysl-render/PictureError.h"
#include "tools/anysl-render/Render.h"
#include "tools/anysl-render/ReportFiles.h"

#include <anysl/anysl.h>

#include <algorithm>
#include <ctime>
#include <fstream>

namespace demand = anysl::demand;
namespace fs = std::filesystem;
using namespace anysl::render;
namespace plot = anysl::plot;
namespace shade = anysl::shade;

namespace {

constexpr int rounds = 3;
/// The converged picture has this many times as many samples along each side of a pixel as the best
/// picture that is compared with it.
constexpr int referenceFactor = 2;
constexpr int samplesTried[] = {1, 2, 4, 8};
constexpr int ownSamplesTried[] = {1, 2, 4, 8};
constexpr const char *tiers[] = {
#define MATH_TIER(name, bound, boundForDouble) #name,
#include "runtimes/math/Tiers.def"
};

enum Subject { MathTier, Real, SamplesPerPixel, OwnSamples, SubjectCount };
constexpr const char *subjectNames[SubjectCount] = {"math tier", "real (host \u201cscalar\u201d)",
                                                    "samples a pixel",
                                                    "the shaders\u2019 own samples"};

/// One way to render the scene.
struct Setting {
  Subject subject;
  std::string label;
  ShaderTarget target;
  int samples;        ///< along each side of a pixel
  int ownSamples = 0; ///< 0: as the scene has it

  double seconds = 0;                       ///< of processor time, median
  double rmse = 0, flip = 0;                ///< against the converged picture
  double sameSamplesRmse = 0, sameFlip = 0; ///< against the same samples in double
};

/// The scene and its shaders as a setting has them.
class Prepared {
public:
  Prepared(const Options &options, const SceneDescription &original, const Setting &setting,
           const std::vector<fs::path> &searchPath, const std::vector<int> &withSamples,
           Warnings &warnings)
      : scene(original), cache(options.cache, setting.target) {
    cache.searchPath = searchPath;
    scene.samplesX = scene.samplesY = setting.samples;
    for (int index : withSamples)
      if (setting.ownSamples)
        setSamples(scene.shaders[size_t(index)].parameters, setting.ownSamples);
    host = makeHost(scene, cache, setting.target, warnings);
  }

  Film render(double &seconds) const {
    double begin = shade::processSeconds();
    RenderResult result = anysl::render::render(*host, {});
    seconds = shade::processSeconds() - begin;
    return std::move(result.film);
  }

private:
  static void setSamples(ParameterList &parameters, int samples) {
    for (Parameter &parameter : parameters)
      if (parameter.name == "samples") {
        parameter.numbers = {double(samples)};
        return;
      }
    parameters.push_back({"samples", {}, {double(samples)}, {}, {}});
  }

  SceneDescription scene;
  ShaderCache cache;
  std::unique_ptr<Host> host;
};

/// The surface shaders of a scene that have a uniform float parameter `samples`.
std::vector<int> shadersWithSamples(const SceneDescription &scene, const ShaderCache &cache) {
  std::vector<int> result;
  for (size_t i = 0; i < scene.shaders.size(); ++i) {
    const ShaderUse &use = scene.shaders[i];
    if (use.kind != ShaderKind::Surface || !cache.find(use.name))
      continue;
    AnyslLibrary *library = nullptr;
    if (anysl_library_open(fs::absolute(cache.library(use.name, use.where)).c_str(),
                           ANYSL_OPEN_INSPECT, &library))
      throw UserError(use.where, anysl_last_error());
    const AnyslShaderInfo *info = anysl_library_shader(library, nullptr);
    const AnyslParamInfo *param = info ? anysl_shader_param(info, "samples") : nullptr;
    if (param && param->type == ANYSL_FLOAT && !param->array_length)
      result.push_back(int(i));
    anysl_library_close(library);
  }
  return result;
}

std::vector<Setting> makeSettings(const Options &options, int samples, bool hasOwn) {
  std::vector<Setting> settings;
  ShaderTarget plain = options.target, scalar = plain;
  scalar.runtime = "scalar";
  scalar.width = 1;
  for (const char *tier : tiers) {
    ShaderTarget target = plain;
    target.math = tier;
    settings.push_back({MathTier, tier, target, samples});
  }
  for (const char *real : {"float", "double"}) {
    scalar.real = real;
    settings.push_back({Real, real, scalar, samples});
  }
  for (int tried : samplesTried)
    settings.push_back({SamplesPerPixel, std::to_string(tried * tried), plain, tried});
  for (int tried : ownSamplesTried)
    if (hasOwn)
      settings.push_back({OwnSamples, std::to_string(tried), plain, samples, tried});
  return settings;
}

plot::Plot makePlot(const std::string &scene, const std::vector<Setting> &settings,
                    double Setting::*error, const char *errorName) {
  plot::Plot result;
  result.title = scene + ": what buys a better picture";
  result.xLabel = std::string(errorName) + ", against the converged picture";
  result.yLabel = "seconds of processor time";
  for (const char *name : subjectNames)
    result.series.push_back(name);
  if (settings.back().subject != OwnSamples)
    result.series.pop_back();
  for (const Setting &setting : settings) {
    plot::Point point;
    point.x = setting.*error;
    point.y = setting.seconds;
    point.name = std::string(subjectNames[setting.subject]) + ": " + setting.label;
    point.label = setting.label;
    if (setting.subject == SamplesPerPixel)
      point.label += setting.samples == 1 ? " sample" : " samples";
    if (setting.subject == OwnSamples)
      point.label = "own " + setting.label;
    point.series = setting.subject;
    point.details = {{"seconds", plot::shortNumber(setting.seconds)},
                     {"RMSE", plot::shortNumber(setting.rmse)},
                     {"FLIP", plot::shortNumber(setting.flip)},
                     {"RMSE, same samples", plot::shortNumber(setting.sameSamplesRmse)},
                     {"FLIP, same samples", plot::shortNumber(setting.sameFlip)}};
    result.points.push_back(std::move(point));
  }
  return result;
}

std::string makePage(const std::string &name, const SceneDescription &scene, int samples,
                     int referenceSamples, const std::vector<Setting> &settings) {
  std::vector<std::vector<std::string>> rows;
  for (const Setting &setting : settings)
    rows.push_back({subjectNames[setting.subject], plot::escaped(setting.label),
                    plot::shortNumber(setting.seconds), plot::shortNumber(setting.rmse),
                    plot::shortNumber(setting.flip), plot::shortNumber(setting.sameSamplesRmse),
                    plot::shortNumber(setting.sameFlip)});
  std::string body = plot::svg(makePlot(name, settings, &Setting::rmse, "RMSE"), false);
  body += plot::svg(makePlot(name, settings, &Setting::flip, "mean FLIP"), false);
  body += "<p>" + std::to_string(scene.camera.width) + " \u00d7 " +
          std::to_string(scene.camera.height) +
          " pixels. One thing is changed at a time; all else is as the command line and the scene "
          "have it, with " +
          std::to_string(samples * samples) + " samples a pixel. The converged picture has " +
          std::to_string(referenceSamples * referenceSamples) +
          ", and functions rounded correctly. The last two columns compare with a picture of "
          "exactly the same samples whose shaders compute in double: that is all that tiers and "
          "reals change.</p>\n";
  body += plot::table({"what is changed", "to", "seconds", "RMSE", "FLIP", "RMSE, same samples",
                       "FLIP, same samples"},
                      rows);
  return plot::page(name + ": what buys a better picture", body);
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string makeJson(const std::string &name, const SceneDescription &scene, int referenceSamples,
                     const std::vector<Setting> &settings) {
  constexpr const char *keys[SubjectCount] = {"math", "real", "samples", "ownSamples"};
  std::string text =
      "{\"scene\": " + demand::quoted(name) + ", \"size\": [" + std::to_string(scene.camera.width) +
      ", " + std::to_string(scene.camera.height) +
      "], \"referenceSamples\": " + std::to_string(referenceSamples * referenceSamples) +
      ",\n\"settings\": [";
  for (const Setting &s : settings)
    text += std::string(&s == &settings.front() ? "" : ",") + "\n{\"changed\": \"" +
            keys[s.subject] + "\", \"to\": " + demand::quoted(s.label) +
            ", \"seconds\": " + number(s.seconds) + ", \"rmse\": " + number(s.rmse) +
            ", \"flip\": " + number(s.flip) +
            ", \"sameSamplesRmse\": " + number(s.sameSamplesRmse) +
            ", \"sameSamplesFlip\": " + number(s.sameFlip) + "}";
  return text + "\n]}\n";
}

} // namespace

void anysl::render::writeAccuracyReport(const Options &options, const SceneDescription &scene,
                                        const std::vector<fs::path> &searchPath,
                                        Warnings &warnings) {
  std::string name = fs::path(options.scene).filename().string();
  makeReportFolder(options.accuracyReport);
  ShaderCache cache(options.cache, options.target);
  cache.searchPath = searchPath;
  std::vector<int> withSamples = shadersWithSamples(scene, cache);
  int samples = std::max(scene.samplesX, scene.samplesY);
  std::vector<Setting> settings = makeSettings(options, samples, !withSamples.empty());

  int most = std::max(samples, *std::max_element(std::begin(samplesTried), std::end(samplesTried)));
  Setting converged = settings.front(); // rounded correctly
  converged.samples = referenceFactor * most;
  if (!withSamples.empty())
    converged.ownSamples =
        *std::max_element(std::begin(ownSamplesTried), std::end(ownSamplesTried));

  shade::Progress progress(name, options.quiet);
  // The converged picture counts as many as all others of one round.
  double steps = 2.0 * double(settings.size()) * rounds, done = 0;
  auto film = [&](const Setting &setting) {
    double seconds;
    return Prepared(options, scene, setting, searchPath, withSamples, warnings).render(seconds);
  };
  Film reference = film(converged);
  progress.show((done = steps / 2) / steps);

  std::vector<std::unique_ptr<Prepared>> prepared;
  std::map<std::pair<int, int>, Film> exact; // by samples and own samples
  for (Setting &setting : settings) {
    prepared.push_back(
        std::make_unique<Prepared>(options, scene, setting, searchPath, withSamples, warnings));
    auto [place, isNew] = exact.try_emplace({setting.samples, setting.ownSamples});
    if (isNew) {
      Setting same = setting;
      same.target.runtime = "scalar";
      same.target.real = "double";
      same.target.width = 1;
      place->second = film(same);
    }
  }
  std::vector<std::vector<double>> times(settings.size());
  for (int round = 0; round < rounds; ++round)
    for (size_t i = 0; i < settings.size(); ++i) {
      Setting &setting = settings[i];
      Film picture = prepared[i]->render(times[i].emplace_back());
      progress.show(++done / steps);
      if (round)
        continue;
      const Film &same = exact.at({setting.samples, setting.ownSamples});
      setting.rmse = rootMeanSquare(reference, picture);
      setting.flip = flipMean(reference, picture);
      setting.sameSamplesRmse = rootMeanSquare(same, picture);
      setting.sameFlip = flipMean(same, picture);
    }
  for (size_t i = 0; i < settings.size(); ++i)
    settings[i].seconds = shade::quantile(times[i], 0.5);
  progress.finish();

  fs::path folder = options.accuracyReport;
  writeReportFile(folder / "accuracy.html",
                  makePage(name, scene, samples, converged.samples, settings));
  writeReportFile(folder / "accuracy.json", makeJson(name, scene, converged.samples, settings));
  writeReportFile(folder / "accuracy.svg",
                  plot::svg(makePlot(name, settings, &Setting::flip, "mean FLIP"), true));
  if (options.quiet)
    return;
  for (const Setting &s : settings)
    std::fprintf(stderr, "%-28s %-8s %8.3f s  RMSE %-10.3g FLIP %-10.3g same samples: RMSE %.3g\n",
                 subjectNames[s.subject], s.label.c_str(), s.seconds, s.rmse, s.flip,
                 s.sameSamplesRmse);
}
