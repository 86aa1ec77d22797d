//===-- test/unit/runtimes/Batch.h - sixteen points for an interface runtime --------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_RUNTIMES_BATCH_H
#define ANYSL_TEST_RUNTIMES_BATCH_H

#include "Operators.h"
#include <cstring>
#include <functional>
#include <vector>

/// What the shader of the next batch does.
inline std::function<void(anysl_context *)> shader, defaults;

/// Sixteen points of a batch, whose globals and per-point parameters are set by name, whatever the
/// layout.
class Batch {
public:
  static constexpr uint32_t count = 16;

  Batch() {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc)                                     \
  first[ANYSL_##name] = ANYSL_COMPONENT_##name;                                                    \
  isUniform[ANYSL_##name] = std::strcmp(#storage, "uniform") == 0;
#include <anysl/Globals.def>
#ifdef ANYSL_TEST_AOS
    pointers = {reals.data()};
#else
    for (int c = 0; c < ANYSL_COMPONENT_COUNT; ++c)
      pointers.push_back(&reals[c * count]);
#endif
    services.struct_size = sizeof services;
    args.struct_size = sizeof args;
    args.count = count;
    args.globals = pointers.data();
    args.services = &services;
    args.data_stride = count;
    args.renderer = this;
    args.params = cells.data();
    args.param_is_set = isSet;
    args.param_data = data;
  }

  Real &global(int id, int component, uint32_t point) {
#ifdef ANYSL_TEST_AOS
    return reals[point * ANYSL_COMPONENT_COUNT + first[id] + component];
#else
    return reals[(first[id] + component) * count + (isUniform[id] ? 0 : point)];
#endif
  }

  /// Element `element`, component `component` of `components`, of a parameter given point by point.
  Real &varying(std::vector<Real> &values, int components, int element, int component,
                uint32_t point) {
#ifdef ANYSL_TEST_AOS
    return values[(element * count + point) * components + component];
#else
    return values[(element * components + component) * count + point];
#endif
  }

  void shade(uint32_t point, std::function<void(anysl_context *)> body) {
    shader = std::move(body);
    anysl_runtime_shade_point(&args, point);
  }

  std::vector<Real> reals = std::vector<Real>(ANYSL_COMPONENT_COUNT * count);
  std::vector<void *> pointers;
  std::vector<AnyslCell> cells = std::vector<AnyslCell>(64);
  uint8_t isSet[8] = {};
  void *data[8] = {};
  int first[ANYSL_GLOBAL_COUNT];
  bool isUniform[ANYSL_GLOBAL_COUNT];
  AnyslServices services = {};
  AnyslShadeArgs args = {};
};

#endif
