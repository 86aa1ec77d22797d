//===-- lib/Host/Queries.cpp - answers to what shaders ask for by name ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Half.h"
#include "lib/Host/Internal.h"

#include <algorithm>
#include <cstring>

using namespace anysl::host;

namespace {

bool isTriple(uint32_t type) { return anysl_type_components(type) == 3; }

/// Whether a value of one type can be assigned to a variable of another.
bool converts(uint32_t from, uint32_t to) {
  return from == to || (isTriple(from) && isTriple(to)) ||
         (from == ANYSL_FLOAT && (isTriple(to) || to == ANYSL_MATRIX));
}

double numberIn(const AnyslLibraryInfo &library, const AnyslShadeArgs &args, uint32_t param,
                size_t at) {
  const void *array = args.param_data[param];
  if (library.reads_half && args.param_is_set[param] & ANYSL_PARAM_HALF)
    return static_cast<const Half *>(array)[at];
  return library.real == ANYSL_REAL_DOUBLE ? static_cast<const double *>(array)[at]
                                           : static_cast<const float *>(array)[at];
}

/// The value of an element, as far as it is needed: its parameter's array at a point, in a
/// library's own layout.
void readElement(const LoadedLibrary &library, const AnyslShadeArgs &args, uint32_t index,
                 uint32_t type, uint32_t element, uint32_t point, AnyslCell *value) {
  size_t components = anysl_type_components(type);
  bool isSoA = library.info->layout == ANYSL_LAYOUT_SOA;
  for (size_t c = 0; c < components; ++c) {
    size_t at = isSoA ? (element * components + c) * args.data_stride + point
                      : (element * args.data_stride + point) * components + c;
    if (type == ANYSL_STRING) {
      value->string = static_cast<const char *const *>(args.param_data[index])[at];
      return;
    }
    value[c].number = numberIn(*library.info, args, index, at);
  }
}

/// How long an array is: a parameter `a` of any length has another beside it, `a.length`.
uint32_t elementsOf(const AnyslInstance &instance, const AnyslParamInfo &param) {
  const AnyslParamInfo *length =
      anysl_shader_param(instance.shader, (std::string(param.name) + ".length").c_str());
  if (!length || length->type != ANYSL_FLOAT)
    return param.array_length;
  double count = instance.cells[length->first_cell].number;
  return count > 0 ? uint32_t(std::min(count, double(param.array_length))) : 0;
}

} // namespace

extern "C" {

int anysl_answer(const AnyslQuery *query, uint32_t type, uint32_t array_length,
                 const AnyslCell *cells, AnyslCell *value) {
  bool fits = query->array_length == ANYSL_ANY_LENGTH
                  ? array_length && query->element < array_length
                  : query->array_length == array_length;
  if (!fits || !converts(type, query->type))
    return 0;
  uint32_t have = anysl_type_components(type), want = anysl_type_components(query->type);
  cells += array_length ? size_t(query->element) * have : 0;
  if (have == want)
    std::copy_n(cells, want, value);
  else // a float, three times or on the diagonal
    for (uint32_t i = 0; i < want; ++i)
      value[i].number = want == 3 || i % 5 == 0 ? cells->number : 0;
  return 1;
}

double anysl_param_number(const AnyslShadeArgs *args, uint32_t param, size_t at) {
  return numberIn(*args->library, *args, param, at);
}

int anysl_instance_answer(const AnyslInstance *instance, const AnyslShadeArgs *args, uint32_t point,
                          const AnyslQuery *query, AnyslCell *value) {
  const AnyslShaderInfo &shader = *instance->shader;
  if (!std::strcmp(query->name, ANYSL_QUERY_SHADER_NAME)) {
    AnyslCell name;
    name.string = shader.name;
    return anysl_answer(query, ANYSL_STRING, 0, &name, value);
  }
  const AnyslParamInfo *param = anysl_shader_param(&shader, query->name);
  if (!param)
    return 0;
  auto index = uint32_t(param - shader.params);
  if (query->array_length == ANYSL_ANY_LENGTH && query->element >= elementsOf(*instance, *param))
    return 0;
  bool isInArray = args && args->param_data && args->param_data[index];
  if (!isInArray)
    return anysl_answer(query, param->type, param->array_length,
                        &instance->cells[param->first_cell], value);
  // Taken apart, so that one element of an array need not wait for all.
  AnyslQuery single = *query;
  if (query->array_length != param->array_length &&
      (query->array_length != ANYSL_ANY_LENGTH || !param->array_length))
    return 0;
  single.array_length = single.element = 0;
  AnyslCell found[16];
  readElement(*instance->library, *args, index, param->type, query->element, point, found);
  return anysl_answer(&single, param->type, 0, found, value);
}

} // extern "C"
