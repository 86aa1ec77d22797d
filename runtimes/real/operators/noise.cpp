//===-- runtimes/real/operators/noise.cpp - gradient noise, periodic noise and cell noise -----===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Gradient noise after Perlin, "Improving Noise" (2002): a random gradient on each point of the
// integer lattice, and a quintic blend of what the corners of a cell give. Gradients come from a
// hash of the lattice point rather than a table of permutations. A colour or vector takes its three
// channels from different bits of one hash, so three cost little more than one; the first is the
// noise of type float.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/domain.h>
#include <anysl/hash.h>
#include <anysl/runtime.h>

using namespace anysl;

namespace {

//===-- Lattice -------------------------------------------------------------------------------===//

/// A lattice point's key is the sum of its coordinates times these, so a neighbour costs one
/// addition; it starts from `origin`, since 0 is a number that mixing does not change.
constexpr uint32_t origin = goldenStep;
constexpr uint32_t axisKey[4] = {0x8da6b343u, 0xd8163841u, 0xcb1ab31fu, 0x165667b1u};

// Structures are filled through a reference: <anysl/vec.h> says why.

/// The cell of an N-dimensional point: along each axis the keys of its two planes, and how far in
/// it lies.
template <int N>
struct Cell {
  uint32_t low[N], high[N];
  anysl_float fraction[N], blend[N];

