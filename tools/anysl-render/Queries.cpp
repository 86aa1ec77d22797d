//===-- tools/anysl-render/Queries.cpp - what shaders ask for by name -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Options and attributes are answered from what the file has stated, known to this renderer or not,
// and from what the RenderMan Interface lists besides. Other shaders' parameters come from their
// instances.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Queries.h"
#include "lib/Textures/Answer.h"
#include "tools/anysl-render/Displacement.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string_view>

using namespace anysl::render;

namespace {

/// Answers with numbers: one is a float, several are an array.
int answerNumbers(const AnyslQuery &query, std::initializer_list<double> numbers,
                  AnyslCell *value) {
  AnyslCell cells[4] = {};
  AnyslCell *next = cells;
  for (double number : numbers)
    next++->number = number;
  uint32_t length = numbers.size() == 1 ? 0 : uint32_t(numbers.size());
  return anysl_answer(&query, ANYSL_FLOAT, length, cells, value);
}

int answerText(const AnyslQuery &query, const char *text, AnyslCell *value) {
  AnyslCell cell;
  cell.string = text;
  return anysl_answer(&query, ANYSL_STRING, 0, &cell, value);
}

uint32_t shaderType(ValueType type) {
  switch (type) {
  case ValueType::Float:
    return ANYSL_FLOAT;
  case ValueType::Color:
    return ANYSL_COLOR;
  case ValueType::Point:
    return ANYSL_POINT;
  case ValueType::Vector:
    return ANYSL_VECTOR;
  case ValueType::Normal:
    return ANYSL_NORMAL;
  case ValueType::Matrix:
    return ANYSL_MATRIX;
  case ValueType::String:
    return ANYSL_STRING;
  case ValueType::HPoint:
    break; // no shader has any
  }
  return 0;
}

/// The value of a variable of a surface at a hit.
int answerVariable(const Scene &scene, const Hit &hit, const Ray *ray, std::string_view name,
                   const AnyslQuery &query, AnyslCell *value) {
  const Geometry &geometry = scene.geometry();
  const std::vector<Variable> &list = geometry.variablesOf(hit).list;
  auto found = std::find_if(list.begin(), list.end(),
                            [&](const Variable &variable) { return variable.name == name; });
  if (found == list.end())
    return 0;
  SurfacePoint point;
  if (ray)
    geometry.evaluate(hit, ray->origin, ray->direction,
                      uint64_t(1) << ANYSL_u | uint64_t(1) << ANYSL_v, point);
  std::vector<float> numbers(found->components);
  geometry.variablesAt(hit, point).value(uint32_t(found - list.begin()), numbers.data());
  std::vector<AnyslCell> cells(found->components);
  for (size_t i = 0; i < cells.size(); ++i)
    cells[i].number = double(numbers[i]);
  uint32_t type = shaderType(found->type), components = anysl_type_components(type);
  if (!components)
    return 0;
  uint32_t length = found->components == components ? 0 : found->components / components;
  return anysl_answer(&query, type, length, cells.data(), value);
}

int answerText(const Scene &scene, const Hit &hit, std::string_view name, const AnyslQuery &query,
               AnyslCell *value) {
  const auto &texts = scene.geometry().variablesOf(hit).texts;
  auto found = std::find_if(texts.begin(), texts.end(),
                            [&](const TextVariable &variable) { return variable.name == name; });
  if (found == texts.end())
    return 0;
  std::vector<AnyslCell> cells(found->elements.size());
  for (size_t i = 0; i < cells.size(); ++i)
    cells[i].string = found->elements[i];
  return anysl_answer(&query, ANYSL_STRING, found->isArray ? uint32_t(cells.size()) : 0,
                      cells.data(), value);
}

/// A displacement shader runs where a surface is diced: its outputs are interpolated from there.
int answerDisplacement(const Scene &scene, const Hit &hit, const AnyslQuery &query,
                       AnyslCell *value) {
  const Shader *shader = scene.displacementOf(scene.geometry().shapeOf(hit));
  if (!shader)
    return 0;
  std::string name = std::string(displacementPrefix) + query.name;
  return answerVariable(scene, hit, nullptr, name, query, value) ||
         answerText(scene, hit, name, query, value) ||
         anysl_instance_answer(shader->instance.get(), nullptr, 0, &query, value);
}

/// A value of the file, by its declaration; without one, what is asked for decides.
int answerParameter(const AnyslQuery &query, const Parameter &parameter, AnyslCell *value) {
  bool isText = !parameter.strings.empty();
  size_t count = isText ? parameter.strings.size() : parameter.numbers.size();
  uint32_t type = isText                  ? uint32_t(ANYSL_STRING)
                  : parameter.declaration ? shaderType(parameter.declaration->type)
                  : count == 1            ? uint32_t(ANYSL_FLOAT)
                                          : query.type;
  uint32_t components = anysl_type_components(type);
  if (!components || count % components || count == 0)
    return 0;
  uint32_t length = parameter.declaration ? parameter.declaration->arrayLength : 0;
  if (length == 0 && count != components)
    length = uint32_t(count / components);
  if (count != components * (length ? length : 1))
    return 0;
  std::vector<AnyslCell> cells(count);
  for (size_t i = 0; i < count; ++i)
    if (isText)
      cells[i].string = parameter.strings[i].c_str();
    else
      cells[i].number = parameter.numbers[i];
  return anysl_answer(&query, type, length, cells.data(), value);
}

int answerFrom(const AnyslQuery &query, const ParameterMap &map, AnyslCell *value) {
  auto found = map.find(std::string_view(query.name));
  return found == map.end() ? 0 : answerParameter(query, found->second, value);
}

int answerOption(const Scene &scene, const AnyslQuery &query, AnyslCell *value) {
  const CameraDescription &camera = scene.description.camera;
  std::string_view name = query.name;
  double width = scene.camera.width(), height = scene.camera.height();
  if (name == "Format" || name == "DeviceResolution")
    return answerNumbers(query, {width, height, camera.pixelAspect}, value);
  if (name == "FrameAspectRatio")
    return answerNumbers(
        query, {camera.frameAspect > 0 ? camera.frameAspect : width * camera.pixelAspect / height},
        value);
  if (name == "CropWindow") {
    const auto &crop = camera.cropWindow;
    return answerNumbers(query, {crop[0], crop[1], crop[2], crop[3]}, value);
  }
  if (name == "Clipping")
    return answerNumbers(query, {camera.nearClip, camera.farClip}, value);
  if (name == "Shutter")
    return answerNumbers(query, {camera.shutterOpen, camera.shutterClose}, value);
  return answerFrom(query, scene.description.options, value);
}

int answerAttribute(const Appearance &appearance, const AnyslQuery &query, AnyslCell *value) {
  if (std::string_view(query.name) == "Sides")
    return answerNumbers(query, {double(appearance.sides)}, value);
  return appearance.attributes ? answerFrom(query, *appearance.attributes, value) : 0;
}

int answerRenderer(const AnyslQuery &query, AnyslCell *value) {
  std::string_view name = query.name;
  if (name == "renderer")
    return answerText(query, "AnySL", value);
  if (name == "versionstring")
    return answerText(query, ANYSL_VERSION, value);
  if (name != "version")
    return 0;
  double numbers[4] = {};
  std::sscanf(ANYSL_VERSION, "%lf.%lf.%lf", numbers, numbers + 1, numbers + 2);
  return answerNumbers(query, {numbers[0], numbers[1], numbers[2], 0}, value);
}

int answerRay(const RayPath &path, const AnyslQuery &query, AnyslCell *value) {
  std::string_view name = query.name;
  if (name == "depth")
    return answerNumbers(query, {double(path.depth)}, value);
  if (name == "speculardepth")
    return answerNumbers(query, {double(path.specular())}, value);
  if (name == "diffusedepth")
    return answerNumbers(query, {double(path.diffuse)}, value);
  if (name == "shadowdepth")
    return answerNumbers(query, {double(path.shadow())}, value);
  if (name != "type")
    return 0;
  static constexpr std::pair<RayKind, const char *> types[] = {{RayKind::Camera, "camera"},
                                                               {RayKind::Traced, "specular"},
                                                               {RayKind::Diffuse, "diffuse"},
                                                               {RayKind::Shadow, "transmission"}};
  for (const auto &[kind, type] : types)
    if (kind == path.kind)
      return answerText(query, type, value);
  return 0;
}

} // namespace

