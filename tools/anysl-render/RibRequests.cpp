//===-- tools/anysl-render/RibRequests.cpp - structure, options, attributes -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/RibState.h"

#include <algorithm>

using namespace anysl::render;

//===-- The table -----------------------------------------------------------//

std::span<const RibState::TableEntry> RibState::table() {
  static constexpr TableEntry entries[] = {
      {"AttributeBegin", &RibState::attributeBegin},
      {"AttributeEnd", &RibState::attributeEnd},
      {"TransformBegin", &RibState::transformBegin},
      {"TransformEnd", &RibState::transformEnd},
      {"FrameBegin", &RibState::frameBegin},
      {"FrameEnd", &RibState::frameEnd},
      {"WorldBegin", &RibState::worldBegin},
      {"WorldEnd", &RibState::worldEnd},
      {"Declare", &RibState::declare},

      {"Display", &RibState::display},
      {"Format", &RibState::format},
      {"Projection", &RibState::projection},
      {"PixelSamples", &RibState::pixelSamples},
      {"PixelFilter", &RibState::pixelFilter},
      {"Exposure", &RibState::exposure},
      {"ScreenWindow", &RibState::screenWindow},
      {"CropWindow", &RibState::cropWindow},
      {"FrameAspectRatio", &RibState::frameAspectRatio},
      {"Clipping", &RibState::clipping},
      {"Shutter", &RibState::shutter},
      {"Option", &RibState::option},

      {"Identity", &RibState::identity},
      {"Transform", &RibState::transform},
      {"ConcatTransform", &RibState::concatTransform},
      {"Translate", &RibState::translate},
      {"Rotate", &RibState::rotate},
      {"Scale", &RibState::scale},
      {"CoordinateSystem", &RibState::coordinateSystem},
      {"ScopedCoordinateSystem", &RibState::coordinateSystem},

      {"Color", &RibState::color},
      {"Opacity", &RibState::opacity},
      {"Surface", &RibState::surface},
      {"LightSource", &RibState::lightSource},
      {"Illuminate", &RibState::illuminate},
      {"Sides", &RibState::sides},
      {"Orientation", &RibState::orientation},
      {"ReverseOrientation", &RibState::reverseOrientation},
      {"TextureCoordinates", &RibState::textureCoordinates},
      {"Attribute", &RibState::attribute},

      {"Sphere", &RibState::sphere},
      {"Cone", &RibState::cone},
      {"Cylinder", &RibState::cylinder},
      {"Hyperboloid", &RibState::hyperboloid},
      {"Paraboloid", &RibState::paraboloid},
      {"Disk", &RibState::disk},
      {"Torus", &RibState::torus},
      {"Polygon", &RibState::polygon},
      {"PointsPolygons", &RibState::pointsPolygons},

      // These steer how other kinds of renderer reach the same picture.
      {"version", &RibState::ignored},
      {"ShadingRate", &RibState::ignored},
      {"ShadingInterpolation", &RibState::ignored},
      {"Hider", &RibState::ignored},
      {"Quantize", &RibState::ignored},
      {"PixelVariance", &RibState::ignored},
      {"Bound", &RibState::ignored},
      {"GeometricApproximation", &RibState::ignored},
      {"ErrorHandler", &RibState::ignored},
  };
  return entries;
}

void RibState::execute(const RibRequest &request) {
  for (const TableEntry &entry : table()) {
    if (request.name != entry.name)
      continue;
    RibArguments arguments(request, declarations);
    (this->*entry.handler)(arguments);
    if (!arguments.empty() && entry.handler != &RibState::ignored)
      throw UserError(request.arguments.back().where,
                      request.name + ": more arguments than expected");
    return;
  }
  warnings.warnOnce("request " + request.name, request.where,
                    "request " + request.name + " is not known and is passed over");
}

std::vector<SceneDescription> RibState::finish(const Location &end) {
  if (!blocks.empty()) {
    static const char *const names[] = {"FrameBegin", "WorldBegin", "AttributeBegin",
                                        "TransformBegin"};
    throw UserError(blocks.back().where,
                    std::string(names[size_t(blocks.back().kind)]) + " without its end");
  }
  if (finished.empty())
    throw UserError(end, "the file has no WorldBegin ... WorldEnd, so there is nothing to render");
  return std::move(finished);
}

void RibState::ignored(RibArguments &) {}

void RibState::warnUnknown(const char *what, const std::string &name, const Location &where) {
  warnings.warnOnce(std::string(what) + " " + name, where,
                    std::string(what) + " \"" + name + "\" is not known and has no effect");
}

//===-- Structure -----------------------------------------------------------//

void RibState::open(Block kind, const RibArguments &arguments) {
  blocks.push_back({kind, arguments.where()});
  savedStates.push_back(state);
}

void RibState::close(Block kind, const char *name, const RibArguments &arguments) {
  if (blocks.empty() || blocks.back().kind != kind)
    throw UserError(arguments.where(), std::string(name) + "End does not match the open block");
  blocks.pop_back();
  GraphicsState saved = std::move(savedStates.back());
  savedStates.pop_back();
  if (kind == Block::Transform)
    state.transform = saved.transform;
  else
    state = std::move(saved);
}

