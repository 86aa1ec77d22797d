//===-- runtimes/real/operators/types.cpp - what the linker reads of a real ---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/runtime.h>

extern "C" {
#define STC_TYPE(id, name, components, meaning) anysl_##name anysl_type_##name;
#include <anysl/Types.def>

const AnyslReal anysl_real_format =
    sizeof(anysl_number) == sizeof(float) ? ANYSL_REAL_FLOAT : ANYSL_REAL_DOUBLE;
const bool anysl_real_has_derivatives = anysl::hasDerivatives<anysl_float>;
const bool anysl_real_is_scalar = anysl::isScalarOnly<anysl_float>;
}
