//===-- test/hard-cases/Kernels.cpp - hard cases of renderers ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Kernels.h"
#include "test/unit/render/TestScene.h"
#include "tools/anysl-render/Film.h"
#include "tools/anysl-render/Host.h"
#include "tools/anysl-render/Quadric.h"
#include "tools/anysl-render/Sampling.h"
#include <cstdio>
#include <random>

using namespace hardcases;
using namespace anysl::render;

//===-- Quadrics ------------------------------------------------------------------------------===//

namespace {

QuadricShape wholeShape(int kind) {
  QuadricShape shape;
  shape.kind = QuadricShape::Kind(kind);
  shape.radius = 1;
  shape.height = 1;
  shape.zmin = kind == QuadricShape::Sphere ? -1 : 0;
  shape.zmax = 1;
  shape.point1 = {0.5, 0.25, -0.5};
  shape.point2 = {1, -0.5, 0.75};
  return shape;
}

/// The coefficients of a (x² + y²) + b z² + c z + d = 0.
struct Surface {
  long double a = 1, b = 0, c = 0, d = 0;
};
Surface surfaceOf(int kind) {
  switch (kind) {
  case QuadricShape::Sphere:
    return {1, 1, 0, -1};
  case QuadricShape::Cone:
    return {1, -1, 2, -1};
  case QuadricShape::Paraboloid:
    return {1, 0, -1, 0};
  case QuadricShape::Hyperboloid: {
    // x² + y² at the height z of the swept line from (0.5, 0.25, -0.5) to (1, -0.5, 0.75).
    long double k2 = 0.25L + 0.5625L, k1 = 2 * (0.5L * 0.5L - 0.25L * 0.75L), k0 = 0.3125L,
                z1 = -0.5L, dz = 1.25L;
    return {1, -k2 / (dz * dz), 2 * k2 * z1 / (dz * dz) - k1 / dz,
            -k2 * z1 * z1 / (dz * dz) + k1 * z1 / dz - k0};
  }
  default: // a cylinder
    return {1, 0, 0, -1};
  }
}

} // namespace

void hardcases::quadric(const double *in, double *out) {
  Quadric shape(wholeShape(int(in[6])), Matrix4::identity(), Appearance());
  float rays[7] = {float(in[0]), float(in[1]), float(in[2]), 0,
                   float(in[3]), float(in[4]), float(in[5])};
  double first, second;
  shape.roots(rays, 1, 1, &first, &second);
  bool isHit = std::isfinite(first);
  out[0] = isHit ? double(float(first)) : -1; // as a ray keeps it
  out[1] = isHit ? double(float(second)) : -1;
}

Inputs hardcases::farRays(bool allKinds) {
  Inputs result;
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-1.2, 1.2);
  for (int kind : {QuadricShape::Sphere, QuadricShape::Cylinder, QuadricShape::Cone,
                   QuadricShape::Paraboloid, QuadricShape::Hyperboloid})
    for (double distance : {10.0, 1e3, 1e4, 1e5})
      for (int i = 0; i < 40 && (allKinds || kind == QuadricShape::Sphere); ++i) {
        Vec3d away = normalized({normal(generator), normal(generator), normal(generator)});
        Vec3d target(uniform(generator), uniform(generator), uniform(generator));
        Vec3f origin(target + away * distance), direction(normalized(Vec3d() - away));
        result.push_back(
            {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, double(kind)});
      }
  return result;
}

long double hardcases::judgeQuadric(const Example &e) {
  using L = long double;
  Surface s = surfaceOf(int(e.in[6]));
  L p[3], q[3], along = 0, square = 0, distance = 0;
  for (int k = 0; k < 3; ++k) {
    p[k] = e.in[k], q[k] = e.in[k + 3];
    along += p[k] * q[k], square += q[k] * q[k], distance += p[k] * p[k];
  }
  distance = std::sqrt(distance);
  L shift = -along / square;
  for (int k = 0; k < 3; ++k)
    p[k] += shift * q[k];
  L A = s.a * (q[0] * q[0] + q[1] * q[1]) + s.b * q[2] * q[2];
  L H = s.a * (p[0] * q[0] + p[1] * q[1]) + s.b * p[2] * q[2] + s.c * q[2] / 2;
  L C = s.a * (p[0] * p[0] + p[1] * p[1]) + s.b * p[2] * p[2] + s.c * p[2] + s.d;
  L D = H * H - A * C;
  // Too near to a tangent, or to a direction of the surface, for anyone to tell the side.
  if (std::fabs(D) < 1e-9L || std::fabs(A) < 1e-6L)
    return 0;
  if ((D > 0) != (e.out[1] != -1))
    return infinite;
  if (D < 0)
    return 0;
  L sum = H < 0 ? H - std::sqrt(D) : H + std::sqrt(D), t0 = -sum / A + shift, t1 = -C / sum + shift;
  // Unlike distances, those of a double cone lie far off on the other side.
  L unit = e.format.ulp(std::max(distance, std::max(std::fabs(t0), std::fabs(t1))));
  L error =
      std::max(std::fabs(e.out[0] - std::min(t0, t1)), std::fabs(e.out[1] - std::max(t0, t1)));
  return std::isnan(error) ? L(infinite) : error / unit;
}

