//===-- tools/anysl-render/anysl-render.cpp - a ray tracer for AnySL's shaders ----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Demand/Json.h"
#include "lib/Rib/RibReader.h"
#include "lib/Shade/Options.h"
#include "lib/Shade/Progress.h"
#include "lib/Shade/Recording.h"
#include "tools/anysl-render/AccuracyReport.h"
#include "tools/anysl-render/EffectsReport.h"
#include "tools/anysl-render/Options.h"
#include "tools/anysl-render/Render.h"
#include "tools/anysl-render/Textures.h"
#include "tools/anysl-render/Watch.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <cstdio>

namespace demand = anysl::demand;
namespace fs = std::filesystem;
namespace shade = anysl::shade;
using namespace anysl::render;

namespace {

/// How many points --record keeps of each shader.
constexpr uint32_t recordedPoints = 4096;

/// Where shaders are looked for, first to last: --shaders, the scene's own search path, the scene's
/// folder, the folder of shaders next to it, the folder installed with the program.
std::vector<fs::path> shaderPath(const Options &options, const SceneDescription &scene) {
  std::vector<fs::path> standard;
  fs::path sceneFolder = fs::path(options.scene).parent_path();
  if (sceneFolder.empty())
    sceneFolder = ".";
  standard.push_back(sceneFolder);
  standard.push_back(sceneFolder / ".." / "shaders");
  standard.push_back(programFolder() / ".." / "share" / "anysl" / "shaders");

  std::vector<fs::path> result(options.shaderFolders.begin(), options.shaderFolders.end());
  std::string list = scene.shaderPath.empty() ? "&" : scene.shaderPath + ":&";
  bool standardDone = false;
  for (size_t begin = 0; begin <= list.size();) {
    size_t end = std::min(list.find(':', begin), list.size());
    std::string folder = list.substr(begin, end - begin);
    begin = end + 1;
    if (folder == "&" || folder == "@") {
      if (!standardDone)
        result.insert(result.end(), standard.begin(), standard.end());
      standardDone = true;
    } else if (!folder.empty()) {
      // Relative to the scene, so that a scene may be rendered from anywhere.
      result.push_back(fs::path(folder).is_absolute() ? fs::path(folder) : sceneFolder / folder);
    }
  }
  return result;
}

void writeStats(const Options &options, const Scene &rendered, const RenderResult &result,
                double setupSeconds, unsigned threads) {
  const SceneDescription &scene = rendered.description;
  const RenderCounts &counts = result.counts;
  std::string linked, linkedJson, byRays; // for this scene, with the number of variants
  for (const auto &[name, variants] : rendered.linkedForScene()) {
    static_assert(Variants::kindsOfRays == 3);
    auto [camera, traced, shadow] = variants;
    unsigned all = camera + traced + shadow;
    std::string which;
    if (traced)
      which += ", " + std::to_string(traced) + " for traced rays";
    if (shadow)
      which += ", " + std::to_string(shadow) + " for shadow rays";
    linked += (linked.empty() ? "" : ", ") + name +
              (all > 1 ? " (" + std::to_string(all) + " variants" + which + ")" : "");
    const char *separator = linkedJson.empty() ? "" : ", ";
    linkedJson += separator + demand::quoted(name) + ": " + std::to_string(all);
    byRays += separator + demand::quoted(name) + ": {\"camera\": " + std::to_string(camera) +
              ", \"traced\": " + std::to_string(traced) +
              ", \"shadow\": " + std::to_string(shadow) + "}";
  }
  if (options.stats) {
    std::fprintf(stderr,
                 "  set-up    %8.3f s\n  rendering %8.3f s on %u threads\n"
                 "  shading   %8.3f s summed over threads, %.1f ns a point\n"
                 "  rays      %llu from the camera, %llu traced, %llu to lights\n"
                 "  points    %llu shaded, %.1f at once; %llu of them for their opacity alone\n",
                 setupSeconds, result.seconds, threads, result.shadingSeconds,
                 counts.points ? 1e9 * result.shadingSeconds / double(counts.points) : 0.0,
                 (unsigned long long)counts.cameraRays, (unsigned long long)counts.traceRays,
                 (unsigned long long)counts.shadowRays, (unsigned long long)counts.points,
                 counts.batches ? double(counts.points) / double(counts.batches) : 0.0,
                 (unsigned long long)counts.shadowPoints);
    std::fprintf(stderr, "  linked for this scene: %s\n", linked.empty() ? "none" : linked.c_str());
  }
  if (options.statsFile.empty())
    return;
  FILE *file = options.statsFile == "-" ? stdout : std::fopen(options.statsFile.c_str(), "w");
  if (!file)
    throw UserError("cannot write '" + options.statsFile + "'");
  std::fprintf(
      file,
      "{\"runtime\": \"%s\", \"real\": \"%s\", \"width\": %u, \"threads\": %u, "
      "\"size\": [%d, %d], \"samples\": %d, \"setup_seconds\": %.6f, \"seconds\": %.6f, "
      "\"shading_seconds\": %.6f, \"camera_rays\": %llu, \"trace_rays\": %llu, "
      "\"shadow_rays\": %llu, \"points\": %llu, \"shadow_points\": %llu, \"batches\": %llu, "
      "\"bad_pixels\": %llu, \"linked_for_scene\": {%s}, \"linked_for_rays\": {%s}}\n",
      options.target.runtime.c_str(), options.target.real.c_str(), options.target.width, threads,
      scene.camera.width, scene.camera.height, scene.samplesX * scene.samplesY, setupSeconds,
      result.seconds, result.shadingSeconds, (unsigned long long)counts.cameraRays,
      (unsigned long long)counts.traceRays, (unsigned long long)counts.shadowRays,
      (unsigned long long)counts.points, (unsigned long long)counts.shadowPoints,
      (unsigned long long)counts.batches, (unsigned long long)result.film.badPixels,
      linkedJson.c_str(), byRays.c_str());
  if (file != stdout && std::fclose(file) != 0)
    throw UserError("cannot write '" + options.statsFile + "'");
}

void writeRecord(const std::string &path, shade::Recorder &recorder, Warnings &warnings) {
  std::vector<shade::RecordedShader> shaders = recorder.take();
  for (const shade::RecordedShader &shader : shaders)
    if (shader.lostLights)
      warnings.warn({}, "--record: the light shaders that shine on \"" + shader.name +
                            "\" are not recorded");
  try {
    shade::writeRecording(path, shaders);
  } catch (const shade::UserError &error) {
    throw UserError(error.what());
  }
}

/// When the file was saved because of which a picture is rendered again.
using SaveTime = std::optional<fs::file_time_type>;

/// Renders one picture and has the files it was made from watched. Returns false if a change of one
/// of them ended it early.
bool renderScene(const Options &options, const SceneDescription &scene, Watch *watch,
                 SaveTime saved, unsigned threads, Warnings &warnings) {
  auto begin = std::chrono::steady_clock::now();
  if (double(scene.camera.width) * scene.camera.height > 0x1p28)
    throw UserError("a picture of " + std::to_string(scene.camera.width) + "x" +
                    std::to_string(scene.camera.height) + " pixels is too large");
  for (const OutputFile &output : scene.outputs)
    checkOutput(output);
  if (watch)
    watch->add({scene.archives.begin(), scene.archives.end()});
  ShaderCache cache(options.cache, options.target);
  cache.searchPath = shaderPath(options, scene);
  std::unique_ptr<Host> host;
  try {
    host = makeHost(scene, cache, options.target, warnings);
  } catch (const UserError &) {
    if (watch) // a shader that does not compile is waited for
      watch->add(cache.sources());
    throw;
  }
  if (watch) {
    watch->add(cache.sources());
    host->scene().pictures().tellPlaces([watch](const std::string &path) { watch->add({path}); });
  }
  double setup = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  shade::Progress progress(fs::path(options.scene).filename().string(), options.quiet);
  RenderOptions renderOptions;
  renderOptions.timed = options.stats || !options.statsFile.empty();
  SaveTime firstPixels;
  renderOptions.progress = [&](double share) {
    if (!firstPixels)
      firstPixels = fs::file_time_type::clock::now();
    progress.show(share);
  };
  if (watch)
    renderOptions.cancelled = [watch] { return watch->changed(); };
  shade::Recorder recorder(recordedPoints);
  if (!options.recordFile.empty())
    renderOptions.recorder = &recorder;
  RenderResult result = render(*host, renderOptions);
  progress.finish();
  if (!result.complete)
    return false;
  if (result.film.badPixels > 0)
    warnings.warn({}, std::to_string(result.film.badPixels) +
                          " pixels had samples that are not numbers; those samples were left out");
  host->scene().printNotes(stderr);
  std::string names;
  for (const OutputFile &output : scene.outputs) {
    writeImage(result.film, scene, output);
    names += (names.empty() ? "" : ", ") + imageFileName(output);
  }
  if (!options.recordFile.empty())
    writeRecord(options.recordFile, recorder, warnings);
  std::string notes = cache.compilations() ? ", shaders compiled before" : "";
  if (saved && firstPixels) {
    char text[80];
    std::snprintf(text, sizeof text, ", first pixels %.2f s after the save",
                  std::chrono::duration<double>(*firstPixels - *saved).count());
    notes += text;
  }
  if (!options.quiet)
    std::fprintf(stderr, "%s: %dx%d, %s %s, width %u: %.2f s%s\n", names.c_str(),
                 scene.camera.width, scene.camera.height, options.target.runtime.c_str(),
                 options.target.real.c_str(), options.target.width, result.seconds, notes.c_str());
  writeStats(options, host->scene(), result, setup, threads);
  return true;
}

/// Has the pictures watched that textures are made of, but no file that is written for the scenes.
void watchPictures(const std::vector<SceneDescription> &scenes, Watch &watch) {
  std::vector<fs::path> sources;
  for (const SceneDescription &scene : scenes) {
    for (const OutputFile &output : scene.outputs)
      watch.leaveOut(imageFileName(output));
    for (const auto *textures : {&scene.texturesBefore, &scene.texturesAfter})
      for (const TextureUse &texture : *textures) {
        watch.leaveOut(texture.texture);
        sources.insert(sources.end(), texture.pictures.begin(), texture.pictures.end());
      }
  }
  watch.add(sources);
}

void makeTextures(const std::vector<TextureUse> &textures, Warnings &warnings) {
  for (const TextureUse &texture : textures)
    try {
      makeTexture(texture);
    } catch (const UserError &error) {
      // What needs the texture says so itself.
      warnings.warn(error.where, error.message);
    }
}

void renderFile(const Options &options, Watch *watch, SaveTime saved, unsigned threads) {
  Warnings warnings;
  warnings.keepGoing = options.keepGoing;
  std::vector<SceneDescription> scenes = readRib(loadSourceFile(options.scene), warnings);
  for (SceneDescription &scene : scenes) {
    scene.folder = fs::path(options.scene).parent_path().string();
    applyOptions(options, scene);
  }
  if (watch)
    watchPictures(scenes, *watch);
  for (SceneDescription &scene : scenes) {
    makeTextures(scene.texturesBefore, warnings);
    if (!options.accuracyReport.empty())
      return writeAccuracyReport(options, scene, shaderPath(options, scene), warnings);
    if (!options.effectsReport.empty())
      return writeEffectsReport(options, scene, shaderPath(options, scene), warnings);
    if (!renderScene(options, scene, watch, saved, threads, warnings))
      return;
    makeTextures(scene.texturesAfter, warnings);
  }
}

[[noreturn]] void watchFile(const Options &options, unsigned threads) {
  for (SaveTime saved;;) {
    Watch watch;
    watch.add({options.scene});
    try {
      renderFile(options, &watch, saved, threads);
    } catch (const UserError &error) {
      std::fputs(error.what(), stderr); // and stay until the cause is put right
    }
    saved = watch.wait();
  }
}

} // namespace

int main(int count, char **arguments) {
  try {
    Options options = parseOptions(count, arguments);
    if (options.help) {
      std::fputs(helpText, stdout);
      return 0;
    }
    if (options.version) {
      std::puts("anysl-render " ANYSL_VERSION);
      return 0;
    }
    unsigned threads =
        options.threads ? options.threads : unsigned(tbb::info::default_concurrency());
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    if (options.watch)
      watchFile(options, threads);
    renderFile(options, nullptr, std::nullopt, threads);
    return 0;
  } catch (const UserError &error) {
    std::fputs(error.what(), stderr);
    return 1;
  } catch (const std::bad_alloc &) {
    std::fputs("anysl-render: error: out of memory\n", stderr);
    return 1;
  } catch (const std::exception &error) {
    std::fprintf(stderr,
                 "anysl-render: internal error: %s\nPlease report this with the scene that led to "
                 "it.\n",
                 error.what());
    return 2;
  }
}
