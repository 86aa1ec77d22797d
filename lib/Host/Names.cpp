//===-- lib/Host/Names.cpp - names of types, shader kinds and globals -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Internal.h"
#include <cstring>
#include <iterator>

namespace {

struct TypeRow {
  const char *name;
  uint32_t components;
};
// Indexed by AnyslType, whose numbers are those of the table.
constexpr TypeRow types[] = {
    {"?", 0},
#define STC_TYPE(id, name, components, meaning) {#name, components},
#include <anysl/Types.def>
};
static_assert(std::size(types) == ANYSL_STRING + 1);

constexpr const char *kinds[] = {"?",      "surface", "displacement", "light",
                                 "volume", "imager",  "method"};
static_assert(std::size(kinds) == ANYSL_METHOD + 1);

enum Storage { varying, uniform };
enum GlobalType {
#define STC_TYPE(id, name, components, meaning) type_##name = id,
#include <anysl/Types.def>
};
struct GlobalRow {
  const char *name;
  uint32_t type;
  uint32_t components;
  Storage storage;
};
constexpr GlobalRow globals[] = {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc)                                     \
  {#name, type_##type, components, storage},
#include <anysl/Globals.def>
};
static_assert(std::size(globals) == ANYSL_GLOBAL_COUNT);

const GlobalRow *row(int global) {
  return global >= 0 && global < ANYSL_GLOBAL_COUNT ? &globals[global] : nullptr;
}

} // namespace

extern "C" {

const char *anysl_type_name(uint32_t type) {
  return types[type < std::size(types) ? type : 0].name;
}

uint32_t anysl_type_components(uint32_t type) {
  return types[type < std::size(types) ? type : 0].components;
}

const char *anysl_kind_name(uint32_t kind) { return kinds[kind < std::size(kinds) ? kind : 0]; }

const char *anysl_global_name(int global) { return row(global) ? row(global)->name : nullptr; }

int anysl_global_find(const char *name) {
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
    if (!std::strcmp(globals[global].name, name))
      return global;
  return -1;
}

uint32_t anysl_global_components(int global) { return row(global) ? row(global)->components : 0; }
uint32_t anysl_global_type(int global) { return row(global) ? row(global)->type : 0; }

int anysl_global_is_uniform(int global) {
  return row(global) && row(global)->storage == uniform ? 1 : 0;
}

} // extern "C"
