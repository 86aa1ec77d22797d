//===-- lib/Host/LightRun.cpp - one run of a light shader -------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/LightRun.h"
#include <algorithm>
#include <anysl/hash.h>

using namespace anysl::host;

namespace {

constexpr int firstComponents[] = {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) ANYSL_COMPONENT_##name,
#include <anysl/Globals.def>
};

constexpr int componentCounts[] = {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) components,
#include <anysl/Globals.def>
};

constexpr bool isUniform[] = {
#define uniform true
#define varying false
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) storage,
#include <anysl/Globals.def>
#undef uniform
#undef varying
};

/// An address as if the array began at point 0.
template <class Real>
void *fromPointZero(Real *array, uint32_t firstPoint, size_t realsPerPoint) {
  return reinterpret_cast<void *>(reinterpret_cast<uintptr_t>(array) -
                                  size_t(firstPoint) * realsPerPoint * sizeof(Real));
}

uint32_t lowestLane(uint32_t mask) { return uint32_t(__builtin_ctz(mask)); }

/// The shader's view of the surface's batch and of the light.
template <class Real>
class Run {
public:
  Run(const AnyslShadeArgs &surface, uint32_t lightIndex, const AnyslCell *cells, Answer &answer)
      : surface(surface), light(surface.lights[lightIndex]),
        instance(*static_cast<const AnyslInstance *>(light.shader)), cells(cells), answer(answer),
        soa(instance.library->info->layout == ANYSL_LAYOUT_SOA) {
    for (uint32_t lane = 0; lane < laneCount; ++lane) {
      uint32_t point = answer.base + lane;
      // The surface's numbers and those of other lights must not be the same.
      seeds[lane] = surface.seeds && point < surface.count ? surface.seeds[point] : point;
      seeds[lane] =
          anysl::mixBits(anysl::mixBits(seeds[lane]) + (lightIndex + 1) * anysl::goldenStep);
    }
  }

  void shade(uint32_t lanes) {
    AnyslShadeArgs args;
    anysl_instance_fill_args(&instance, &args);
    args.params = const_cast<AnyslCell *>(cells);
    args.count = answer.base + laneCount;
    args.batch = surface.batch;
    args.seeds = static_cast<const uint32_t *>(fromPointZero(seeds, answer.base, 1));
    placeGlobals(args);
    placeOutputs(args);
    for (uint32_t rest = lanes; rest;) {
      uint32_t begin = lowestLane(rest), end = begin + lowestLane(~(rest >> begin));
      entryFor(end - begin)(&args, answer.base + begin, answer.base + end);
      rest &= end < laneCount ? ~0u << end : 0;
    }
    readResults(lanes);
  }

private:
  static constexpr uint32_t slots = 2 * laneCount; // whole vectors may be loaded at the end

  Real *slotsOf(int component) { return soa ? data + component * slots : data + component; }
  size_t step() const { return soa ? 1 : ANYSL_COMPONENT_COUNT; }

  void put(int global, int component, const double *lanes) {
    Real *to = slotsOf(firstComponents[global] + component);
    for (uint32_t lane = 0; lane < laneCount; ++lane)
      to[lane * step()] = Real(lanes[lane]);
  }
  void put(int global, int component, double value) {
    double lanes[laneCount];
    std::fill_n(lanes, laneCount, value);
    put(global, component, lanes);
  }

  /// Copies a component of `source` in the surface's batch. Uniform globals have one value there
  /// where they lie as structures of arrays.
  template <class SurfaceReal>
  void copy(int global, int source, int component, uint32_t lanes) {
    bool fromSoa = surface.library->layout == ANYSL_LAYOUT_SOA;
    int at = firstComponents[source] + component;
    auto *from = static_cast<const SurfaceReal *>(surface.globals[fromSoa ? at : 0]);
    double values[laneCount] = {};
    for (uint32_t rest = lanes; rest; rest &= rest - 1) {
      size_t lane = lowestLane(rest), point = answer.base + lane;
      values[lane] = from[!fromSoa            ? point * ANYSL_COMPONENT_COUNT + at
                          : isUniform[global] ? 0
                                              : point];
    }
    if (isUniform[global]) // of the lanes that ask, which all have the same
      std::fill_n(values, laneCount, values[lowestLane(lanes)]);
    put(global, component, values);
  }

