//===-- tools/verify-math/Inputs.cpp ----------------------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/verify-math/Inputs.h"

#include <bit>
#include <cmath>
#include <limits>

namespace anysl::verify {

namespace {

/// Random numbers that follow from a seed (Steele, Lea and Flood's SplitMix64).
struct Random {
  uint64_t state;
  uint64_t next() {
    uint64_t z = (state += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  double between(double low, double high) {
    return low + (high - low) * double(next() >> 11) * 0x1p-53;
  }
  double sign() { return next() & 1 ? 1 : -1; }
};

template <class T>
T bitPattern(Random &r) {
  if constexpr (sizeof(T) == 4)
    return std::bit_cast<float>(uint32_t(r.next()));
  else
    return std::bit_cast<double>(r.next());
}

template <class T>
T special(uint64_t which) {
  using L = std::numeric_limits<T>;
  const T values[] = {0,
                      1,
                      2,
                      3,
                      T(0.5),
                      T(2.5),
                      L::infinity(),
                      L::quiet_NaN(),
                      L::denorm_min(),
                      L::min(),
                      L::max(),
                      L::epsilon(),
                      1 + L::epsilon(),
                      1 - L::epsilon() / 2,
                      std::ldexp(T(1), L::digits) - 1,
                      std::ldexp(T(1), L::digits),
                      std::ldexp(T(1), L::digits - 1) + 1,
                      T(1e10),
                      T(1e-10),
                      T(1e30)};
  constexpr uint64_t count = std::size(values);
  T value = values[(which >> 1) % count];
  return which & 1 ? -value : value;
}

template <class T>
T wide(Random &r) {
  using L = std::numeric_limits<T>;
  int exponent = int(r.between(L::min_exponent - L::digits, L::max_exponent));
  return T(r.sign() * std::ldexp(r.between(1, 2), exponent));
}

template <class T>
Arguments<T> argumentsAt(const Function &f, uint64_t index) {
  using L = std::numeric_limits<T>;
  constexpr uint64_t specials = 40;
  if (index < specials * specials)
    return {special<T>(index / specials), special<T>(index % specials)};
  Random r{index * 0xd1342543de82ef95ull};
  auto core = [&](int i) { return T(r.between(f.low[i], f.high[i])); };
  switch (index & 7) {
  case 0:
  case 1:
    return {core(0), core(1)};
  case 2:
    return {bitPattern<T>(r), bitPattern<T>(r)};
  case 3:
    return {wide<T>(r), wide<T>(r)};
  case 4: { // small integers and quarters: exact results and ties
    T x = T(std::floor(r.between(-4096, 4096)));
    return {x / (r.next() & 1 ? 1 : 4), T(std::floor(r.between(-64, 64))) / (r.next() & 1 ? 1 : 4)};
  }
  case 5: { // nearly equal sides
    T x = wide<T>(r);
    return {x, T(x * (1 + r.sign() * std::ldexp(1.0, -int(r.between(0, L::digits)))))};
  }
  case 6: { // a power near overflow, underflow, or anywhere between
    T x = T(std::exp2(r.between(-20, 20)));
    double range = r.next() & 1 ? L::max_exponent : r.between(0, L::max_exponent + L::digits);
    return {x, T(r.sign() * range / std::log2(double(x)) * r.between(0.99, 1.01))};
  }
  default: { // near 1, to a large power
    T x = T(1 + r.sign() * std::ldexp(r.between(1, 2), -int(r.between(2, L::digits))));
    return {x, T(r.sign() * r.between(0, L::max_exponent) / std::log2(double(x)))};
  }
  }
}

} // namespace

float floatAt(uint64_t index) { return std::bit_cast<float>(uint32_t(index)); }
Arguments<float> pairAt(const Function &f, uint64_t index) { return argumentsAt<float>(f, index); }
Arguments<double> doublesAt(const Function &f, uint64_t index) {
  return argumentsAt<double>(f, index);
}

} // namespace anysl::verify
