//===-- tools/anysl-render/Options.cpp - the command line -------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Options.h"

#include <charconv>
#include <cstring>

using namespace anysl::render;

const char *const anysl::render::helpText =
    R"(usage: anysl-render SCENE.rib [options]

Renders a RIB scene whose shaders are compiled by AnySL.

  -o IMAGE          write this file instead of the scene's (.png, .exr, ...); may be repeated
  --runtime NAME    packet (default): packets of rays; scalar: one ray at a time
  --width N         rays and points at once: 1, 4, 8 or 16 (default: what the processor holds)
  --real NAME       float (default) or double (scalar only)
  --math TIER       how exact the shaders' functions are (default: the linker's)
  --check-nan       say where shaders compute what is not a number, or infinite
  --max-loop N      leave shaders' loops after N rounds, and say where that was
  --threads N       threads (default: all)
  --size WxH        picture size
  --samples N       N x N samples a pixel
  --max-depth N     how often light is traced on
  --shaders DIR     look for shaders there first; may be repeated
  --cache-dir DIR   compiled shaders (default: $XDG_CACHE_HOME/anysl, ~/.cache/anysl); also --cache
  --cache-size MB   how large that folder may grow (default: 1024); what was not used for longest
                    goes first
  --no-specialise   link shaders for any scene, with effects that this one does not call for
  --without-effect NAME
                    leave an effect out of all shaders, as anysl-link does; may be repeated
  --keep-going      leave out what is missing or wrong in the scene, with a warning
  --watch           render again whenever the scene, a shader or a picture changes
  --accuracy-report FOLDER
                    instead of a picture, write what buys a better one: error against time of
                    every math tier, real and number of samples
  --effects FOLDER  instead of a picture, tell which effects of the shaders the scene calls for,
                    why, and what each costs
  --record FILE     write points at which surface and volume shaders ran, for anysl-cost --inputs
  --stats           print times and counts
  --stats-json FILE write them as JSON
  --quiet           no progress, no closing line
  --help, --version
)";

namespace {

bool readInteger(const std::string &text, int low, int high, int &value) {
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value >= low && value <= high;
}

/// The widest packets that the processor's vectors hold.
unsigned nativeWidth() {
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
    return 16;
  return __builtin_cpu_supports("avx2") ? 8 : 4;
}

} // namespace

Options anysl::render::parseOptions(int count, char **arguments) {
  Options options;
  bool widthGiven = false;
  for (int i = 1; i < count; ++i) {
    std::string option = arguments[i], value;
    bool hasValue = false;
    if (option.starts_with("--"))
      if (size_t equals = option.find('='); equals != option.npos) {
        value = option.substr(equals + 1);
        option.resize(equals);
        hasValue = true;
      }
    auto take = [&]() -> const std::string & {
      if (!hasValue) {
        if (i + 1 >= count)
          throw UserError("option " + option + " needs a value");
        value = arguments[++i];
      }
      return value;
    };
    auto integer = [&](int low, int high) {
      int number = 0;
      if (!readInteger(take(), low, high, number))
        throw UserError("option " + option + ": '" + value + "' is not a number from " +
                        std::to_string(low) + " to " + std::to_string(high));
      return number;
    };
    if (option == "-o")
      options.outputs.push_back(take());
    else if (option == "--runtime")
      options.target.runtime = take();
    else if (option == "--real")
      options.target.real = take();
    else if (option == "--math")
      options.target.math = take();
    else if (option == "--check-nan")
      options.target.checkNaN = true;
    else if (option == "--max-loop")
      options.target.maxLoop = unsigned(integer(1, 1'000'000'000));
    else if (option == "--width") {
      options.target.width = unsigned(integer(1, 16));
      widthGiven = true;
    } else if (option == "--threads")
      options.threads = unsigned(integer(1, 1024));
    else if (option == "--size") {
      size_t x = take().find('x');
      if (x == value.npos || !readInteger(value.substr(0, x), 1, 65536, options.sizeX) ||
          !readInteger(value.substr(x + 1), 1, 65536, options.sizeY))
        throw UserError("option --size: '" + value + "' is not a size such as 640x480");
    } else if (option == "--samples")
      options.samplesX = options.samplesY = integer(1, 1024);
    else if (option == "--max-depth")
      options.maxDepth = integer(0, 64);
    else if (option == "--shaders")
      options.shaderFolders.push_back(take());
    else if (option == "--cache" || option == "--cache-dir")
      options.cache.folder = take();
    else if (option == "--cache-size")
      options.cache.megabytes = uint64_t(integer(0, 1'000'000));
    else if (option == "--accuracy-report")
      options.accuracyReport = take();
    else if (option == "--effects")
      options.effectsReport = take();
    else if (option == "--without-effect")
      options.target.withoutEffects.push_back(take());
    else if (option == "--record")
      options.recordFile = take();
    else if (option == "--stats-json")
      options.statsFile = take();
    else if (option == "--watch")
      options.watch = true;
    else if (option == "--no-specialise")
      options.target.specialise = false;
    else if (option == "--keep-going")
      options.keepGoing = true;
    else if (option == "--stats")
      options.stats = true;
    else if (option == "--quiet")
      options.quiet = true;
    else if (option == "--help" || option == "-h")
      options.help = true;
    else if (option == "--version")
      options.version = true;
    else if (option.size() > 1 && option[0] == '-')
      throw UserError("unknown option " + option + "; see anysl-render --help");
    else if (!options.scene.empty())
      throw UserError("more than one scene: " + options.scene + ", " + option);
    else
      options.scene = option;
  }
  if (options.help || options.version)
    return options;
  if (options.scene.empty())
    throw UserError("no scene; see anysl-render --help");
  // These look at all that shaders compute, whatever the scene calls for.
  if (options.target.checkNaN || !options.recordFile.empty() || !options.accuracyReport.empty())
    options.target.specialise = false;
  unsigned width = options.target.width;
  if (options.target.runtime == "scalar") {
    if (widthGiven && width != 1)
      throw UserError("option --width: runtime \"scalar\" takes one ray at a time");
    options.target.width = 1;
  } else if (!widthGiven) {
    options.target.width = nativeWidth();
  } else if (width != 1 && width != 4 && width != 8 && width != 16) {
    throw UserError("option --width: must be 1, 4, 8 or 16");
  }
  return options;
}

void anysl::render::applyOptions(const Options &options, SceneDescription &scene) {
  if (options.sizeX > 0) {
    scene.camera.width = options.sizeX;
    scene.camera.height = options.sizeY;
  }
  if (options.samplesX > 0) {
    scene.samplesX = options.samplesX;
    scene.samplesY = options.samplesY;
  }
  if (options.maxDepth >= 0)
    scene.maxDepth = unsigned(options.maxDepth);
  if (options.outputs.empty())
    return;
  std::vector<OutputVariable> variables = {{"rgb", {}}};
  if (!scene.outputs.empty())
    variables = scene.outputs[0].variables;
  scene.outputs.clear();
  for (const std::string &name : options.outputs)
    scene.outputs.push_back({name, "file", variables, false, false, {}});
}
