//===-- lib/Rib/RibOptions.cpp - requests about camera, samples and files ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/FileTypes.h"
#include "lib/Rib/RibState.h"

#include <algorithm>
#include <set>

namespace fs = std::filesystem;
using namespace anysl::render;

namespace {

/// "rgb", "rgbaz" and the like, or names of variables with commas between them.
std::vector<OutputVariable>
readMode(const std::string &mode, const Location &where,
         const std::map<std::string, Declaration, std::less<>> &declarations) {
  std::vector<OutputVariable> result;
  std::string_view rest = mode;
  for (std::string_view part : {"rgb", "a", "z"})
    if (rest.starts_with(part)) {
      result.push_back({std::string(part), {}});
      rest.remove_prefix(part.size());
    }
  if (rest.empty() && !result.empty())
    return result;
  result.clear();
  rest = mode;
  while (!rest.empty()) {
    size_t end = std::min(rest.find(','), rest.size());
    std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    OutputVariable variable;
    if (word.find(' ') != word.npos) {
      variable.declaration = parseDeclaration(word, &variable.name, where);
    } else {
      variable.name = word;
      if (auto known = declarations.find(word); known != declarations.end())
        variable.declaration = known->second;
    }
    if (variable.name == "Ci")
      variable.name = "rgb";
    else if (variable.name == "alpha")
      variable.name = "a";
    if (!variable.name.empty())
      result.push_back(std::move(variable));
  }
  if (result.empty())
    throw UserError(where, "Display: the mode is empty; give one such as \"rgba\"");
  return result;
}

} // namespace

void RibState::display(RibArguments &arguments) {
  OutputFile output;
  output.where = arguments.where();
  output.name = arguments.string("a file name");
  output.format = arguments.string("a type");
  output.variables = readMode(arguments.string("a mode"), arguments.where(), declarations);
  ParameterList parameters = arguments.parameters();
  if (const Parameter *type = findParameter(parameters, "exrpixeltype"))
    output.half = !type->strings.empty() && type->strings[0] == "half";
  if (!fileFormat(output.format)) {
    // A picture that only a window would show is better than none.
    output.isReplacement = true;
    if (fs::path(output.name).extension() != ".exr")
      output.name = fs::path(output.name).replace_extension(".png").string();
  }
  // As in the standard, "+name" adds an output and any other name starts the list anew.
  if (!output.name.empty() && output.name[0] == '+')
    output.name.erase(0, 1);
  else
    scene.outputs.clear();
  if (output.name.empty())
    throw UserError(arguments.where(), "Display: the file name is empty");
  if (output.isReplacement && !scene.outputs.empty())
    return;
  std::erase_if(scene.outputs, [&](const OutputFile &each) { return each.isReplacement; });
  scene.outputs.push_back(std::move(output));
}

void RibState::displayChannel(RibArguments &arguments) {
  std::string text = arguments.string("a channel"), name = text;
  arguments.parameters();
  // Some writers put a blank before a standard channel's name.
  if (text.find(' ', text.find_first_not_of(' ')) != text.npos) {
    Declaration declaration = parseDeclaration(text, &name, arguments.where());
    declarations.insert_or_assign(name, declaration);
  }
}

void RibState::format(RibArguments &arguments) {
  auto n = arguments.numbers(3, "width, height and pixel aspect");
  // Negative numbers stand for the standard ones.
  const CameraDescription standard;
  n[0] = n[0] < 0 ? standard.width : n[0];
  n[1] = n[1] < 0 ? standard.height : n[1];
  if (!(n[0] >= 1 && n[1] >= 1 && n[0] <= 65536 && n[1] <= 65536))
    throw UserError(arguments.where(),
                    "Format: the size must lie between 1 and 65536 pixels a side");
  scene.camera.width = int(n[0]);
  scene.camera.height = int(n[1]);
  scene.camera.pixelAspect = n[2] > 0 ? n[2] : 1;
}

