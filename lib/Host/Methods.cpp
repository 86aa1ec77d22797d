//===-- lib/Host/Methods.cpp - methods of class shaders ---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A public method is a shader of kind ANYSL_METHOD, named `class.bump(tf)f`, whose last parameter
// is an array of two matrices with the arguments' numbers. It shades the one point that it is
// called for, in the caller's batch.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include <string_view>

using namespace anysl::host;

namespace {

constexpr unsigned maxNumbers = 32;

unsigned countOf(char letter) {
  return letter == 'f' ? 1 : letter == 't' ? 3 : letter == 'm' ? 16 : 0;
}

/// `bump(tf)f` in its parts.
struct Signature {
  std::string_view name, arguments;
  char result = 'v';

  explicit Signature(std::string_view text) {
    size_t open = text.find('('), close = text.rfind(')');
    if (open == text.npos || close == text.npos || close < open || close + 1 >= text.size())
      return;
    name = text.substr(0, open);
    arguments = text.substr(open + 1, close - open - 1);
    result = text[close + 1];
  }

  /// Where the result's numbers lie: behind the arguments' if there is room.
  unsigned resultAt() const {
    unsigned at = 0;
    for (char letter : arguments)
      at += countOf(letter);
    return at + countOf(result) <= maxNumbers ? at : 0;
  }
};

/// A number may be handed over for a triple, which then has it three times, or for a matrix.
bool converts(char from, char to) {
  return from == to || (from == 'f' && (to == 't' || to == 'm'));
}

void convert(char from, const double *source, char to, double *target) {
  for (unsigned i = 0; i < countOf(to); ++i)
    target[i] = from == to ? source[i] : to == 'm' && i % 5 ? 0 : source[0];
}

bool fits(const Signature &call, const Signature &method) {
  bool good = call.name == method.name && call.arguments.size() == method.arguments.size() &&
              (call.result == 'v' || converts(method.result, call.result));
  for (size_t i = 0; good && i < call.arguments.size(); ++i)
    good = converts(call.arguments[i], method.arguments[i]);
  return good;
}

std::string_view classOf(const AnyslShaderInfo &shader) {
  std::string_view name = shader.name;
  return shader.kind == ANYSL_METHOD ? name.substr(0, name.find('.')) : name;
}

/// The method that a call means: the one with the very types if there is one, else one that they
/// convert to.
const AnyslShaderInfo *findMethod(const AnyslInstance &instance, const Signature &call) {
  const AnyslLibraryInfo &info = *instance.library->info;
  std::string_view className = classOf(*instance.shader);
  const AnyslShaderInfo *found = nullptr;
  for (uint32_t i = 0; i < info.shader_count; ++i) {
    const AnyslShaderInfo &shader = info.shaders[i];
    if (shader.kind != ANYSL_METHOD || classOf(shader) != className)
      continue;
    Signature method(std::string_view(shader.name).substr(className.size() + 1));
    if (!fits(call, method))
      continue;
    if (method.arguments == call.arguments && method.result == call.result)
      return &shader;
    found = found ? found : &shader;
  }
  return found;
}

/// Whether a caller's batch has all globals that a method names.
bool hasGlobals(const AnyslLibraryInfo &info, const AnyslShaderInfo &method,
                const AnyslShadeArgs &args) {
  if (info.layout == ANYSL_LAYOUT_AOS)
    return args.globals[0] != nullptr;
  uint64_t needed = method.globals_read | method.globals_written;
  uint32_t component = 0;
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
    for (uint32_t c = 0; c < anysl_global_components(global); ++c, ++component)
      if (needed >> global & 1 && !args.globals[component])
        return false;
  return true;
}

/// Runs the method at one point; `numbers` are its arguments', and then what it made of them.
template <class Real>
void shadeOne(const AnyslInstance &instance, const AnyslShaderInfo &method,
              const AnyslShadeArgs &caller, uint32_t point, double *numbers) {
  // Sixteen points for each number, of which this one is first: the code may read that far.
  bool isSoA = instance.library->info->layout == ANYSL_LAYOUT_SOA;
  constexpr size_t stride = 16;
  alignas(64) Real data[maxNumbers * stride] = {};
  size_t step = isSoA ? stride : 1;
  auto place = [&](unsigned i) { return isSoA ? i * step : (i / 16) * stride * 16 + i % 16; };
  for (unsigned i = 0; i < maxNumbers; ++i)
    data[place(i)] = Real(numbers[i]);
  // The arrays are indexed by the point's number in the caller's batch.
  auto base = reinterpret_cast<uintptr_t>(data) - point * (isSoA ? 1 : 16) * sizeof(Real);
  std::vector<void *> pointers(method.param_count);
  pointers.back() = reinterpret_cast<void *>(base);
  // An instance of one of the class's other shaders lacks the last parameter.
  std::vector<AnyslCell> cells(instance.cells);
  cells.resize(method.cell_count);
  std::vector<uint8_t> isSet(instance.isSet);
  isSet.resize(method.param_count);
  AnyslShadeArgs args = caller;
  args.params = cells.data();
  args.param_is_set = isSet.data();
  args.param_data = pointers.data();
  args.data_stride = stride;
  anysl_shader_entry(&method, 1)(&args, point, point + 1);
  for (unsigned i = 0; i < maxNumbers; ++i)
    numbers[i] = double(data[place(i)]);
}

bool readParam(const AnyslInstance &instance, const char *name, double *values) {
  const AnyslParamInfo *param = anysl_shader_param(instance.shader, name);
  if (!param || param->type == ANYSL_STRING || cellsOf(*param) > maxNumbers)
    return false;
  for (uint32_t i = 0; i < cellsOf(*param); ++i)
    values[i] = instance.cells[param->first_cell + i].number;
  return true;
}

bool callMethod(const AnyslInstance &instance, const AnyslShadeArgs &args, uint32_t point,
                const Signature &call, double *values) {
  const AnyslShaderInfo *method = findMethod(instance, call);
  if (!method || !anysl_shader_entry(method, 1) || !method->param_count ||
      !hasGlobals(*instance.library->info, *method, args))
    return false;
  Signature own(std::string_view(method->name).substr(classOf(*method).size() + 1));
  double numbers[maxNumbers] = {};
  const double *from = values;
  double *to = numbers;
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    if (to + countOf(own.arguments[i]) > numbers + maxNumbers)
      return false;
    convert(call.arguments[i], from, own.arguments[i], to);
    from += countOf(call.arguments[i]);
    to += countOf(own.arguments[i]);
  }
  if (instance.library->info->real == ANYSL_REAL_DOUBLE)
    shadeOne<double>(instance, *method, args, point, numbers);
  else
    shadeOne<float>(instance, *method, args, point, numbers);
  // What was converted has no way back.
  double *back = values;
  const double *made = numbers;
  for (size_t i = 0; i < call.arguments.size(); ++i) {
    if (call.arguments[i] == own.arguments[i])
      std::copy(made, made + countOf(own.arguments[i]), back);
    back += countOf(call.arguments[i]);
    made += countOf(own.arguments[i]);
  }
  if (call.result != 'v')
    convert(own.result, numbers + own.resultAt(), call.result, values + call.resultAt());
  return true;
}

} // namespace

extern "C" int anysl_method_call(const AnyslInstance *instance, const AnyslShadeArgs *args,
                                 uint32_t point, const char *method, double values[32]) {
  if (!*method)
    return 1;
  int done = 0;
  guarded([&] {
    done = *method == '.' ? readParam(*instance, method + 1, values)
                          : callMethod(*instance, *args, point, Signature(method), values);
    return ANYSL_OK;
  });
  return done;
}