bool RibState::inWorld() const {
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const OpenBlock &block) { return block.kind == Block::World; });
}

void RibState::frameBegin(RibArguments &arguments) {
  arguments.number("the frame's number");
  if (inWorld())
    throw UserError(arguments.where(), "FrameBegin inside a world");
  open(Block::Frame, arguments);
  savedScenes.push_back(scene);
}

void RibState::frameEnd(RibArguments &arguments) {
  close(Block::Frame, "Frame", arguments);
  scene = std::move(savedScenes.back());
  savedScenes.pop_back();
}

void RibState::worldBegin(RibArguments &arguments) {
  if (inWorld())
    throw UserError(arguments.where(), "WorldBegin inside a world");
  Matrix4 test = state.transform;
  if (!test.invert())
    throw UserError(arguments.where(), "the camera's transformation has no inverse");
  open(Block::World, arguments);
  savedScenes.push_back(scene);
  scene.worldToCamera = state.transform;
}

void RibState::worldEnd(RibArguments &arguments) {
  close(Block::World, "World", arguments);
  if (scene.outputs.empty())
    scene.outputs.push_back({baseName + ".png", "file", false, false, arguments.where()});
  finished.push_back(std::move(scene));
  scene = std::move(savedScenes.back());
  savedScenes.pop_back();
}

void RibState::attributeBegin(RibArguments &arguments) { open(Block::Attribute, arguments); }
void RibState::attributeEnd(RibArguments &arguments) {
  close(Block::Attribute, "Attribute", arguments);
}
void RibState::transformBegin(RibArguments &arguments) { open(Block::Transform, arguments); }
void RibState::transformEnd(RibArguments &arguments) {
  close(Block::Transform, "Transform", arguments);
}

void RibState::declare(RibArguments &arguments) {
  std::string name = arguments.string("a name");
  std::string text = arguments.string("a declaration");
  declarations[name] = parseDeclaration(text, nullptr, arguments.where());
}

//===-- Options -------------------------------------------------------------//

void RibState::display(RibArguments &arguments) {
  OutputFile output;
  output.where = arguments.where();
  output.name = arguments.string("a file name");
  output.format = arguments.string("a type");
  output.alpha = arguments.string("a mode").find('a') != std::string::npos;
  ParameterList parameters = arguments.parameters();
  if (const Parameter *type = findParameter(parameters, "exrpixeltype"))
    output.half = !type->strings.empty() && type->strings[0] == "half";
  // As in the standard, "+name" adds an output and any other name starts the list anew.
  if (!output.name.empty() && output.name[0] == '+')
    output.name.erase(0, 1);
  else
    scene.outputs.clear();
  if (output.name.empty())
    throw UserError(arguments.where(), "Display: the file name is empty");
  scene.outputs.push_back(std::move(output));
}

void RibState::format(RibArguments &arguments) {
  auto n = arguments.numbers(3, "width, height and pixel aspect");
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
  else if (name == "orthographic")
    scene.camera.perspective = false;
  else
    throw UserError(arguments.where(),
                    "Projection: \"" + name + "\" is neither \"perspective\" nor \"orthographic\"");
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

void RibState::pixelFilter(RibArguments &arguments) {
  std::string name = arguments.string("a name");
  auto n = arguments.numbers(2, "widths in x and y");
  if (!(n[0] > 0 && n[1] > 0 && n[0] <= 64 && n[1] <= 64))
    throw UserError(arguments.where(), "PixelFilter: widths must lie between 0 and 64");
  scene.filterWidthX = n[0];
  scene.filterWidthY = n[1];
  if (name == "box")
    scene.filter = FilterKind::Box;
  else if (name == "triangle")
    scene.filter = FilterKind::Triangle;
  else {
    scene.filter = FilterKind::Gaussian;
    if (name != "gaussian")
      warnings.warn(arguments.where(),
                    "PixelFilter \"" + name + "\" is not known; \"gaussian\" is used");
  }
}

void RibState::exposure(RibArguments &arguments) {
  auto n = arguments.numbers(2, "gain and gamma");
  if (!(n[1] > 0))
    throw UserError(arguments.where(), "Exposure: gamma must be positive");
  scene.gain = n[0];
  scene.gamma = n[1];
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
  scene.camera.shutterOpen = arguments.numbers(2, "opening and closing time")[0];
}

void RibState::option(RibArguments &arguments) {
  std::string group = arguments.string("a name");
  for (const Parameter &parameter : arguments.parameters()) {
    std::string name = group + ":" + parameter.name;
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
    } else {
      warnUnknown("option", name, parameter.where);
    }
  }
}

//===-- Transformations -----------------------------------------------------//

void RibState::identity(RibArguments &) {
  state.transform = inWorld() ? scene.worldToCamera : Matrix4::identity();
}

void RibState::transform(RibArguments &arguments) {
  // Inside a world the current transformation leads to the world, whose own leads to the camera.
  Matrix4 matrix = arguments.matrix();
  state.transform = inWorld() ? matrix * scene.worldToCamera : matrix;
}