void RibState::projection(RibArguments &arguments) {
  std::string name = arguments.string("a name");
  ParameterList parameters = arguments.parameters();
  if (name == "perspective")
    scene.camera.perspective = true;
  else if (name == "orthographic" || name == "null" || name.empty())
    scene.camera.perspective = false;
  else {
    warnings.warn(arguments.where(), "Projection \"" + name +
                                         "\" is neither \"perspective\" nor \"orthographic\"; "
                                         "\"perspective\" is used");
    scene.camera.perspective = true;
  }
  for (const Parameter &parameter : parameters) {
    if (parameter.name != "fov" || parameter.numbers.size() != 1) {
      warnUnknown("projection parameter", parameter.name, parameter.where);
      continue;
    }
    scene.camera.fov = parameter.numbers[0];
    if (!(scene.camera.fov > 0 && scene.camera.fov < 180))
      throw UserError(parameter.where, "Projection: the field of view must lie between 0 and 180");
  }
}

void RibState::pixelSamples(RibArguments &arguments) {
  auto n = arguments.numbers(2, "samples in x and y");
  if (!(n[0] >= 1 && n[1] >= 1 && n[0] <= 1024 && n[1] <= 1024))
    throw UserError(arguments.where(), "PixelSamples: must lie between 1 and 1024");
  scene.samplesX = int(n[0]);
  scene.samplesY = int(n[1]);
}

void RibState::hider(RibArguments &arguments) {
  // All else steers how other kinds of renderer reach the same picture.
  arguments.string("a name");
  ParameterList parameters = arguments.parameters();
  if (const Parameter *jitter = findParameter(parameters, "jitter"))
    scene.jitter = jitter->numbers.empty() || jitter->numbers[0] != 0;
}

void RibState::pixelFilter(RibArguments &arguments) {
  std::string name = arguments.string("a name");
  auto n = arguments.numbers(2, "widths in x and y");
  if (!(n[0] > 0 && n[1] > 0 && n[0] <= 64 && n[1] <= 64))
    throw UserError(arguments.where(), "PixelFilter: widths must lie between 0 and 64");
  scene.filterWidthX = n[0];
  scene.filterWidthY = n[1];
  static const std::map<std::string_view, FilterKind> filters = {
      {"box", FilterKind::Box},
      {"triangle", FilterKind::Triangle},
      {"gaussian", FilterKind::Gaussian},
      {"catmull-rom", FilterKind::CatmullRom},
      {"separable-catmull-rom", FilterKind::CatmullRom},
      {"sinc", FilterKind::Sinc},
      {"mitchell", FilterKind::Mitchell},
      {"blackman-harris", FilterKind::BlackmanHarris},
      {"disk", FilterKind::Disk}};
  auto filter = filters.find(name);
  if (filter == filters.end())
    warnings.warn(arguments.where(),
                  "PixelFilter \"" + name + "\" is not known; \"gaussian\" is used");
  scene.filter = filter == filters.end() ? FilterKind::Gaussian : filter->second;
}

void RibState::exposure(RibArguments &arguments) {
  auto n = arguments.numbers(2, "gain and gamma");
  if (!(n[1] > 0))
    throw UserError(arguments.where(), "Exposure: gamma must be positive");
  scene.gain = n[0];
  scene.gamma = n[1];
}

void RibState::quantize(RibArguments &arguments) {
  std::string type = arguments.string("what is quantized");
  auto n = arguments.numbers(4, "one, min, max and dither amplitude");
  if (type == "rgb" || type == "rgba")
    scene.quantizeOne = n[0];
}

void RibState::screenWindow(RibArguments &arguments) {
  auto n = arguments.numbers(4, "left, right, bottom and top");
  if (n[0] == n[1] || n[2] == n[3])
    throw UserError(arguments.where(), "ScreenWindow: the window is empty");
  scene.camera.screenWindow = {n[0], n[1], n[2], n[3]};
}

void RibState::cropWindow(RibArguments &arguments) {
  auto n = arguments.numbers(4, "xmin, xmax, ymin and ymax");
  for (double &value : n)
    value = std::clamp(value, 0.0, 1.0);
  if (!(n[0] < n[1] && n[2] < n[3]))
    throw UserError(arguments.where(), "CropWindow: the window is empty");
  scene.camera.cropWindow = {n[0], n[1], n[2], n[3]};
}