  /// The quintic 6t^5 - 15t^4 + 10t^3, whose first and second derivatives vanish at both ends.
  void setFraction(int axis, const anysl_float &t) {
    fraction[axis] = t;
    blend[axis] = t * t * t * (t * (t * 6 - 15) + 10);
  }
};

template <int N>
struct Point {
  anysl_float coordinate[N];
};

template <int N>
void locate(Cell<N> &cell, const Point<N> &p) {
  repeat<N>([&](auto axis) {
    anysl_float floored = lowestFloor(p.coordinate[axis]);
    cell.low[axis] = latticeCell(floored) * axisKey[axis];
    cell.high[axis] = cell.low[axis] + axisKey[axis];
    cell.setFraction(axis, p.coordinate[axis] - floored);
  });
}

/// The same on a lattice that repeats. A period is floored; one below 1 (or NaN) counts as 1.
template <int N>
void locate(Cell<N> &cell, const Point<N> &p, const Point<N> &periods) {
  repeat<N>([&](auto axis) {
    anysl_float floored = lowestFloor(p.coordinate[axis]);
    anysl_float period = floorOf(periods.coordinate[axis]);
    period = select(period >= 1, period, anysl_float(1));
    anysl_float low = modulo(floored, period), high = low + 1;
    high = select(high >= period, anysl_float(0), high);
    cell.low[axis] = latticeCell(low) * axisKey[axis];
    cell.high[axis] = latticeCell(high) * axisKey[axis];
    cell.setFraction(axis, p.coordinate[axis] - floored);
  });
}

//===-- Gradients -----------------------------------------------------------------------------===//
// gradient(h, offset): the gradient that the low bits of h name, times the offset from its lattice
// point.

/// Slopes spread over [-2, 2).
anysl_float gradient(uint32_t h, const Point<1> &offset) {
  return offset.coordinate[0] * (signedUnitFromBits(h * goldenStep) * 2);
}

/// (±1, ±1/2) and (±1/2, ±1).
anysl_float gradient(uint32_t h, const Point<2> &offset) {
  const auto &[x, y] = offset.coordinate;
  bool isSteep = h & 4;
  anysl_float u = select(isSteep, y, x), v = select(isSteep, x, y);
  return negateIf(u, h) + negateIf(v, h >> 1) * anysl_float(0.5);
}

/// The middles of the twelve edges of a cube, four of them twice.
anysl_float gradient(uint32_t h, const Point<3> &offset) {
  const auto &[x, y, z] = offset.coordinate;
  uint32_t edge = h & 15;
  anysl_float u = select(edge < 8, x, y);
  anysl_float v = select(edge < 4, y, select((edge & 13) == 12, x, z));
  return negateIf(u, h) + negateIf(v, h >> 1);
}

/// The middles of the 32 edges of a hypercube: one coordinate 0, the others ±1.
anysl_float gradient(uint32_t h, const Point<4> &offset) {
  const auto &[x, y, z, w] = offset.coordinate;
  uint32_t zero = (h >> 3) & 3;
  anysl_float a = select(zero == 0, y, x);
  anysl_float b = select(zero <= 1, z, y);
  anysl_float c = select(zero == 3, z, w);
  return negateIf(a, h) + negateIf(b, h >> 1) + negateIf(c, h >> 2);
}

/// Half over the largest sum that any choice of gradients reaches: 1, 0.755585, 1.036354
/// and 1.536582 for one to four dimensions, and a little less to be safe from rounding. Noise is
/// then within [0, 1].
constexpr double noiseScale[5] = {0, 0.499999, 0.661737, 0.482460, 0.325397};

//===-- Blending ------------------------------------------------------------------------------===//

/// Noise of one or three channels, in [-sup, sup].
template <int Channels>
struct Values {
  anysl_float channel[Channels];
};

/// What the corners give whose position along axes Axes and above is chosen already: `key` is the
/// sum of the chosen planes' keys, and bit k of Corner says that the far plane of axis k was.
template <int Channels, int N, int Axes = N, int Corner = 0>
void blend(Values<Channels> &result, const Cell<N> &cell, uint32_t key = origin) {
  if constexpr (Axes == 0) {
    Point<N> offset;
    repeat<N>([&](auto axis) {
      constexpr int far = (Corner >> axis) & 1;
      offset.coordinate[axis] = far ? cell.fraction[axis] - 1 : cell.fraction[axis];
    });
    uint32_t h = mixBits(key);
    repeat<Channels>([&](auto k) { result.channel[k] = gradient(h >> (10 * k), offset); });
  } else {
    constexpr int axis = Axes - 1;
    Values<Channels> near, far;
    blend<Channels, N, axis, Corner>(near, cell, key + cell.low[axis]);
    blend<Channels, N, axis, Corner | (1 << axis)>(far, cell, key + cell.high[axis]);
    repeat<Channels>([&](auto k) {
      result.channel[k] = near.channel[k] + cell.blend[axis] * (far.channel[k] - near.channel[k]);
    });
  }
}

//===-- Results -------------------------------------------------------------------------------===//

constexpr int channelsOf(anysl_float *) { return 1; }
constexpr int channelsOf(anysl_color *) { return 3; }
constexpr int channelsOf(anysl_vector *) { return 3; }

void put(anysl_float *result, const Values<1> &v) { *result = v.channel[0]; }
void put(anysl_color *result, const Values<3> &v) {
  *result = {v.channel[0], v.channel[1], v.channel[2]};
}
void put(anysl_vector *result, const Values<3> &v) {
  *result = {v.channel[0], v.channel[1], v.channel[2]};
}

template <int Channels, int N>
void setBlended(Values<Channels> &values, const Cell<N> &cell) {
  blend(values, cell);
  repeat<Channels>([&](auto k) {
    values.channel[k] = values.channel[k] * anysl_float(noiseScale[N]) + anysl_float(0.5);
  });
}

//===-- Points of which bounds are known ------------------------------------------------------===//

/// Calls f for the part of p in each cell that it may be in, from the axis Axis on. Gives false if
/// along some axis there are more than two.
template <int Axis = 0, int N, typename F>
bool forEachPart(Point<N> &p, F &&f) {
  if constexpr (Axis == N) {
    f();
    return true;
  } else {
    auto whole = p.coordinate[Axis], cells = floorOf(whole);
    if (!(cells.high - cells.low <= 1))
      return false;
    p.coordinate[Axis] = within(whole, cells.low, cells.low + 1);
    bool areFew = forEachPart<Axis + 1>(p, f);
    if (cells.high > cells.low) {
      p.coordinate[Axis] = within(whole, cells.high, cells.high + 1);
      areFew = areFew && forEachPart<Axis + 1>(p, f);
    }
    p.coordinate[Axis] = whole;
    return areFew;
  }
}

/// Whether the lattice points about p are known on a lattice that repeats: its periods are, and no
/// integer on the way to them is rounded.
template <int N>
bool isLatticeKnown(const Point<N> &p, const Point<N> &periods) {
  bool known = true;
  repeat<N>([&](auto axis) {
    auto period = floorOf(periods.coordinate[axis]), x = absOf(p.coordinate[axis]);
    known = known && period.low == period.high && period.high < 0x1p22f && x.high < 0x1p22f;
  });
  return known;
}

/// Noise of p, which f(values, point) gives in one cell. Of a number with bounds, what it can be in
/// all cells, if the lattice's periods are known.
template <int Channels, int N, typename F>
void overCells(Values<Channels> &values, const Point<N> &p, F &&f,
               const Point<N> *periods = nullptr) {
  if constexpr (hasBounds<anysl_float>) {
    Values<Channels> all;
    bool isFirst = true;
    Point<N> part = p;
    bool isKnown = !periods || isLatticeKnown(p, *periods);
    bool areFew = isKnown && forEachPart(part, [&] {
                    f(values, part);
                    repeat<Channels>([&](auto k) {
                      auto &known = all.channel[k];
                      known = isFirst ? values.channel[k] : hull(known, values.channel[k]);
                    });
                    isFirst = false;
                  });
    repeat<Channels>([&](auto k) {
      using Known = decltype(all.channel[0] * 0);
      values.channel[k] = areFew ? within(all.channel[k], 0, 1) : Known(0.0f, 1.0f);
    });
  } else {
    f(values, p);
  }
}

//===-- Families ------------------------------------------------------------------------------===//

template <int N, typename Result>
void noise(Result *result, const Point<N> &p) {
  Values<channelsOf(static_cast<Result *>(nullptr))> values;
  overCells(values, p, [](auto &values, const Point<N> &p) {
    Cell<N> cell;
    locate(cell, p);
    setBlended(values, cell);
  });
  put(result, values);
}

template <int N, typename Result>
void periodicNoise(Result *result, const Point<N> &p, const Point<N> &periods) {
  Values<channelsOf(static_cast<Result *>(nullptr))> values;
  auto inCell = [&periods](auto &values, const Point<N> &p) {
    Cell<N> cell;
    locate(cell, p, periods);
    setBlended(values, cell);
  };
  overCells(values, p, inCell, &periods);
  put(result, values);
}

template <int N, typename Result>
void cellNoise(Result *result, const Point<N> &p) {
  constexpr int channels = channelsOf(static_cast<Result *>(nullptr));
  Values<channels> values;
  overCells(values, p, [](auto &values, const Point<N> &p) {
    uint32_t key = origin;
    repeat<N>(
        [&](auto axis) { key += latticeCell(lowestFloor(p.coordinate[axis])) * axisKey[axis]; });
    repeat<channels>(
        [&](auto k) { values.channel[k] = unitFromBits(mixBits(key + k * goldenStep)); });
  });
  put(result, values);
}

} // namespace

