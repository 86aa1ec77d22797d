//===-- lib/Host/Instance.cpp - a shader with values for its parameters -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include "lib/Host/Text.h"

#include <cstring>

using namespace anysl::host;

namespace {

// What a default could read of a point: nothing but zeros. Large enough for either layout and
// format.
alignas(64) double zeroPoints[16 * ANYSL_COMPONENT_COUNT];

/// Computes the defaults of all parameters that the host has not set; they may depend on those it
/// has.
void computeDefaults(AnyslInstance &instance) {
  if (!instance.shader->init)
    return;
  void *globals[ANYSL_COMPONENT_COUNT];
  for (void *&global : globals)
    global = zeroPoints;
  AnyslShadeArgs args;
  anysl_instance_fill_args(&instance, &args);
  args.count = 1;
  args.globals = globals;
  instance.shader->init(&args);
}

std::string describe(const AnyslParamInfo &param) {
  std::string text = anysl_type_name(param.type);
  if (param.array_length)
    text += "[" + std::to_string(param.array_length) + "]";
  return text;
}

/// The parameter of a name if it holds what the caller has: text or numbers.
AnyslStatus findTyped(const AnyslInstance &instance, const char *name, bool text,
                      const AnyslParamInfo *&param) {
  int index = findParam(*instance.library, *instance.shader, name);
  if (index < 0)
    return ANYSL_ERROR_NAME;
  param = &instance.shader->params[index];
  if ((param->type == ANYSL_STRING) != text)
    return fail(ANYSL_ERROR_TYPE, context(*instance.library, *instance.shader) + "parameter '" +
                                      name + "' is a " + describe(*param) + ", not " +
                                      (text ? "text" : "a number"));
  return ANYSL_OK;
}

AnyslStatus wrongCount(const AnyslInstance &instance, const AnyslParamInfo &param, size_t count) {
  uint32_t cells = cellsOf(param);
  return fail(ANYSL_ERROR_TYPE, context(*instance.library, *instance.shader) + "parameter '" +
                                    param.name + "' is a " + describe(param) + " and takes " +
                                    std::to_string(cells) + (cells == 1 ? " value" : " values") +
                                    ", not " + std::to_string(count));
}

/// A constant of the library may be set to what it is.
AnyslStatus checkFixed(const AnyslInstance &instance, const AnyslParamInfo &param, bool isSame) {
  if (isSame)
    return ANYSL_OK;
  return fail(ANYSL_ERROR_STATE, context(*instance.library, *instance.shader) + "parameter '" +
                                     param.name + "' was fixed when the library was linked");
}

/// Whether two numbers are the same to the library's real.
bool isSameNumber(const AnyslInstance &instance, double a, double b) {
  return instance.library->info->real == ANYSL_REAL_FLOAT ? float(a) == float(b) : a == b;
}

/// Where an array may have fewer elements than it has room for, the parameter that says how many.
const AnyslParamInfo *lengthParam(const AnyslInstance &instance, const AnyslParamInfo &param) {
  return param.array_length
             ? anysl_shader_param(instance.shader, (std::string(param.name) + ".length").c_str())
             : nullptr;
}

/// Whether so many values fit a parameter.
bool fitsCount(const AnyslInstance &instance, const AnyslParamInfo &param, size_t count) {
  return count == cellsOf(param) || (count < cellsOf(param) && lengthParam(instance, param) &&
                                     count % anysl_type_components(param.type) == 0);
}

/// Notes how many elements an array was given.
void setLength(AnyslInstance &instance, const AnyslParamInfo &param, size_t count) {
  if (const AnyslParamInfo *length = lengthParam(instance, param)) {
    instance.cells[length->first_cell].number = double(count / anysl_type_components(param.type));
    instance.isSet[length - instance.shader->params] = true;
  }
}

void markSet(AnyslInstance &instance, const AnyslParamInfo &param, bool set) {
  instance.isSet[&param - instance.shader->params] = set;
  computeDefaults(instance);
}

AnyslStatus setNumbers(AnyslInstance &instance, const char *name, const double *values,
                       size_t count) {
  const AnyslParamInfo *param;
  if (AnyslStatus status = findTyped(instance, name, false, param))
    return status;
  uint32_t cells = cellsOf(*param);
  bool spread = count == 1 && !param->array_length;
  if (!fitsCount(instance, *param, count) && !spread)
    return wrongCount(instance, *param, count);
  AnyslCell *cell = &instance.cells[param->first_cell];
  bool diagonal = spread && param->type == ANYSL_MATRIX;
  auto value = [&](uint32_t i) {
    return diagonal ? (i % 5 == 0 ? values[0] : 0) : spread ? values[0] : i < count ? values[i] : 0;
  };
  if (param->flags & ANYSL_PARAM_FIXED) {
    bool isSame = true;
    for (uint32_t i = 0; i < cells; ++i)
      isSame &= isSameNumber(instance, cell[i].number, value(i));
    return checkFixed(instance, *param, isSame);
  }
  for (uint32_t i = 0; i < cells; ++i)
    cell[i].number = value(i);
  setLength(instance, *param, count);
  markSet(instance, *param, true);
  return ANYSL_OK;
}

AnyslStatus setStrings(AnyslInstance &instance, const char *name, const char *const *values,
                       size_t count) {
  const AnyslParamInfo *param;
  if (AnyslStatus status = findTyped(instance, name, true, param))
    return status;
  if (!fitsCount(instance, *param, count))
    return wrongCount(instance, *param, count);
  if (param->flags & ANYSL_PARAM_FIXED) {
    bool isSame = true;
    for (size_t i = 0; i < count; ++i) {
      const char *text = instance.cells[param->first_cell + i].string;
      isSame &= !std::strcmp(text ? text : "", values[i]);
    }
    return checkFixed(instance, *param, isSame);
  }
  std::vector<std::unique_ptr<std::string>> copies;
  for (size_t i = 0; i < count; ++i)
    copies.push_back(std::make_unique<std::string>(values[i]));
  for (size_t i = 0; i < count; ++i) {
    instance.cells[param->first_cell + i].string = copies[i]->c_str();
    instance.texts[param->first_cell + i] = std::move(copies[i]);
  }
  for (size_t i = count; i < cellsOf(*param); ++i)
    instance.cells[param->first_cell + i].string = "";
  setLength(instance, *param, count);
  markSet(instance, *param, true);
  return ANYSL_OK;
}

/// A parameter starts as zeros and empty text; init() puts its default over that.
void clear(AnyslInstance &instance, const AnyslParamInfo &param) {
  for (uint32_t cell = param.first_cell, end = cell + cellsOf(param); cell < end; ++cell) {
    if (param.type == ANYSL_STRING)
      instance.cells[cell].string = "";
    else
      instance.cells[cell].number = 0;
    instance.texts[cell].reset();
  }
}

AnyslStatus create(const AnyslLibrary &library, const char *name, const AnyslServices *services,
                   void *renderer, AnyslInstance **result) {
  const AnyslShaderInfo *shader = anysl_library_shader(&library, name);
  if (!shader)
    return ANYSL_ERROR_NAME;
  if (library.loaded->inspectOnly)
    return fail(ANYSL_ERROR_STATE, library.loaded->path + ": opened for inspection only");
  if (services && services->struct_size != sizeof(AnyslServices))
    return fail(ANYSL_ERROR_VERSION,
                library.loaded->path +
                    ": the renderer's AnyslServices is of another version: its "
                    "struct_size is " +
                    std::to_string(services->struct_size) + ", not " +
                    std::to_string(sizeof(AnyslServices)));
  auto instance = std::make_unique<AnyslInstance>();
  instance->library = library.loaded;
  instance->shader = shader;
  instance->services = services ? *services : AnyslServices{};
  instance->services.struct_size = sizeof(AnyslServices);
  completeTextServices(instance->services);
  completeLightServices(instance->services);
  instance->renderer = renderer;
  instance->cells.resize(shader->cell_count);
  instance->isSet.resize(shader->param_count);
  instance->texts.resize(shader->cell_count);
  for (uint32_t i = 0; i < shader->param_count; ++i)
    clear(*instance, shader->params[i]);
  computeDefaults(*instance);
  *result = instance.release();
  return ANYSL_OK;
}

} // namespace

