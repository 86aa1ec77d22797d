//===-- tools/anysl-render/Surface.cpp - what every kind of geometry offers -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Surface.h"

using namespace anysl::render;

SurfaceVariables::SurfaceVariables(std::vector<Variable> all) : list(std::move(all)) {
  for (size_t i = 0; i < list.size(); ++i) {
    auto matches = [&](const char *name, uint32_t components) {
      return list[i].name == name && list[i].components == components;
    };
    int index = int(i);
    if (matches("Cs", 3))
      color = index;
    else if (matches("Os", 3))
      opacity = index;
    else if (matches("st", 2))
      st = index;
    else if (matches("s", 1))
      s = index;
    else if (matches("t", 1))
      t = index;
  }
}
