//===-- test/hard-cases/Subject.cpp - a shader whose every access is watched ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Subject.h"
#include <algorithm>
#include <cfenv>
#include <csetjmp>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>
#include <xmmintrin.h>

using namespace hardcases;

//===-- Guarded memory ------------------------------------------------------------------------===//

GuardedArray::GuardedArray(size_t bytes) {
  size_t page = size_t(sysconf(_SC_PAGESIZE)), inner = (bytes + page - 1) / page * page;
  size = inner + 2 * page;
  void *memory = mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    throw std::bad_alloc();
  pages = static_cast<char *>(memory);
  if (mprotect(pages + page, inner, PROT_READ | PROT_WRITE) != 0)
    throw std::bad_alloc();
  begin = pages + page + inner - bytes;
}

GuardedArray::~GuardedArray() { munmap(pages, size); }

//===-- Signals -------------------------------------------------------------------------------===//

namespace {

sigjmp_buf backToTest;
volatile sig_atomic_t isWatching = 0;

void onSignal(int signal) {
  if (!isWatching)
    _exit(128 + signal);
  isWatching = 0;
  siglongjmp(backToTest, signal);
}

struct Handlers {
  Handlers() {
    struct sigaction action = {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_NODEFER;
    for (int signal : {SIGFPE, SIGSEGV, SIGBUS, SIGILL})
      sigaction(signal, &action, nullptr);
  }
};

/// Rounding, flushing of denormals and traps, without the flags of what has happened.
unsigned controlBits() { return _mm_getcsr() & ~0x3fu; }

} // namespace

//===-- Shaders -------------------------------------------------------------------------------===//

Subject::Subject(AnyslLibrary *library, const std::string &name)
    : info(anysl_library_info(library)), shader(anysl_library_shader(library, name.c_str())) {
  static const Handlers handlers;
  if (!shader ||
      anysl_instance_create(library, name.c_str(), nullptr, nullptr, &instance) != ANYSL_OK)
    throw std::runtime_error(anysl_last_error());
  size_t real = info->real == ANYSL_REAL_DOUBLE ? sizeof(double) : sizeof(float);
  for (uint32_t i = 0; i < shader->param_count; ++i) {
    const AnyslParamInfo &param = shader->params[i];
    bool isOutput = param.flags & ANYSL_PARAM_OUTPUT;
    if (!(param.flags & ANYSL_PARAM_VARYING) || param.array_length || param.type == ANYSL_STRING)
      throw std::runtime_error(name + ": parameter '" + param.name + "' is not a varying number");
    isGiven.push_back(isOutput ? ANYSL_PARAM_ONLY_OUT : ANYSL_PARAM_GIVEN);
    uint32_t components = anysl_type_components(param.type);
    arrays.push_back(std::make_unique<GuardedArray>(components * capacity * real));
    params.push_back(arrays.back()->data());
    for (uint32_t c = 0; c < components; ++c)
      (isOutput ? outputPlaces : inputPlaces).push_back({i, c, components});
  }
  if (shader->param_count == 0 || std::strcmp(shader->params[0].name, "active") != 0)
    throw std::runtime_error(name + ": the first parameter has to be 'active'");
  inputCount = inputPlaces.size() - 1;
  outputCount = outputPlaces.size();

  // A point as a renderer would have it: on the plane z = 0, seen from above.
  std::vector<double> values;
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global) {
    double value[3] = {0, 0, 0};
    if (global == ANYSL_N || global == ANYSL_Ng)
      value[2] = 1;
    if (global == ANYSL_I)
      value[2] = -1;
    if (global == ANYSL_dPdu)
      value[0] = 1;
    if (global == ANYSL_dPdv)
      value[1] = 1;
    if (global == ANYSL_du || global == ANYSL_dv)
      value[0] = 0.0625;
    values.insert(values.end(), value, value + anysl_global_components(global));
  }
  bool isSoA = info->layout == ANYSL_LAYOUT_SOA;
  auto put = [&](void *memory, size_t index, double value) {
    if (info->real == ANYSL_REAL_DOUBLE)
      static_cast<double *>(memory)[index] = value;
    else
      static_cast<float *>(memory)[index] = float(value);
  };
  if (!isSoA)
    arrays.push_back(std::make_unique<GuardedArray>(values.size() * capacity * real));
  for (size_t c = 0; c < values.size(); ++c) {
    if (isSoA)
      arrays.push_back(std::make_unique<GuardedArray>(capacity * real));
    for (uint32_t p = 0; p < capacity; ++p)
      put(arrays.back()->data(), isSoA ? p : p * values.size() + c, values[c]);
    if (isSoA || c == 0)
      globals.push_back(arrays.back()->data());
  }

  anysl_instance_fill_args(instance, &args);
  args.count = capacity;
  args.globals = globals.data();
  args.param_data = params.data();
  args.param_is_set = isGiven.data();
  args.data_stride = capacity;
}

Subject::~Subject() { anysl_instance_free(instance); }

Format Subject::format() const { return {info->real == ANYSL_REAL_DOUBLE}; }

bool Subject::keepsFlags() const { return std::strcmp(info->math, "fast") != 0; }

size_t Subject::indexOf(const Place &place, uint32_t point) const {
  return info->layout == ANYSL_LAYOUT_SOA ? place.component * capacity + point
                                          : point * place.components + place.component;
}

void Subject::store(const Place &place, uint32_t point, double value) {
  if (info->real == ANYSL_REAL_DOUBLE)
    static_cast<double *>(params[place.param])[indexOf(place, point)] = value;
  else
    static_cast<float *>(params[place.param])[indexOf(place, point)] = float(value);
}

double Subject::load(const Place &place, uint32_t point) const {
  if (info->real == ANYSL_REAL_DOUBLE)
    return static_cast<double *>(params[place.param])[indexOf(place, point)];
  return double(static_cast<float *>(params[place.param])[indexOf(place, point)]);
}

void Subject::set(uint32_t point, bool active, const Numbers &values) {
  store(inputPlaces[0], point, active);
  for (size_t i = 0; i < inputCount; ++i)
    store(inputPlaces[i + 1], point, values[i]);
}

void Subject::get(uint32_t point, Numbers &values) const {
  values.resize(outputCount);
  for (size_t i = 0; i < outputCount; ++i)
    values[i] = load(outputPlaces[i], point);
}

void Subject::clearOutputs() {
  for (const Place &place : outputPlaces)
    for (uint32_t point = 0; point < capacity; ++point)
      store(place, point, -12345.5);
}

std::string Subject::shade(uint32_t width, uint32_t first, uint32_t last, bool traps) {
  AnyslShadeFunction entry = anysl_shader_entry(shader, width);
  if (!entry)
    return "there is no code for this width";
  if (int signal = sigsetjmp(backToTest, 1)) {
    fedisableexcept(FE_ALL_EXCEPT);
    return signal == SIGFPE ? "a floating-point trap" : std::string("signal ") + strsignal(signal);
  }
  feclearexcept(FE_ALL_EXCEPT);
  if (traps)
    feenableexcept(FE_INVALID | FE_DIVBYZERO);
  unsigned before = controlBits();
  isWatching = 1;
  entry(&args, first, last);
  isWatching = 0;
  bool isSame = controlBits() == before;
  fedisableexcept(FE_ALL_EXCEPT);
  return isSame ? "" : "a changed floating-point environment";
}