extern "C" {

AnyslStatus anysl_instance_create(AnyslLibrary *library, const char *shader,
                                  const AnyslServices *services, void *renderer,
                                  AnyslInstance **instance) {
  return guarded([&] { return create(*library, shader, services, renderer, instance); });
}

void anysl_instance_free(AnyslInstance *instance) { delete instance; }

const AnyslShaderInfo *anysl_instance_shader(const AnyslInstance *instance) {
  return instance->shader;
}

AnyslStatus anysl_instance_set_numbers(AnyslInstance *instance, const char *param,
                                       const double *values, size_t count) {
  return guarded([&] { return setNumbers(*instance, param, values, count); });
}

AnyslStatus anysl_instance_set_strings(AnyslInstance *instance, const char *param,
                                       const char *const *values, size_t count) {
  return guarded([&] { return setStrings(*instance, param, values, count); });
}

AnyslStatus anysl_instance_unset(AnyslInstance *instance, const char *param) {
  return guarded([&] {
    int index = findParam(*instance->library, *instance->shader, param);
    if (index < 0)
      return ANYSL_ERROR_NAME;
    clear(*instance, instance->shader->params[index]);
    if (const AnyslParamInfo *length = lengthParam(*instance, instance->shader->params[index]))
      instance->isSet[length - instance->shader->params] = false;
    markSet(*instance, instance->shader->params[index], false);
    return ANYSL_OK;
  });
}

AnyslStatus anysl_instance_get_numbers(const AnyslInstance *instance, const char *param,
                                       double *values, size_t count) {
  return guarded([&] {
    const AnyslParamInfo *found;
    if (AnyslStatus status = findTyped(*instance, param, false, found))
      return status;
    if (count != cellsOf(*found))
      return wrongCount(*instance, *found, count);
    for (size_t i = 0; i < count; ++i)
      values[i] = instance->cells[found->first_cell + i].number;
    return ANYSL_OK;
  });
}

AnyslStatus anysl_instance_get_strings(const AnyslInstance *instance, const char *param,
                                       const char **values, size_t count) {
  return guarded([&] {
    const AnyslParamInfo *found;
    if (AnyslStatus status = findTyped(*instance, param, true, found))
      return status;
    if (count != cellsOf(*found))
      return wrongCount(*instance, *found, count);
    for (size_t i = 0; i < count; ++i) {
      const char *text = instance->cells[found->first_cell + i].string;
      values[i] = text ? text : "";
    }
    return ANYSL_OK;
  });
}

void anysl_instance_fill_args(const AnyslInstance *instance, AnyslShadeArgs *args) {
  *args = AnyslShadeArgs{};
  args->struct_size = sizeof(AnyslShadeArgs);
  args->params = const_cast<AnyslCell *>(instance->cells.data());
  args->param_is_set = instance->isSet.data();
  args->services = &instance->services;
  args->renderer = instance->renderer;
  args->library = instance->library->info;
}

} // extern "C"
