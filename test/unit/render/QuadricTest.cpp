//===-- test/unit/render/QuadricTest.cpp - exact quadrics
//--------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Quadric.h"
#include "tools/anysl-render/Sampling.h"

#include <catch2/catch.hpp>

using namespace anysl::render;

namespace {

/// A reproducible sequence of numbers in [0, 1).
class Numbers {
public:
  double next() { return unitNumber(hash(17, ++count)); }
  double between(double low, double high) { return low + (high - low) * next(); }

private:
  uint32_t count = 0;
};

/// The root nearest to the origin, NaN where a ray misses or the limits refuse.
double intersect(const Quadric &quadric, Vec3f o, Vec3f d) {
  float rays[] = {o.x, o.y, o.z, 0, d.x, d.y, d.z};
  double first, second;
  quadric.roots(rays, 1, 1, &first, &second);
  if (first > 0 && quadric.accepts(o, d, first))
    return first;
  return second > 0 && quadric.accepts(o, d, second) ? second : NAN;
}

QuadricShape shapeOf(QuadricShape::Kind kind) {
  QuadricShape shape;
  shape.kind = kind;
  shape.radius = 1.25;
  shape.zmin = kind == QuadricShape::Sphere ? -0.75 : 0.5;
  shape.zmax = 1;
  shape.height = 0.75;
  shape.point1 = {0.5, 0.25, -0.5};
  shape.point2 = {1, -0.5, 0.75};
  return shape;
}

const QuadricShape::Kind kinds[] = {QuadricShape::Sphere,     QuadricShape::Cone,
                                    QuadricShape::Cylinder,   QuadricShape::Hyperboloid,
                                    QuadricShape::Paraboloid, QuadricShape::Disk};

/// The position that the RenderMan Interface gives for (u, v), in object space.
Vec3d position(const QuadricShape &s, double u, double v) {
  const double pi = 3.14159265358979323846;
  double theta = u * s.thetaMax * pi / 180;
  auto swept = [&](double radius, double z) {
    return Vec3d(radius * std::cos(theta), radius * std::sin(theta), z);
  };
  double z = s.zmin + v * (s.zmax - s.zmin);
  switch (s.kind) {
  case QuadricShape::Sphere: {
    double low = std::asin(s.zmin / s.radius), high = std::asin(s.zmax / s.radius);
    double phi = low + v * (high - low);
    return swept(s.radius * std::cos(phi), s.radius * std::sin(phi));
  }
  case QuadricShape::Cone:
    return swept(s.radius * (1 - v), v * s.height);
  case QuadricShape::Cylinder:
    return swept(s.radius, z);
  case QuadricShape::Paraboloid:
    return swept(s.radius * std::sqrt(z / s.zmax), z);
  case QuadricShape::Disk:
    return swept(s.radius * (1 - v), s.height);
  case QuadricShape::Hyperboloid: {
    Vec3d p = lerp(s.point1, s.point2, v);
    return {p.x * std::cos(theta) - p.y * std::sin(theta),
            p.x * std::sin(theta) + p.y * std::cos(theta), p.z};
  }
  default:
    return {};
  }
}

} // namespace

TEST_CASE("a ray to a quadric's point hits it, with the parameters and derivatives of that point",
          "[quadric]") {
  for (auto kind : kinds)
    for (double sweep : {360.0, 200.0, -130.0}) {
      QuadricShape shape = shapeOf(kind);
      shape.thetaMax = sweep;
      Matrix4 place = Matrix4::scaling({1, 1.5, 0.75}) * Matrix4::rotation(40, {1, 2, 0}) *
                      Matrix4::translation({0.5, -0.25, 8});
      Quadric quadric(shape, place, Appearance());
      Numbers numbers;
      int hits = 0;
      for (int i = 0; i < 400; ++i) {
        INFO("kind " << int(kind) << " sweep " << sweep << " point " << i);
        double u = numbers.between(0.02, 0.98), v = numbers.between(0.02, 0.98);
        Vec3d target = place.point(position(shape, u, v));
        Vec3f direction = Vec3f(normalized(target));
        Vec3d across = place.vector(position(shape, u + 1e-6, v) - position(shape, u - 1e-6, v));
        Vec3d along = place.vector(position(shape, u, v + 1e-6) - position(shape, u, v - 1e-6));
        // Where the ray grazes the surface, the direction's own rounding moves the hit a long way.
        if (std::fabs(dot(normalized(cross(across, along)), Vec3d(direction))) < 0.05)
          continue;
        double t = intersect(quadric, Vec3f(), direction);
        REQUIRE(std::isfinite(t));
        REQUIRE(t <= length(target) * (1 + 1e-4)); // the point itself or one in front of it
        if (t < length(target) * (1 - 1e-4))
          continue;
        ++hits;
        SurfaceFrame frame = quadric.evaluate(Vec3f(), direction, t);
        CHECK(maxAbs(frame.P - target) < 2e-5); // the direction has been rounded
        CHECK(frame.u == Approx(u).margin(1e-4));
        CHECK(frame.v == Approx(v).margin(1e-4));
        // Central differences of the parametric form.
        const double h = 1e-6;
        Vec3d dPdu = place.vector(
            (position(shape, frame.u + h, frame.v) - position(shape, frame.u - h, frame.v)) *
            (0.5 / h));
        Vec3d dPdv = place.vector(
            (position(shape, frame.u, frame.v + h) - position(shape, frame.u, frame.v - h)) *
            (0.5 / h));
        CHECK(maxAbs(frame.dPdu - dPdu) < 1e-6 * (1 + maxAbs(dPdu)));
        CHECK(maxAbs(frame.dPdv - dPdv) < 1e-6 * (1 + maxAbs(dPdv)));
        // The normal points as dPdu x dPdv does (this placement mirrors nothing).
        Vec3d expected = normalized(cross(dPdu, dPdv));
        CHECK(maxAbs(normalized(frame.normal) - expected) < 1e-5);
      }
      CHECK(hits > 50);
    }
}