  void placeGlobals(AnyslShadeArgs &args) {
    uint64_t used = instance.shader->globals_read | instance.shader->globals_written;
    uint32_t lanes = lanesInBatch();
    for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global) {
      if (!(used >> global & 1))
        continue;
      for (int c = 0; c < componentCounts[global]; ++c)
        fill(global, c, lanes);
    }
    if (!soa) {
      pointers[0] = fromPointZero(data, answer.base, ANYSL_COMPONENT_COUNT);
    } else {
      for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
        for (int c = 0; c < componentCounts[global]; ++c) {
          int at = firstComponents[global] + c;
          pointers[at] = isUniform[global] ? static_cast<void *>(slotsOf(at))
                                           : fromPointZero(slotsOf(at), answer.base, 1);
        }
    }
    args.globals = pointers;
    args.globals_given = used;
  }

  uint32_t lanesInBatch() const {
    uint32_t points = std::min(surface.count - answer.base, laneCount);
    return points == laneCount ? 0xffffu : (1u << points) - 1;
  }

  void fill(int global, int c, uint32_t lanes) {
    switch (global) {
    case ANYSL_Ps:
      return put(global, c, answer.asked.P[c]);
    case ANYSL_Ns:
      return put(global, c, answer.asked.N[c]);
    case ANYSL_P:
      return put(global, c, double(light.from[c]));
    case ANYSL_N:
    case ANYSL_Ng:
      return put(global, c, double(light.direction[c]));
    case ANYSL_Ol:
      return put(global, c, 1.0);
    case ANYSL_L:
    case ANYSL_Cl:
    case ANYSL_Ci:
    case ANYSL_Oi:
    case ANYSL_dPdu: // the light's own, which are those of one place
    case ANYSL_dPdv:
    case ANYSL_dNdu:
    case ANYSL_dNdv:
    case ANYSL_dNgdu:
    case ANYSL_dNgdv:
      return put(global, c, 0.0);
    default:
      break;
    }
    int source = globalOfSurface(global);
    if (!surface.library || !(surface.globals_given >> source & 1))
      return put(global, c, global == ANYSL_ncomps ? 3.0 : global == ANYSL_alpha ? 1.0 : 0.0);
    if (surface.library->real == ANYSL_REAL_DOUBLE)
      copy<double>(global, source, c, lanes);
    else
      copy<float>(global, source, c, lanes);
  }

  /// Output parameters go to the answer, one after the other as their cells do.
  void placeOutputs(AnyslShadeArgs &args) {
    const AnyslShaderInfo &shader = *instance.shader;
    flags.resize(shader.param_count + 1);
    for (uint32_t i = 0; i < shader.param_count; ++i) {
      const AnyslParamInfo &param = shader.params[i];
      if (!isOutput(param))
        continue;
      if (!answer.outputs.get())
        answer.outputs = AlignedBuffer((size_t(shader.cell_count) + 1) * cellBytes);
      places.resize(shader.param_count);
      flags[i] = ANYSL_PARAM_ONLY_OUT;
      if (param.type == ANYSL_STRING)
        places[i] = fromPointZero(outputPlace<const char *>(answer, param), answer.base, 1);
      else
        places[i] = fromPointZero(outputPlace<Real>(answer, param), answer.base,
                                  soa ? 1 : anysl_type_components(param.type));
    }
    args.param_is_set = flags.data();
    args.param_data = places.empty() ? nullptr : places.data();
    args.data_stride = laneCount;
  }

  /// The narrowest code that takes so many points at once, else the widest.
  AnyslShadeFunction entryFor(uint32_t points) const {
    const AnyslShaderInfo &shader = *instance.shader;
    const AnyslEntryInfo *best = &shader.entries[0];
    for (uint32_t i = 1; i < shader.entry_count; ++i) {
      const AnyslEntryInfo &entry = shader.entries[i];
      bool better = best->width < points ? entry.width > best->width
                                         : entry.width >= points && entry.width < best->width;
      if (better)
        best = &entry;
    }
    return best->shade;
  }

  /// In the light L points away from it; illuminance looks the other way.
  void readResults(uint32_t lanes) {
    constexpr int globals[] = {ANYSL_L, ANYSL_Cl, ANYSL_Ol};
    for (uint32_t g = 0; g < 3; ++g)
      for (uint32_t c = 0; c < 3; ++c) {
        bool written = instance.shader->globals_written >> globals[g] & 1;
        const Real *from = slotsOf(firstComponents[globals[g]] + int(c));
        double *to = answer.result[3 * g + c];
        for (uint32_t rest = lanes; rest; rest &= rest - 1) {
          uint32_t lane = lowestLane(rest);
          double value = written ? double(from[lane * step()]) : g == 2 ? 1 : 0;
          to[lane] = g == 0 ? 0 - value : value;
        }
      }
  }

  const AnyslShadeArgs &surface;
  const AnyslLight &light;
  const AnyslInstance &instance;
  const AnyslCell *cells;
  Answer &answer;
  bool soa;
  uint32_t seeds[laneCount];
  std::vector<void *> places; ///< of output parameters
  std::vector<uint8_t> flags;
  void *pointers[ANYSL_COMPONENT_COUNT] = {};
  alignas(64) Real data[ANYSL_COMPONENT_COUNT * slots];
};

} // namespace

