//===-- benchmarks/math/Peers.h - other people's functions at one width -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_BENCHMARKS_MATH_PEERS_H
#define ANYSL_BENCHMARKS_MATH_PEERS_H

#include "benchmarks/math/Contestants.h"

namespace anysl::bench {

struct Peer {
  const char *function, *library;
  Kernel kernel;
};

/// SLEEF, libmvec and OpenImageIO, 8 wide on AVX2 and 16 wide on AVX-512.
std::vector<Peer> peers8();
std::vector<Peer> peers16();

} // namespace anysl::bench

#endif // ANYSL_BENCHMARKS_MATH_PEERS_H
