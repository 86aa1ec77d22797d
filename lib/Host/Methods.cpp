//===-- lib/Host/Methods.cpp - methods of class shaders ---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A public method is a shader of kind ANYSL_METHOD, named `class.bump(tf3s)f`, whose last
// parameters are two output arrays, if they are not empty: the numbers of its arguments and, behind
// them, of its result, and the texts likewise. It shades the one point that it is called for, in
// the caller's batch.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include "lib/Host/Message.h"
#include <algorithm>
#include <cstring>
#include <string_view>

using namespace anysl::host;

namespace {

/// `bump(tf)f` in its parts.
struct Signature {
  std::string_view name;
  std::vector<ValuePlace> arguments;
  std::vector<ValuePlace> results; ///< a structure's members; none of what gives nothing
  bool isGood = false;

  explicit Signature(std::string_view text) {
    size_t open = text.find('('), close = text.rfind(')');
    if (open == text.npos || close == text.npos || close < open)
      return;
    name = text.substr(0, open);
    std::string_view letters = text.substr(open + 1, close - open - 1),
                     last = text.substr(close + 1);
    isGood = take(letters, arguments) && (last == "v" || (!last.empty() && take(last, results)));
  }

  uint32_t numbers() const { return end.number; }
  uint32_t texts() const { return end.text; }

private:
  /// The values of `tf3s` behind those before; false if that is none.
  bool take(std::string_view letters, std::vector<ValuePlace> &places) {
    while (!letters.empty()) {
      if (!takeShape(letters, end.shape) || end.shape.letter == 'v')
        return false;
      places.push_back(end);
      end = end.next();
    }
    return true;
  }