void anysl::host::answerLanes(const AnyslShadeArgs &surface, uint32_t light, const AnyslCell *cells,
                              uint32_t first, uint32_t lanes, const Question &question,
                              Answer &answer) {
  const auto &instance = *static_cast<const AnyslInstance *>(surface.lights[light].shader);
  uint32_t last = 31 - uint32_t(__builtin_clz(lanes));
  if (first < answer.base || first + last >= answer.base + laneCount) {
    answer.base = first;
    answer.known = 0;
  }
  uint32_t shift = first - answer.base, missing = 0;
  bool readsNormal = instance.shader->globals_read >> ANYSL_Ns & 1;
  for (uint32_t rest = lanes; rest; rest &= rest - 1) {
    uint32_t from = lowestLane(rest), to = from + shift;
    bool same = answer.known >> to & 1;
    for (int c = 0; c < 3; ++c) {
      same &= answer.asked.P[c][to] == question.P[c][from];
      same &= !readsNormal || answer.asked.N[c][to] == question.N[c][from];
    }
    if (same)
      continue;
    for (int c = 0; c < 3; ++c) {
      answer.asked.P[c][to] = question.P[c][from];
      answer.asked.N[c][to] = question.N[c][from];
    }
    missing |= 1u << to;
  }
  if (!missing)
    return;
  if (instance.library->info->real == ANYSL_REAL_DOUBLE)
    Run<double>(surface, light, cells, answer).shade(missing);
  else
    Run<float>(surface, light, cells, answer).shade(missing);
  answer.known |= missing;
}

void anysl::host::readOutput(const AnyslInstance &light, const Answer &answer,
                             const AnyslParamInfo &param, uint32_t lane, AnyslCell *cells) {
  const AnyslLibraryInfo &info = *light.library->info;
  uint32_t components = anysl_type_components(param.type), count = cellsOf(param);
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t element = i / components, c = i % components;
    size_t at = info.layout == ANYSL_LAYOUT_SOA ? i * laneCount + lane
                                                : (element * laneCount + lane) * components + c;
    if (param.type == ANYSL_STRING)
      cells[i].string = outputPlace<const char *>(answer, param)[at];
    else
      cells[i].number = info.real == ANYSL_REAL_DOUBLE ? outputPlace<double>(answer, param)[at]
                                                       : outputPlace<float>(answer, param)[at];
  }
}