//===-- Operators -----------------------------------------------------------------------------===//

#define NOISE_OPERATORS(T)                                                                         \
  void anysl_noise_##T##_1(anysl_##T *result, const anysl_float *x) {                              \
    noise(result, Point<1>{{*x}});                                                                 \
  }                                                                                                \
  void anysl_noise_##T##_2(anysl_##T *result, const anysl_float *x, const anysl_float *y) {        \
    noise(result, Point<2>{{*x, *y}});                                                             \
  }                                                                                                \
  void anysl_noise_##T##_3(anysl_##T *result, const anysl_vector *p) {                             \
    noise(result, Point<3>{{p->x, p->y, p->z}});                                                   \
  }                                                                                                \
  void anysl_noise_##T##_4(anysl_##T *result, const anysl_vector *p, const anysl_float *t) {       \
    noise(result, Point<4>{{p->x, p->y, p->z, *t}});                                               \
  }                                                                                                \
  void anysl_cellnoise_##T##_1(anysl_##T *result, const anysl_float *x) {                          \
    cellNoise(result, Point<1>{{*x}});                                                             \
  }                                                                                                \
  void anysl_cellnoise_##T##_2(anysl_##T *result, const anysl_float *x, const anysl_float *y) {    \
    cellNoise(result, Point<2>{{*x, *y}});                                                         \
  }                                                                                                \
  void anysl_cellnoise_##T##_3(anysl_##T *result, const anysl_vector *p) {                         \
    cellNoise(result, Point<3>{{p->x, p->y, p->z}});                                               \
  }                                                                                                \
  void anysl_cellnoise_##T##_4(anysl_##T *result, const anysl_vector *p, const anysl_float *t) {   \
    cellNoise(result, Point<4>{{p->x, p->y, p->z, *t}});                                           \
  }                                                                                                \
  void anysl_pnoise_##T##_1(anysl_##T *result, const anysl_float *x, const anysl_float *px) {      \
    periodicNoise(result, Point<1>{{*x}}, Point<1>{{*px}});                                        \
  }                                                                                                \
  void anysl_pnoise_##T##_2(anysl_##T *result, const anysl_float *x, const anysl_float *y,         \
                            const anysl_float *px, const anysl_float *py) {                        \
    periodicNoise(result, Point<2>{{*x, *y}}, Point<2>{{*px, *py}});                               \
  }                                                                                                \
  void anysl_pnoise_##T##_3(anysl_##T *result, const anysl_vector *p, const anysl_vector *pp) {    \
    periodicNoise(result, Point<3>{{p->x, p->y, p->z}}, Point<3>{{pp->x, pp->y, pp->z}});          \
  }                                                                                                \
  void anysl_pnoise_##T##_4(anysl_##T *result, const anysl_vector *p, const anysl_float *t,        \
                            const anysl_vector *pp, const anysl_float *pt) {                       \
    periodicNoise(result, Point<4>{{p->x, p->y, p->z, *t}}, Point<4>{{pp->x, pp->y, pp->z, *pt}}); \
  }

NOISE_OPERATORS(float)
NOISE_OPERATORS(color)
NOISE_OPERATORS(vector)