//===-- Rays that leave a surface -------------------------------------------------------------===//

namespace {

std::string shapeOf(double size, bool facets) {
  char text[400];
  std::snprintf(text, sizeof text, "WorldBegin Translate %g %g %g ", 0.3 * size, -0.2 * size,
                4 * size);
  std::string rib = text;
  if (facets) {
    // An octahedron: convex, so that a ray outwards meets nothing.
    std::snprintf(text, sizeof text,
                  "Scale %g %g %g Rotate 20 1 2 3 PointsPolygons [3 3 3 3 3 3 3 3] [0 2 4 2 1 4 1 "
                  "3 4 3 0 4 2 0 5 1 2 5 3 1 5 0 3 5] "
                  "\"P\" [1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1] ",
                  size, size, size);
    rib += text;
  } else {
    std::snprintf(text, sizeof text, "Sphere %g %g %g 360 ", size, -size, size);
    rib += text;
  }
  return rib + "WorldEnd";
}

/// Follows rays from points that a camera sees; `isRobust` starts them as the renderer does, else
/// at a distance of 1e-4.
double falseHits(double size, bool facets, bool isRobust) {
  TestScene scene(shapeOf(size, facets));
  Arena arena;
  RayStarts starts(arena, 1);
  int tried = 0, met = 0;
  for (uint32_t i = 0; tried < 110000; ++i) {
    Ray ray;
    ray.direction = Vec3f(normalized(Vec3d(unitNumber(anysl::render::hash(i, 1)) * 0.6 - 0.22,
                                           unitNumber(anysl::render::hash(i, 2)) * 0.6 - 0.35, 1)));
    Hit hit = scene.shoot(ray);
    if (!hit.isHit())
      continue;
    SurfacePoint point;
    scene.geometry->evaluate(hit, ray.origin, ray.direction, 0, point);
    Vec3d out = point.frame.normal;
    if (dot(out, Vec3d(ray.direction)) > 0)
      out = Vec3d() - out;
    // Anywhere over the hemisphere, grazing directions as often as others; none that rounding takes
    // below the surface.
    Vec3d across = normalized(cross(out, std::fabs(out.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0)));
    double height = unitNumber(anysl::render::hash(i, 3)) * (1 - 1e-6) + 1e-6,
           turn = 6.283185307179586 * unitNumber(anysl::render::hash(i, 4));
    Vec3d direction =
        out * height + (across * std::cos(turn) + cross(out, across) * std::sin(turn)) *
                           std::sqrt(1 - height * height);
    starts.set(0, point);
    float P[3], R[3];
    for (int k = 0; k < 3; ++k)
      P[k] = float(point.frame.P[k]), R[k] = float(direction[k]);
    AskedRays asked;
    makeTraceRays(starts, 0, 1, P, R, asked);
    Ray next = asked.ray(0, 0);
    if (!isRobust) {
      next.origin = {P[0], P[1], P[2]};
      next.near = 1e-4f;
    }
    ++tried;
    met += scene.shoot(next, SpecularRays).isHit();
  }
  return double(met) / tried;
}

} // namespace

void hardcases::secondaryRays(const double *in, double *out) {
  out[0] = falseHits(in[0], in[1] != 0, true);
}
void hardcases::naiveSecondaryRays(const float *in, float *out) {
  out[0] = float(falseHits(in[0], in[1] != 0, false));
}
long double hardcases::judgeShare(const Example &e) { return e.out[0]; }

//===-- Cameras far from the origin -----------------------------------------------------------===//

void hardcases::farCamera(const double *in, double *out) {
  char rib[400];
  // In the world's coordinates, with the digits of a double.
  std::snprintf(rib, sizeof rib,
                "Translate %.17g %.17g %.17g WorldBegin Translate %.17g %.17g %.17g Sphere %.17g "
                "%.17g %.17g 360 WorldEnd",
                -in[0], -in[1], -in[2], in[0] + in[3], in[1] + in[4], in[2] + in[5], in[6], -in[6],
                in[6]);
  TestScene scene(rib);
  std::optional<SurfacePoint> point = scene.look(Vec3d(in[3], in[4], in[5]));
  for (int k = 0; k < 3; ++k)
    out[k] = point ? double(float(point->frame.P[k])) : notANumber;
}

long double hardcases::judgeFarCamera(const Example &e) {
  // How far from the sphere's surface, in units of the position relative to the eye.
  long double square = 0, distance = 0;
  for (int k = 0; k < 3; ++k) {
    long double d = e.out[k] - e.in[3 + k];
    square += d * d, distance += e.in[3 + k] * static_cast<long double>(e.in[3 + k]);
  }
  long double error = std::fabs(std::sqrt(square) - e.in[6]) / e.format.ulp(std::sqrt(distance));
  return std::isnan(error) ? static_cast<long double>(infinite) : error;
}

//===-- Pixels --------------------------------------------------------------------------------===//

void hardcases::pixelGamma(const double *in, double *out) {
  out[0] = double(encodeSRGB(float(in[0])));
  out[1] = double(encodeSRGB(float(in[1])));
}

bool hardcases::gammaHolds(const Example &e) {
  return e.out[0] >= 0 && e.out[1] <= 1 && e.out[0] <= e.out[1];
}