int anysl::render::serveQuery(const Shader &shader, const Asker &asker, const AnyslShadeArgs *args,
                              uint32_t point, const AnyslQuery &query, AnyslCell *value) {
  auto ask = [&](const Shader *other, const AnyslShadeArgs *its = nullptr) {
    return other ? anysl_instance_answer(other->instance.get(), its, point, &query, value) : 0;
  };
  if (query.kind == ANYSL_QUERY_option)
    return answerOption(*shader.scene, query, value);
  if (query.kind == ANYSL_QUERY_rendererinfo)
    return answerRenderer(query, value);
  if (query.kind == ANYSL_QUERY_textureinfo)
    return textures::answer(shader.scene->pictures(), const_cast<Shader *>(&shader), args, query,
                            value);
  if (!asker.group)
    return 0;
  const ShadingGroup &group = *asker.group;
  switch (query.kind) {
  case ANYSL_QUERY_surface:
    return ask(group.shader, asker.surface);
  case ANYSL_QUERY_displacement:
    return asker.hit ? answerDisplacement(*shader.scene, *asker.hit, query, value) : 0;
  case ANYSL_QUERY_atmosphere:
    return ask(group.atmosphere);
  case ANYSL_QUERY_incident:
    return ask(asker.volume);
  case ANYSL_QUERY_opposite:
    return ask(group.interior && group.interior != asker.volume ? group.interior : group.exterior);
  case ANYSL_QUERY_attribute:
    return answerAttribute(*group.appearance, query, value);
  case ANYSL_QUERY_rayinfo:
    return answerRay(asker.path, query, value);
  default:
    return 0;
  }
}

