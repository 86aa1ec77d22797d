//===-- runtimes/real/operators/types.cpp - the variables from which the linker reads sizes ---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/runtime.h>

extern "C" {
#define STC_TYPE(id, name, components, meaning) anysl_##name anysl_type_##name;
#include <anysl/Types.def>
}