void RibState::frameAspectRatio(RibArguments &arguments) {
  scene.camera.frameAspect = arguments.number("the aspect ratio");
  if (!(scene.camera.frameAspect > 0))
    throw UserError(arguments.where(), "FrameAspectRatio: must be positive");
}

void RibState::clipping(RibArguments &arguments) {
  auto n = arguments.numbers(2, "near and far");
  if (!(n[0] >= 0 && n[1] > n[0]))
    throw UserError(arguments.where(), "Clipping: needs 0 <= near < far");
  scene.camera.nearClip = n[0];
  scene.camera.farClip = n[1];
}

void RibState::shutter(RibArguments &arguments) {
  auto n = arguments.numbers(2, "opening and closing time");
  scene.camera.shutterOpen = n[0];
  scene.camera.shutterClose = n[1];
}

void RibState::depthOfField(RibArguments &arguments) {
  scene.camera.lensRadius = 0;
  if (arguments.empty()) // a pinhole
    return;
  auto n = arguments.numbers(3, "f-stop, focal length and focal distance");
  if (!(n[0] > 0 && n[1] >= 0 && n[2] > 0))
    throw UserError(arguments.where(),
                    "DepthOfField: f-stop, focal length and focal distance must be positive");
  if (n[0] < 1e30 && n[2] < 1e30) {
    scene.camera.lensRadius = 0.5 * n[1] / n[0];
    scene.camera.focalDistance = n[2];
  }
}

void RibState::relativeDetail(RibArguments &arguments) {
  double factor = arguments.number("a factor");
  if (!(factor >= 0))
    throw UserError(arguments.where(), "RelativeDetail: the factor must not be negative");
  detailFactor = factor;
}

void RibState::colorSamples(RibArguments &arguments) {
  std::vector<double> toRgb = arguments.array("the matrix from samples to RGB");
  arguments.array("the matrix from RGB to samples");
  if (toRgb.empty() || toRgb.size() % 3 != 0)
    throw UserError(arguments.where(), "ColorSamples: three numbers are needed for each sample");
  colorToRgb = std::move(toRgb);
}

/// Groups that shaders or other parts ask for themselves, and those that steer how other kinds of
/// renderer reach the same picture.
bool RibState::isQuiet(std::string_view group) {
  static const std::set<std::string_view> groups = {
      "user",      "searchpath", "identifier",  "limits",   "bucket",
      "dice",      "cull",       "render",      "Render",   "grouping",
      "trimcurve", "stochastic", "derivatives", "ribparse", "displacementbound"};
  return groups.contains(group);
}

void RibState::option(RibArguments &arguments) {
  std::string group = arguments.string("a name");
  for (const Parameter &parameter : arguments.parameters()) {
    std::string name = group + ":" + parameter.name;
    scene.options.insert_or_assign(name, parameter);
    auto triple = [&] {
      if (parameter.numbers.size() != 3)
        throw UserError(parameter.where, "Option: \"" + parameter.name + "\" needs 3 numbers");
      return Vec3d(parameter.numbers[0], parameter.numbers[1], parameter.numbers[2]);
    };
    BackgroundDescription &background = scene.background;
    if (name == "trace:maxdepth" && parameter.numbers.size() == 1) {
      scene.maxDepth = unsigned(std::clamp(parameter.numbers[0], 0.0, 64.0));
    } else if (name == "searchpath:shader" && parameter.strings.size() == 1) {
      scene.shaderPath = parameter.strings[0];
    } else if (name == "searchpath:texture" && !parameter.strings.empty()) {
      // makePictures() reads it out of the options.
    } else if (name == "anysl:background") {
      background.zenith = background.horizon = background.ground = triple();
      background.visible = true;
    } else if (name == "anysl:zenith") {
      background.zenith = triple();
      background.visible = true;
    } else if (name == "anysl:horizon") {
      background.horizon = triple();
      background.visible = true;
    } else if (name == "anysl:ground") {
      background.ground = triple();
      background.visible = true;
    } else if (!setDepth(name, parameter) && !isQuiet(group)) {
      warnUnknown("option", name, parameter.where);
    }
  }
}