TEST_CASE("a sphere's normal points outwards, also in a mirrored space, and turns round when asked",
          "[quadric]") {
  QuadricShape shape;
  shape.zmin = -1;
  shape.zmax = 1;
  for (bool mirrored : {false, true})
    for (bool reversed : {false, true}) {
      Appearance appearance;
      appearance.reverseOrientation = reversed;
      Matrix4 place =
          Matrix4::scaling({mirrored ? -1.0 : 1.0, 1, 1}) * Matrix4::translation({0, 0, 5});
      Quadric quadric(shape, place, appearance);
      SurfaceFrame frame = quadric.evaluate({}, {0, 0, 1}, 4);
      CHECK(normalized(frame.normal).z == Approx(reversed ? 1 : -1));
    }
}

TEST_CASE("one-sided surfaces are hit from the side of their normal only", "[quadric]") {
  QuadricShape shape;
  shape.zmin = -1;
  shape.zmax = 1;
  Appearance appearance;
  appearance.sides = 1;
  Quadric outside(shape, Matrix4::translation({0, 0, 5}), appearance);
  CHECK(intersect(outside, {}, {0, 0, 1}) == Approx(4));
  appearance.reverseOrientation = true;
  Quadric inside(shape, Matrix4::translation({0, 0, 5}), appearance);
  CHECK(intersect(inside, {}, {0, 0, 1}) == Approx(6));
}

TEST_CASE("a far sphere is hit where it is, and nowhere else", "[quadric]") {
  QuadricShape shape;
  shape.zmin = -1;
  shape.zmax = 1;
  Numbers numbers;
  for (double distance : {1e1, 1e2, 1e3, 1e4, 1e5}) {
    double worst = 0;
    int wrong = 0, hits = 0;
    for (int i = 0; i < 20000; ++i) {
      Vec3d center(numbers.between(-1, 1), numbers.between(-1, 1), distance);
      Quadric quadric(shape, Matrix4::translation(center), Appearance());
      Vec3d aim = center + Vec3d(numbers.between(-1.2, 1.2), numbers.between(-1.2, 1.2), 0);
      Vec3f d = Vec3f(normalized(aim));
      double t = intersect(quadric, {}, d);
      // The same ray in extended precision, about the centre.
      long double dx = d.x, dy = d.y, dz = d.z, cx = center.x, cy = center.y, cz = center.z;
      long double a = dx * dx + dy * dy + dz * dz, along = (dx * cx + dy * cy + dz * cz) / a;
      long double px = along * dx - cx, py = along * dy - cy, pz = along * dz - cz;
      long double k = (1 - (px * px + py * py + pz * pz)) / a;
      // At the rim the answer hangs on the last bits of the reference itself.
      if (std::fabs(double(k)) < 1e-10)
        continue;
      if ((k > 0) != std::isfinite(t)) {
        ++wrong;
        continue;
      }
      if (k <= 0)
        continue;
      ++hits;
      double expected = double(along - std::sqrt(k));
      double ulp = std::nextafter(float(expected), 1e30f) - float(expected);
      worst = std::max(worst, std::fabs(double(float(t)) - expected) / ulp);
    }
    INFO("distance " << distance);
    CHECK(hits > 5000);
    CHECK(wrong == 0);
    CHECK(worst <= 1); // of the float that Embree keeps
  }
}

TEST_CASE("an evaluated hit lies on the surface to double precision", "[quadric]") {
  for (auto kind : kinds) {
    QuadricShape shape = shapeOf(kind);
    Quadric quadric(shape, Matrix4::translation({0, 0, 1000}), Appearance());
    Numbers numbers;
    double worst = 0;
    for (int i = 0; i < 500; ++i) {
      Vec3d target =
          position(shape, numbers.between(0.1, 0.9), numbers.between(0.1, 0.9)) + Vec3d(0, 0, 1000);
      Vec3f origin(Vec3f(target) + Vec3f(0.1f, 2, -3));
      Vec3f direction = Vec3f(normalized(target - Vec3d(origin)));
      double t = intersect(quadric, origin, direction);
      if (!std::isfinite(t))
        continue;
      SurfaceFrame frame = quadric.evaluate(origin, direction, float(t));
      Vec3d exact = position(shape, frame.u, frame.v) + Vec3d(0, 0, 1000);
      worst = std::max(worst, maxAbs(frame.P - exact));
    }
    INFO("kind " << int(kind));
    CHECK(worst < 1e-11);
  }
}

TEST_CASE("wide and single roots are the same numbers", "[quadric]") {
  Quadric quadric(shapeOf(QuadricShape::Hyperboloid), Matrix4::translation({0, 0, 4}),
                  Appearance());
  Numbers numbers;
  float rays[7 * 16];
  for (float &value : rays)
    value = float(numbers.between(-1, 1));
  double first[16], second[16];
  quadric.roots(rays, 16, 16, first, second);
  for (unsigned i = 0; i < 16; ++i) {
    float ray[7];
    for (int k = 0; k < 7; ++k)
      ray[k] = rays[k * 16 + i];
    double a, b;
    quadric.roots(ray, 1, 1, &a, &b);
    CHECK(((a == first[i] && b == second[i]) || (std::isnan(a) && std::isnan(first[i]))));
  }
}