void RibState::concatTransform(RibArguments &arguments) { concatenate(arguments.matrix()); }
void RibState::translate(RibArguments &arguments) {
  concatenate(Matrix4::translation(arguments.triple("an offset")));
}
void RibState::rotate(RibArguments &arguments) {
  auto n = arguments.numbers(4, "an angle and an axis");
  concatenate(Matrix4::rotation(n[0], {n[1], n[2], n[3]}));
}
void RibState::scale(RibArguments &arguments) {
  concatenate(Matrix4::scaling(arguments.triple("factors")));
}
void RibState::coordinateSystem(RibArguments &arguments) {
  scene.spaces[arguments.string("a name")] = state.transform;
}

//===-- Attributes ----------------------------------------------------------//

void RibState::color(RibArguments &arguments) {
  state.appearance.color = arguments.triple("a colour");
}
void RibState::opacity(RibArguments &arguments) {
  state.appearance.opacity = arguments.triple("an opacity");
}

void RibState::surface(RibArguments &arguments) {
  ShaderUse use;
  use.where = arguments.where();
  use.name = arguments.string("a shader's name");
  use.parameters = arguments.parameters();
  use.shaderToCamera = state.transform;
  state.appearance.surface = int(scene.surfaces.size());
  scene.surfaces.push_back(std::move(use));
}

void RibState::lightSource(RibArguments &arguments) {
  if (!inWorld())
    throw UserError(arguments.where(), "LightSource: lights belong inside WorldBegin ... WorldEnd");
  LightUse light;
  light.where = arguments.where();
  light.name = arguments.string("a light's name");
  std::string handle = arguments.handle("a handle");
  light.parameters = arguments.parameters();
  light.lightToCamera = state.transform;
  light.castsShadow = state.lightShadows;
  uint32_t index = uint32_t(scene.lights.size());
  lightHandles[handle] = index;
  state.appearance.lights.push_back(index);
  scene.lights.push_back(std::move(light));
}

void RibState::illuminate(RibArguments &arguments) {
  std::string handle = arguments.handle("a light's handle");
  bool on = arguments.number("1 or 0") != 0;
  auto light = lightHandles.find(handle);
  if (light == lightHandles.end() || light->second >= scene.lights.size())
    throw UserError(arguments.where(), "Illuminate: there is no light " + handle);
  std::vector<uint32_t> &lights = state.appearance.lights;
  auto place = std::lower_bound(lights.begin(), lights.end(), light->second);
  bool there = place != lights.end() && *place == light->second;
  if (on && !there)
    lights.insert(place, light->second);
  else if (!on && there)
    lights.erase(place);
}

void RibState::sides(RibArguments &arguments) {
  double count = arguments.number("1 or 2");
  if (count != 1 && count != 2)
    throw UserError(arguments.where(), "Sides: must be 1 or 2");
  state.appearance.sides = int(count);
}

void RibState::orientation(RibArguments &arguments) {
  std::string name = arguments.string("an orientation");
  // Camera space is left-handed, and so is every space that a mirror-free matrix leads there.
  Vec3d x = state.transform.vector({1, 0, 0}), y = state.transform.vector({0, 1, 0});
  bool leftHanded = dot(cross(x, y), state.transform.vector({0, 0, 1})) > 0;
  if (name == "outside" || name == "inside")
    state.appearance.reverseOrientation = name == "inside";
  else if (name == "lh" || name == "rh")
    state.appearance.reverseOrientation = (name == "lh") != leftHanded;
  else
    throw UserError(arguments.where(),
                    "Orientation: \"" + name + "\" is none of outside, inside, lh, rh");
}

void RibState::reverseOrientation(RibArguments &) {
  state.appearance.reverseOrientation = !state.appearance.reverseOrientation;
}

void RibState::textureCoordinates(RibArguments &arguments) {
  auto n = arguments.numbers(8, "four pairs s t");
  std::copy(n.begin(), n.end(), state.appearance.textureCoordinates.begin());
}

void RibState::attribute(RibArguments &arguments) {
  std::string group = arguments.string("a name");
  for (const Parameter &parameter : arguments.parameters()) {
    std::string name = group + ":" + parameter.name;
    std::string text = parameter.strings.size() == 1 ? parameter.strings[0] : "";
    bool on = parameter.numbers.size() == 1 ? parameter.numbers[0] != 0 : text == "on";
    Visibility &visibility = state.appearance.visibility;
    if (name == "visibility:camera")
      visibility.camera = on;
    else if (name == "visibility:trace")
      visibility.trace = on;
    else if (name == "visibility:transmission" && (text == "transparent" || (text.empty() && !on)))
      visibility.transmission = Visibility::Transparent;
    else if (name == "visibility:transmission" && text == "opaque")
      visibility.transmission = Visibility::Opaque;
    else if (name == "visibility:transmission" && (text == "Os" || text.empty()))
      visibility.transmission = Visibility::ByOpacity;
    else if (name == "light:shadows")
      state.lightShadows = on;
    else if (group != "identifier")
      warnUnknown("attribute", name, parameter.where);
  }
}
