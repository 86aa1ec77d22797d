//===-- anysl/hash.h - integers out of integers, evenly spread --------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Noise and random numbers are hashes: no table, so they widen without a gather, and no state
// besides a number per point, so a point's numbers do not depend on the others or on the width.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_HASH_H
#define ANYSL_HASH_H

#include <stdint.h>

namespace anysl {

/// A permutation of the 32-bit integers in which every bit of the operand changes about half of the
/// result's: xor with a shift and multiplication by an odd number in turn, with the multipliers and
/// shifts that Wellons found by search to have the least bias ("Prospecting for Hash Functions",
/// 2018).
inline uint32_t mixBits(uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

/// 2^32 over the golden ratio, made odd: multiples of it are spread as evenly as can be.
inline constexpr uint32_t goldenStep = 0x9e3779b9u;

} // namespace anysl

#endif // ANYSL_HASH_H
