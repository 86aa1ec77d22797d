//===-- tools/anysl-render/Bindings.cpp - variables to shaders' parameters --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Bindings.h"
#include "lib/Rib/PrimitiveVariables.h"

#include <algorithm>

using namespace anysl::render;

namespace {

/// The first value of a variable, as the request that names the shader would give it.
Parameter firstValue(const Parameter &variable, const Shape &shape, const Shader &shader) {
  Parameter result = variable;
  const Declaration &declaration = *variable.declaration;
  size_t size = componentCount(declaration.type), each = std::max(1u, declaration.arrayLength);
  if (declaration.type == ValueType::String) {
    result.strings.resize(each);
    return result;
  }
  result.numbers.resize(size * each);
  if (declaration.type == ValueType::HPoint) {
    for (size_t i = 0; i < each; ++i)
      for (size_t k = 0; k < 3; ++k)
        result.numbers[3 * i + k] = variable.numbers[4 * i + k] / variable.numbers[4 * i + 3];
    result.numbers.resize(3 * each);
    result.declaration->type = ValueType::Point;
  }
  Matrix4 toShader = shape.objectToCamera * shader.space.fromCamera;
  Matrix4 fromShader = toShader.inverse();
  ValueType type = result.declaration->type;
  if (type != ValueType::Point && type != ValueType::Vector && type != ValueType::Normal)
    return result;
  for (size_t i = 0; i + 2 < result.numbers.size(); i += 3) {
    double *n = result.numbers.data() + i;
    Vec3d value(n[0], n[1], n[2]);
    value = type == ValueType::Point    ? toShader.point(value)
            : type == ValueType::Vector ? toShader.vector(value)
                                        : fromShader.normalByInverse(value);
    for (int k = 0; k < 3; ++k)
      n[k] = value[k];
  }
  return result;
}

} // namespace

ShapeBindings anysl::render::bind(const Shape &shape, const Shader &shader, Warnings &warnings) {
  ShapeBindings result;
  uint32_t index = 0;
  for (const Parameter &variable : shape.variables) {
    const Declaration &declaration = *variable.declaration;
    bool isText = declaration.type == ValueType::String;
    if (isPosition(variable.name))
      continue;
    uint32_t itsIndex = index;
    index += !isText; // surfaces keep numbers only
    const AnyslParamInfo *param = anysl_shader_param(shader.info, variable.name.c_str());
    if (!param)
      continue;
    auto refuse = [&](const std::string &why) {
      warnings.warnOnce(
          "binding " + variable.name + " of " + shader.use->name + why, variable.where,
          "\"" + variable.name + "\" does not reach shader \"" + shader.use->name + "\": " + why);
    };
    if (!fits(declaration.type, param->type)) {
      refuse(std::string("its parameter is a ") + anysl_type_name(param->type));
      continue;
    }
    if (declaration.arrayLength != param->array_length) {
      refuse("its parameter has another array length");
      continue;
    }
    bool perFace = declaration.storage == StorageClass::Uniform;
    size_t each = std::max(1u, declaration.arrayLength);
    size_t values = isText ? variable.strings.size() / each
                           : variable.numbers.size() / (each * componentCount(declaration.type));
    if (declaration.storage == StorageClass::Constant || (perFace && values == 1)) {
      result.constant.push_back(firstValue(variable, shape, shader));
    } else if (!isText && (param->flags & ANYSL_PARAM_VARYING) != 0) {
      uint32_t numbers = uint32_t(anysl_type_components(param->type) * each);
      result.varying.push_back({uint32_t(param - shader.info->params), itsIndex, numbers});
    } else {
      warnings.warnOnce("first of " + variable.name + " " + shader.use->name, variable.where,
                        "\"" + variable.name +
                            "\" has values that differ, but is uniform in shader \"" +
                            shader.use->name + "\": the first counts");
      result.constant.push_back(firstValue(variable, shape, shader));
    }
  }
  std::sort(result.varying.begin(), result.varying.end(),
            [](const Binding &a, const Binding &b) { return a.parameter < b.parameter; });
  return result;
}
