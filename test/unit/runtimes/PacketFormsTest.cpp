//===-- test/unit/runtimes/PacketFormsTest.cpp - wide forms of services -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/abi.h>
#include <catch2/catch.hpp>
#include <vector>

namespace {

template <int W>
using Lanes = float __attribute__((ext_vector_type(W)));
template <int W, typename Mask>
using WideRay = void(const AnyslShadeArgs *, uint32_t, Lanes<W>, Lanes<W>, Lanes<W>, Lanes<W>,
                     Lanes<W>, Lanes<W>, float *, float *, float *, Mask);
template <int W, typename Mask>
using WideDistance = Lanes<W>(const AnyslShadeArgs *, uint32_t, Lanes<W>, Lanes<W>, Lanes<W>,
                              Lanes<W>, Lanes<W>, Lanes<W>, Mask);

} // namespace

extern "C" {
WideRay<4, uint8_t> packet_trace_4, packet_transmission_4;
WideRay<8, uint8_t> packet_trace_8, packet_transmission_8;
WideRay<16, uint16_t> packet_trace_16, packet_transmission_16;
WideDistance<4, uint8_t> packet_trace_distance_4;
WideDistance<8, uint8_t> packet_trace_distance_8;
WideDistance<16, uint16_t> packet_trace_distance_16;
}

namespace {

constexpr uint32_t first = 32;

struct Asked {
  uint32_t first = 0, width = 0, mask = 0;
  int times = 0;
};
Asked asked;

/// Colours that tell the point, P and R apart.
void answerPacket(void *, const AnyslShadeArgs *, uint32_t firstPoint, uint32_t width,
                  uint32_t mask, const float *P, const float *R, float *color) {
  asked = {firstPoint, width, mask, asked.times + 1};
  for (uint32_t i = 0; i < width; ++i) {
    color[i] = float(firstPoint + i);
    color[width + i] = P[i] + 10 * P[width + i] + 100 * P[2 * width + i];
    color[2 * width + i] = R[i] + 10 * R[width + i] + 100 * R[2 * width + i];
  }
}

void answer(void *, const AnyslShadeArgs *, uint32_t point, const double P[3], const double R[3],
            double color[3]) {
  ++asked.times;
  color[0] = point, color[1] = P[0] + 10 * P[1] + 100 * P[2],
  color[2] = R[0] + 10 * R[1] + 100 * R[2];
}

template <int W>
struct Input {
  Lanes<W> component[6];
  Input() {
    for (int c = 0; c < 6; ++c)
      for (int i = 0; i < W; ++i)
        component[c][i] = float(c + 1 + i);
  }
  float expected(int channel, int lane) const {
    if (channel == 0)
      return float(first + lane);
    int c = channel == 1 ? 0 : 3;
    return component[c][lane] + 10 * component[c + 1][lane] + 100 * component[c + 2][lane];
  }
};

template <int W, typename Mask>
void check(WideRay<W, Mask> &trace, WideRay<W, Mask> &transmission,
           WideDistance<W, Mask> &distance) {
  const Mask masks[] = {Mask((1u << W) - 1), 1, Mask(0xa5a5 & ((1u << W) - 1)), 0};
  Input<W> in;
  const auto &c = in.component;
  for (bool hasPackets : {true, false})
    for (Mask mask : masks) {
      INFO("width " << W << " mask " << unsigned(mask) << " packets " << hasPackets);
      AnyslServices services = {};
      if (hasPackets)
        services.trace_packet = services.transmission_packet = answerPacket;
      else
        services.trace = services.transmission = answer;
      AnyslShadeArgs args = {};
      args.services = &services;
      for (auto *form : {&trace, &transmission}) {
        alignas(64) float memory[4][W + 1] = {};
        float *result[3] = {memory[1], memory[2], memory[3]}; // not aligned as vectors are
        asked = {};
        (*form)(&args, first, c[0], c[1], c[2], c[3], c[4], c[5], result[0], result[1], result[2],
                mask);
        for (int i = 0; i < W; ++i)
          if (mask & (1u << i))
            for (int channel = 0; channel < 3; ++channel)
              CHECK(result[channel][i] == in.expected(channel, i));
        CHECK(asked.times == (hasPackets ? 1 : __builtin_popcount(mask)));
        if (hasPackets) {
          CHECK(asked.first == first);
          CHECK(asked.width == W);
          CHECK(asked.mask == mask);
        }
      }
      if (hasPackets)
        services.trace_distance_packet = [](void *, const AnyslShadeArgs *, uint32_t,
                                            uint32_t width, uint32_t, const float *P,
                                            const float *R, float *result) {
          for (uint32_t i = 0; i < width; ++i)
            result[i] = P[width + i] * R[2 * width + i];
        };
      else
        services.trace_distance = [](void *, const AnyslShadeArgs *, uint32_t, const double P[3],
                                     const double R[3]) { return P[1] * R[2]; };
      Lanes<W> result = distance(&args, first, c[0], c[1], c[2], c[3], c[4], c[5], mask);
      for (int i = 0; i < W; ++i)
        if (mask & (1u << i))
          CHECK(result[i] == c[1][i] * c[5][i]);
    }
}

} // namespace

TEST_CASE("a wide form asks the renderer once, or point by point where it has no packets") {
  check<4>(packet_trace_4, packet_transmission_4, packet_trace_distance_4);
  check<8>(packet_trace_8, packet_transmission_8, packet_trace_distance_8);
  check<16>(packet_trace_16, packet_transmission_16, packet_trace_distance_16);
}
