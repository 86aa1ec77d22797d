//===-- runtimes/packet/packet.h - vectors of W points, in registers and in memory ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_PACKET_H
#define ANYSL_RUNTIMES_PACKET_H

namespace {

/// W reals in a register. In memory they are copied, because only a real's alignment is known
/// there.
template <int W>
using Lanes = float __attribute__((ext_vector_type(W)));

template <int W>
void store(float *to, Lanes<W> x) {
  __builtin_memcpy(to, &x, W * sizeof(float));
}

template <int W>
Lanes<W> load(const float *from) {
  Lanes<W> x;
  __builtin_memcpy(&x, from, W * sizeof(float));
  return x;
}

/// x[W] y[W] z[W], as services lay out vectors.
template <int W>
struct alignas(64) Packet {
  float component[3][W];

  Packet() = default;
  Packet(Lanes<W> x, Lanes<W> y, Lanes<W> z) {
    put(0, x);
    put(1, y);
    put(2, z);
  }
  void put(int c, Lanes<W> x) { store<W>(component[c], x); }
  Lanes<W> get(int c) const { return load<W>(component[c]); }
  float *data() { return component[0]; }
};

} // namespace

#endif // ANYSL_RUNTIMES_PACKET_H