  ValuePlace end; ///< behind all values
};

/// A float may be handed over for a triple, which then has it three times, or for a matrix; an
/// array for one that has room for it. What a method gives may be cut off.
bool converts(const ValueShape &from, const ValueShape &to, bool isResult = false) {
  bool isFloat = from.letter == 'f' && (to.letter == 't' || to.letter == 'm');
  if (from.isArray != to.isArray || (from.letter != to.letter && !isFloat))
    return false;
  return !from.isArray || to.isResizable ||
         (from.isResizable ? isResult : from.length == to.length);
}

void convert(const AnyslMessage &source, const ValuePlace &from, AnyslMessage &target,
             const ValuePlace &to) {
  uint32_t count = std::min(elementsOf(source, from), to.shape.length);
  setElements(target, to, count);
  for (uint32_t i = 0; i < count; ++i) {
    AnyslCell cells[16];
    readElement(source, from, i, cells);
    if (from.shape.letter != to.shape.letter) // a float, three times or on the diagonal
      for (uint32_t c = to.shape.letter == 't' ? 3 : 16; c-- > 0;)
        cells[c].number = to.shape.letter == 't' || c % 5 == 0 ? cells[0].number : 0;
    writeElement(target, to, i, cells);
  }
}

bool fits(const Signature &call, const Signature &method) {
  bool good = method.isGood && call.name == method.name &&
              call.arguments.size() == method.arguments.size() &&
              (call.results.empty() || call.results.size() == method.results.size());
  for (size_t i = 0; good && i < call.arguments.size(); ++i)
    good = converts(call.arguments[i].shape, method.arguments[i].shape);
  for (size_t i = 0; good && i < call.results.size(); ++i)
    good = converts(method.results[i].shape, call.results[i].shape, true);
  return good;
}

bool isSame(const Signature &call, const Signature &method) {
  auto same = [](const ValuePlace &a, const ValuePlace &b) { return a.shape == b.shape; };
  return std::ranges::equal(call.arguments, method.arguments, same) &&
         std::ranges::equal(call.results, method.results, same);
}

std::string_view classOf(const AnyslShaderInfo &shader) {
  std::string_view name = shader.name;
  return shader.kind == ANYSL_METHOD ? name.substr(0, name.find('.')) : name;
}

Signature signatureOf(const AnyslShaderInfo &method) {
  return Signature(std::string_view(method.name).substr(classOf(method).size() + 1));
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
    Signature method = signatureOf(shader);
    if (!fits(call, method))
      continue;
    if (isSame(call, method))
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

/// Room for an array of a method's, at the one point that it shades: sixteen points for each
/// element, of which this one is first, because the code may read that far.
template <class Value>
class PointArray {
public:
  static constexpr size_t stride = 16;

  PointArray(uint32_t elements, uint32_t point)
      : buffer((elements + 1) * stride * sizeof(Value)), point(point) {}
  Value &operator[](uint32_t i) { return reinterpret_cast<Value *>(buffer.get())[i * stride]; }
  /// As AnyslShadeArgs::param_data has it: indexed by the point's number in the caller's batch.
  void *place() const {
    return reinterpret_cast<void *>(reinterpret_cast<uintptr_t>(buffer.get()) -
                                    point * sizeof(Value));
  }

private:
  AlignedBuffer buffer;
  uint32_t point;
};

/// Runs the method at one point; the message's numbers and texts are its arguments', and then what
/// it made of them.
template <class Real>
void shadeOne(const AnyslInstance &instance, const AnyslShaderInfo &method,
              const AnyslShadeArgs &caller, uint32_t point, AnyslMessage &message) {
  PointArray<Real> numbers(message.number_count, point);
  PointArray<const char *> texts(message.text_count, point);
  // An instance of one of the class's other shaders lacks the last parameters.
  std::vector<AnyslCell> cells(instance.cells);
  cells.resize(method.cell_count);
  std::vector<uint8_t> isSet(instance.isSet);
  isSet.resize(method.param_count);
  std::vector<void *> pointers(method.param_count);
  uint32_t last = method.param_count;
  if (message.text_count) {
    // Texts are read out of cells, and stored point by point.
    const AnyslParamInfo &param = method.params[--last];
    for (uint32_t i = 0; i < message.text_count; ++i)
      cells[param.first_cell + i].string = message.texts[i];
    pointers[last] = texts.place();
    isSet[last] = ANYSL_PARAM_ONLY_OUT;
  }
  if (message.number_count) {
    for (uint32_t i = 0; i < message.number_count; ++i)
      numbers[i] = Real(message.numbers[i]);
    pointers[--last] = numbers.place();
  }
  AnyslShadeArgs args = caller;
  args.params = cells.data();
  args.param_is_set = isSet.data();
  args.param_data = pointers.data();
  args.param_by_u = args.param_by_v = nullptr;
  args.data_stride = PointArray<Real>::stride;
  anysl_shader_entry(&method, 1)(&args, point, point + 1);
  for (uint32_t i = 0; i < message.number_count; ++i)
    message.numbers[i] = double(numbers[i]);
  for (uint32_t i = 0; i < message.text_count; ++i)
    message.texts[i] = texts[i] ? texts[i] : "";
}

/// `.name:shape`: sets the value to what answers for it.
template <class Answer>
bool readParam(AnyslMessage &message, const Answer &answer) {
  AnyslMessage asked = message;
  asked.what += 1;
  std::vector<ValuePlace> places = placesOf(asked);
  if (places.size() != 1)
    return false;
  const ValuePlace &place = places[0];
  std::string name(place.name);
  AnyslQuery query = {};
  query.kind = ANYSL_QUERY_lightsource; // which answers do not look at
  query.type = place.shape.type();
  query.array_length = !place.shape.isArray      ? 0
                       : place.shape.isResizable ? ANYSL_ANY_LENGTH
                                                 : place.shape.length;
  query.name = name.c_str();
  query.subject = "";
  uint32_t known = 0;
  for (AnyslCell value[16]; known < place.shape.length; ++known) {
    query.element = known;
    if (!answer(query, value))
      break;
    writeElement(message, place, known, value);
  }
  if (known)
    setElements(message, place, known);
  return known > 0;
}

bool callMethod(const AnyslInstance &instance, const AnyslShadeArgs &args, uint32_t point,
                AnyslMessage &message) {
  Signature call(message.what);
  if (!call.isGood || call.numbers() > message.number_count || call.texts() > message.text_count)
    return false;
  const AnyslShaderInfo *method = findMethod(instance, call);
  if (!method || !anysl_shader_entry(method, 1) ||
      !hasGlobals(*instance.library->info, *method, args))
    return false;
  Signature own = signatureOf(*method);
  if (method->param_count < uint32_t(own.numbers() > 0) + uint32_t(own.texts() > 0))
    return false;
  std::vector<double> numbers(own.numbers());
  std::vector<const char *> texts(own.texts(), "");
  AnyslMessage its = {sizeof(AnyslMessage), own.numbers(), own.texts(), 0, "",
                      numbers.data(),       texts.data()};
  for (size_t i = 0; i < call.arguments.size(); ++i)
    convert(message, call.arguments[i], its, own.arguments[i]);
  if (instance.library->info->real == ANYSL_REAL_DOUBLE)
    shadeOne<double>(instance, *method, args, point, its);
  else
    shadeOne<float>(instance, *method, args, point, its);
  // What was converted from one type to another has no way back.
  for (size_t i = 0; i < call.arguments.size(); ++i)
    if (call.arguments[i].shape.letter == own.arguments[i].shape.letter)
      convert(its, own.arguments[i], message, call.arguments[i]);
  for (size_t i = 0; i < call.results.size(); ++i)
    convert(its, own.results[i], message, call.results[i]);
  return true;
}

} // namespace

extern "C" {

int anysl_method_call(const AnyslInstance *instance, const AnyslShadeArgs *args, uint32_t point,
                      AnyslMessage *message) {
  if (!*message->what)
    return 1;
  bool done = false;
  guarded([&] {
    // What the other shader has computed is not known here, only its parameters.
    done = *message->what == '.'
               ? readParam(*message,
                           [&](const AnyslQuery &query, AnyslCell *value) {
                             return anysl_instance_answer(instance, nullptr, 0, &query, value);
                           })
               : callMethod(*instance, *args, point, *message);
    return ANYSL_OK;
  });
  return done;
}

int anysl_light_call(const AnyslShadeArgs *args, uint32_t point, const char *handle,
                     AnyslMessage *message) {
  const AnyslLight *end = args->lights + args->light_count;
  const AnyslLight *light = std::find_if(args->lights, end, [&](const AnyslLight &candidate) {
    return candidate.handle && !std::strcmp(candidate.handle, handle);
  });
  if (light == end)
    return 0;
  if (light->kind == ANYSL_LIGHT_SHADER)
    return light->shader && anysl_method_call(static_cast<const AnyslInstance *>(light->shader),
                                              args, point, message);
  if (*message->what != '.')
    return !*message->what;
  bool done = false;
  guarded([&] {
    done = readParam(*message, [&](const AnyslQuery &query, AnyslCell *value) {
      return standardLightValue(*light, query, value);
    });
    return ANYSL_OK;
  });
  return done;
}

} // extern "C"
