//===-- tools/anysl-render/Triangulate.cpp - polygons to triangles ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Ear clipping: a corner whose triangle holds no other corner is cut off, until one triangle is
// left. Holes are joined to the outline by bridges first, the rightmost hole first, each from its
// rightmost corner to a corner that it sees (after Eberly, Triangulation by Ear Clipping, 2002).
// Quadratic in the number of corners, which is small.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Triangulate.h"

#include <algorithm>
#include <numeric>

using namespace anysl::render;

namespace {

struct Point2 {
  double x, y;
  friend bool operator==(const Point2 &, const Point2 &) = default;
};

/// Twice the area of a triangle, positive if it turns anticlockwise.
double area(Point2 a, Point2 b, Point2 c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

bool contains(Point2 a, Point2 b, Point2 c, Point2 p) {
  return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

class EarClipper {
public:
  EarClipper(std::span<const Vec3d> corners, std::span<const uint32_t> loopSizes);
  void run(std::vector<std::array<uint32_t, 3>> &triangles);

private:
  using Loop = std::vector<uint32_t>; ///< corners in order
  Point2 at(uint32_t corner) const { return points[corner]; }
  double loopArea(const Loop &loop) const;
  bool isConvex(const Loop &loop) const;
  void addHole(const Loop &hole);
  bool isEar(const Loop &loop, const std::vector<uint32_t> &next,
             const std::vector<uint32_t> &previous, uint32_t i) const;

  std::vector<Point2> points;
  Loop outline;
  std::vector<Loop> holes;
};

EarClipper::EarClipper(std::span<const Vec3d> corners, std::span<const uint32_t> loopSizes) {
  // Newell's normal, which any outline has; the plane's two axes are those that it has least of.
  Vec3d normal;
  for (size_t i = 0; i < loopSizes[0]; ++i) {
    Vec3d a = corners[i] - corners[0], b = corners[(i + 1) % loopSizes[0]] - corners[0];
    normal += cross(a, b);
  }
  Vec3d size(std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z));
  int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (normal[axis] < 0)
    std::swap(x, y);
  for (const Vec3d &corner : corners) {
    Vec3d p = corner - corners[0];
    points.push_back({p[x], p[y]});
  }

  uint32_t begin = 0;
  for (uint32_t count : loopSizes) {
    Loop loop(count);
    std::iota(loop.begin(), loop.end(), begin);
    begin += count;
    if (outline.empty()) {
      outline = std::move(loop);
      continue;
    }
    // A hole turns the other way.
    if (loopArea(loop) > 0)
      std::reverse(loop.begin(), loop.end());
    // Its rightmost corner first.
    std::rotate(loop.begin(),
                std::max_element(loop.begin(), loop.end(),
                                 [&](uint32_t a, uint32_t b) { return at(a).x < at(b).x; }),
                loop.end());
    holes.push_back(std::move(loop));
  }
  std::sort(holes.begin(), holes.end(), [&](const Loop &a, const Loop &b) {
    return at(a[0]).x != at(b[0]).x ? at(a[0]).x > at(b[0]).x : a[0] < b[0];
  });
}

double EarClipper::loopArea(const Loop &loop) const {
  double sum = 0;
  for (size_t i = 1; i + 1 < loop.size(); ++i)
    sum += area(at(loop[0]), at(loop[i]), at(loop[i + 1]));
  return sum;
}

bool EarClipper::isConvex(const Loop &loop) const {
  // No right turn, and no more than once round: seen from the first corner, all lie in order.
  size_t n = loop.size();
  for (size_t i = 0; i < n; ++i)
    if (!(area(at(loop[i]), at(loop[(i + 1) % n]), at(loop[(i + 2) % n])) >= 0))
      return false;
  for (size_t i = 1; i + 1 < n; ++i)
    if (!(area(at(loop[0]), at(loop[i]), at(loop[i + 1])) >= 0))
      return false;
  return true;
}

void EarClipper::addHole(const Loop &hole) {
  // Where the ray to the right from the hole's corner first leaves the outline.
  Point2 m = at(hole[0]);
  size_t n = outline.size(), best = n;
  double nearest = 0;
  for (size_t i = 0; i < n; ++i) {
    Point2 a = at(outline[i]), b = at(outline[(i + 1) % n]);
    // The outline turns anticlockwise, so that it is left upwards.
    if (!(a.y <= m.y && b.y >= m.y) || a.y == b.y)
      continue;
    double x = a.x + (b.x - a.x) * ((m.y - a.y) / (b.y - a.y));
    if (x >= m.x && (best == n || x < nearest)) {
      nearest = x;
      best = a.x > b.x ? i : (i + 1) % n;
    }
  }
  if (best == n)
    return;
  // Corners that stand between: the one nearest in angle to the ray is seen.
  Point2 hit{nearest, m.y}, p = at(outline[best]);
  if (!(p == hit)) {
    double least = std::fabs(p.y - m.y) / (p.x - m.x);
    bool below = p.y < m.y;
    for (size_t i = 0; i < n; ++i) {
      Point2 q = at(outline[i]);
      if (!(q.x > m.x) || q == p ||
          area(at(outline[(i + n - 1) % n]), q, at(outline[(i + 1) % n])) > 0)
        continue;
      if (!(below ? contains(m, p, hit, q) : contains(m, hit, p, q)))
        continue;
      double tangent = std::fabs(q.y - m.y) / (q.x - m.x);
      if (tangent < least || (tangent == least && q.x < at(outline[best]).x)) {
        least = tangent;
        best = i;
      }
    }
  }
  // A corner may be in the outline twice, where a bridge ends: the bridge has to leave the one in
  // whose wedge it lies.
  for (size_t i = 0; i < n; ++i) {
    Point2 q = at(outline[i]);
    if (!(q == at(outline[best])))
      continue;
    Point2 before = at(outline[(i + n - 1) % n]), after = at(outline[(i + 1) % n]);
    bool left = area(before, q, m) > 0, right = area(q, after, m) > 0;
    if (area(before, q, after) >= 0 ? left && right : left || right) {
      best = i;
      break;
    }
  }
  Loop joined(outline.begin(), outline.begin() + ptrdiff_t(best) + 1);
  joined.insert(joined.end(), hole.begin(), hole.end());
  joined.push_back(hole[0]);
  joined.insert(joined.end(), outline.begin() + ptrdiff_t(best), outline.end());
  outline = std::move(joined);
}

bool EarClipper::isEar(const Loop &loop, const std::vector<uint32_t> &next,
                       const std::vector<uint32_t> &previous, uint32_t i) const {
  Point2 a = at(loop[previous[i]]), b = at(loop[i]), c = at(loop[next[i]]);
  if (!(area(a, b, c) > 0))
    return false;
  for (uint32_t j = next[next[i]]; j != previous[i]; j = next[j]) {
    Point2 p = at(loop[j]);
    // Only corners that turn inwards can be the first to reach into the triangle.
    if (p == a || p == b || p == c || !contains(a, b, c, p))
      continue;
    if (area(at(loop[previous[j]]), p, at(loop[next[j]])) <= 0)
      return false;
  }
  return true;
}

void EarClipper::run(std::vector<std::array<uint32_t, 3>> &triangles) {
  if (holes.empty() && isConvex(outline)) {
    for (size_t i = 2; i < outline.size(); ++i)
      triangles.push_back({outline[0], outline[i - 1], outline[i]});
    return;
  }
  for (const Loop &hole : holes)
    if (hole.size() >= 3)
      addHole(hole);

  const Loop &loop = outline;
  uint32_t count = uint32_t(loop.size());
  std::vector<uint32_t> next(count), previous(count);
  for (uint32_t i = 0; i < count; ++i) {
    next[i] = (i + 1) % count;
    previous[i] = (i + count - 1) % count;
  }
  uint32_t i = 0, tried = 0;
  while (count > 2) {
    Point2 a = at(loop[previous[i]]), b = at(loop[i]), c = at(loop[next[i]]);
    // Nothing is lost with a corner on a straight line to where it came from, or twice the same.
    bool empty = area(a, b, c) == 0 && (a == b || b == c || a == c);
    // Where rounding or a crossing leaves no ear, some corner has to go.
    bool ear = !empty && (tried > count || isEar(loop, next, previous, i));
    if (!ear && !empty) {
      ++tried;
      i = next[i];
      continue;
    }
    if (ear)
      triangles.push_back({loop[previous[i]], loop[i], loop[next[i]]});
    next[previous[i]] = next[i];
    previous[next[i]] = previous[i];
    --count;
    tried = 0;
    // Skipping one keeps the triangles from becoming a fan of slivers.
    i = next[next[i]];
  }
}

} // namespace

void anysl::render::triangulate(std::span<const Vec3d> corners, std::span<const uint32_t> loopSizes,
                                std::vector<std::array<uint32_t, 3>> &triangles) {
  if (!loopSizes.empty() && loopSizes[0] >= 3)
    EarClipper(corners, loopSizes).run(triangles);
}
