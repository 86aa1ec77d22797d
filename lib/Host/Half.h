//===-- lib/Host/Half.h - 16-bit floating-point numbers -----------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_HOST_HALF_H
#define ANYSL_LIB_HOST_HALF_H

#include <bit>
#include <cstdint>

namespace anysl::host {

/// An IEEE 754 binary16 number.
struct Half {
  uint16_t bits;

  operator float() const { return std::bit_cast<_Float16>(bits); }
};

} // namespace anysl::host

#endif // ANYSL_LIB_HOST_HALF_H