//===-- Co-shaders ----------------------------------------------------------//

namespace {

/// A shader says with its parameter __category what it belongs to.
bool belongsTo(const Shader &shader, const char *category) {
  const char *own = nullptr;
  return !*category ||
         (anysl_instance_get_strings(shader.instance.get(), "__category", &own, 1) == ANYSL_OK &&
          !std::strcmp(own, category));
}

} // namespace

int anysl::render::serveMethod(const Shader &shader, const Asker &asker, const AnyslShadeArgs *args,
                               uint32_t point, const char *handle, AnyslMessage &message) {
  if (asker.group && asker.group->appearance->coshaders) {
    const auto &all = *asker.group->appearance->coshaders;
    auto found = all.find(std::string_view(handle));
    const Shader *other = found == all.end() ? nullptr : shader.scene->shader(found->second);
    if (other)
      return anysl_method_call(other->instance.get(), args, point, &message);
  }
  return anysl_light_call(args, point, handle, &message);
}

const char *anysl::render::serveShaderName(const Shader &shader, const Asker &asker,
                                           const char *category, uint32_t index) {
  if (!asker.group || !asker.group->appearance->coshaders)
    return nullptr;
  for (const auto &[handle, number] : *asker.group->appearance->coshaders) {
    const Shader *other = shader.scene->shader(number);
    if (other && belongsTo(*other, category) && !index--)
      return handle.c_str();
  }
  return nullptr;
}

//===-- What a ray has met --------------------------------------------------//

namespace {

int answerMet(void *data, const AnyslQuery *query, AnyslCell *value) {
  const auto &met = *static_cast<const MetSurface *>(data);
  const Scene &scene = *met.scene;
  const Geometry &geometry = scene.geometry();
  switch (query->kind) {
  case ANYSL_QUERY_surface: {
    const Shader *shader = scene.group(geometry.groupOf(met.hit)).shader;
    return shader
               ? anysl_instance_answer(shader->instance.get(), met.surface, met.point, query, value)
               : 0;
  }
  case ANYSL_QUERY_displacement:
    return answerDisplacement(scene, met.hit, *query, value);
  case ANYSL_QUERY_attribute: {
    const Shape &shape = scene.description.shapes[geometry.shapeOf(met.hit)];
    return answerAttribute(scene.description.appearances[shape.appearance], *query, value);
  }
  case ANYSL_QUERY_PRIMITIVE:
    return answerVariable(scene, met.hit, &met.ray, query->name, *query, value);
  default:
    return 0;
  }
}

} // namespace

void anysl::render::answerValues(AnyslMessage &message, const MetSurface &met) {
  if (met.hit.isHit())
    anysl_message_answer(&message, answerMet, const_cast<MetSurface *>(&met));
}
