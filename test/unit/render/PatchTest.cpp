//===-- test/unit/render/PatchTest.cpp - patches, meshes and NURBS ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/render/TestScene.h"

#include "tools/anysl-render/Sampling.h"
#include "tools/anysl-render/Tessellate.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace anysl::render;

namespace {

std::string list(const std::vector<double> &numbers) {
  std::string text = "[";
  char buffer[40];
  for (double number : numbers) {
    std::snprintf(buffer, sizeof buffer, "%.17g ", number);
    text += buffer;
  }
  return text + "]";
}

Vec3d vector(const Mesh &mesh, size_t corner) {
  const float *n = mesh.normals.at(corner);
  return {n[0], n[1], n[2]};
}

/// The control values that make t^3, t^2, t and 1 combine with the weights c of a polynomial.
std::array<double, 4> controlValues(const Basis &basis, std::array<double, 4> c) {
  Matrix4 m;
  for (size_t i = 0; i < 16; ++i)
    m.m[i / 4][i % 4] = basis.m[i];
  Matrix4 inverse = m.inverse();
  std::array<double, 4> g{};
  for (size_t row = 0; row < 4; ++row)
    for (size_t k = 0; k < 4; ++k)
      g[row] += inverse.m[row][k] * c[k];
  return g;
}

/// A sphere as two quadratic rational directions: half a circle in v, a whole one in u.
std::string nurbsSphere() {
  const double h = std::sqrt(0.5);
  const double circle[9][3] = {{1, 0, 1},   {1, 1, h},  {0, 1, 1},  {-1, 1, h}, {-1, 0, 1},
                               {-1, -1, h}, {0, -1, 1}, {1, -1, h}, {1, 0, 1}};
  const double half[5][3] = {{0, -1, 1}, {1, -1, h}, {1, 0, 1}, {1, 1, h}, {0, 1, 1}};
  std::vector<double> points;
  for (const auto &[r, z, wv] : half)
    for (const auto &[x, y, wu] : circle) {
      double w = wu * wv;
      points.insert(points.end(), {x * r * w, y * r * w, z * w, w});
    }
  return "NuPatch 9 3 [0 0 0 1 1 2 2 3 3 4 4 4] 0 4 5 3 [0 0 0 1 1 2 2 2] 0 2 \"Pw\" " +
         list(points);
}

} // namespace

TEST_CASE("a bicubic patch is the same known surface in every basis", "[patch]") {
  // x = u, y = v, z = u^3 + 2 v^2 - u v.
  for (const char *name : {"bezier", "b-spline", "catmull-rom", "hermite", "power"}) {
    const Basis &basis = *findBasis(name);
    auto cube = controlValues(basis, {1, 0, 0, 0}), square = controlValues(basis, {0, 1, 0, 0}),
         line = controlValues(basis, {0, 0, 1, 0}), one = controlValues(basis, {0, 0, 0, 1});
    std::vector<double> points;
    for (size_t j = 0; j < 4; ++j)
      for (size_t i = 0; i < 4; ++i)
        points.insert(points.end(),
                      {line[i] * one[j], one[i] * line[j],
                       cube[i] * one[j] + 2 * one[i] * square[j] - line[i] * line[j]});
    for (bool byMatrix : {false, true}) {
      std::string b =
          byMatrix ? list({basis.m.begin(), basis.m.end()}) : "\"" + std::string(name) + "\"";
      std::string step = " " + std::to_string(basis.step) + " ";
      TestScene scene("Format 512 512 1 WorldBegin Translate 0 0 3 Basis " + b + step + b + step +
                      "Patch \"bicubic\" \"P\" " + list(points) + " WorldEnd");
      auto mesh = facets(scene);
      INFO(name);
      REQUIRE(mesh->parameters.size() > 100);
      double worst = 0, worstNormal = 0, worstTangent = 0;
      for (size_t t = 0; t < mesh->triangles.size(); ++t)
        for (size_t k = 0; k < 3; ++k) {
          size_t corner = mesh->corners[t][k];
          double u = mesh->parameters[corner][0], v = mesh->parameters[corner][1];
          Vec3d p(u, v, 3 + u * u * u + 2 * v * v - u * v);
          worst = std::max(worst, maxAbs(Vec3d(mesh->points[mesh->triangles[t][k]]) - p));
          Vec3d du(1, 0, 3 * u * u - v), dv(0, 1, 4 * v - u);
          worstTangent = std::max({worstTangent, maxAbs(Vec3d(mesh->dPdu[corner]) - du),
                                   maxAbs(Vec3d(mesh->dPdv[corner]) - dv)});
          worstNormal =
              std::max(worstNormal, maxAbs(vector(*mesh, corner) - normalized(cross(du, dv))));
        }
      CHECK(worst < 2e-6);
      CHECK(worstTangent < 2e-6);
      CHECK(worstNormal < 2e-6);
    }
  }
}

TEST_CASE("facets lie close to the surface, and hits know its parameters and normal", "[patch]") {
  // The paraboloid z = x^2 + y^2 over the unit square, in Bezier's basis.
  const double line[4] = {0, 1. / 3, 2. / 3, 1}, square[4] = {0, 0, 1. / 3, 1};
  std::vector<double> points;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      points.insert(points.end(), {line[i], line[j], square[i] + square[j]});
  TestScene scene("Format 400 400 1 WorldBegin Translate -0.5 -0.5 2 Patch \"bicubic\" \"P\" " +
                  list(points) + " \"varying float ramp\" [0 1 2 3] \"vertex float height\" " +
                  list([&] {
                    std::vector<double> heights;
                    for (int j = 0; j < 4; ++j)
                      for (int i = 0; i < 4; ++i)
                        heights.push_back(square[i] + square[j]);
                    return heights;
                  }()) +
                  " WorldEnd");
  int hits = 0;
  double pixel = 2.0 / 400; // the view is 2 units wide
  for (uint32_t i = 0; i < 5000; ++i) {
    Vec3d direction(unitNumber(hash(i, 1)) * 0.6 - 0.3, unitNumber(hash(i, 2)) * 0.6 - 0.3, 1);
    auto point = scene.look(direction);
    if (!point)
      continue;
    ++hits;
    Vec3d p = point->frame.P - Vec3d(-0.5, -0.5, 2);
    double steep = std::sqrt(1 + 4 * p.x * p.x + 4 * p.y * p.y);
    CHECK(std::fabs(p.z - p.x * p.x - p.y * p.y) < 0.2 * pixel * steep);
    CHECK(std::fabs(point->frame.u - p.x) < 1e-5);
    CHECK(std::fabs(point->frame.v - p.y) < 1e-5);
    Vec3d normal = normalized({-2 * p.x, -2 * p.y, 1});
    CHECK(maxAbs(point->normal - normal) < 2e-3);
    CHECK(dot(point->frame.normal, normal) > 0.999);
    CHECK(maxAbs(point->frame.dPdu - Vec3d(1, 0, 2 * p.x)) < 1e-5);
    CHECK(std::fabs(point->dsdu - 1) < 1e-6);
    // d/du (-2u, -2v, 1) / length, on the surface.
    double l2 = 1 + 4 * p.x * p.x + 4 * p.y * p.y;
    Vec3d dNdu =
        (Vec3d(-2, 0, 0) - Vec3d(-2 * p.x, -2 * p.y, 1) * (4 * p.x / l2)) * (1 / std::sqrt(l2));
    CHECK(maxAbs(point->dNdu - dNdu) < 0.1);
    CHECK(std::fabs(scene.value(direction, "ramp").at(0) - (p.x + 2 * p.y)) < 1e-5);
    CHECK(std::fabs(scene.value(direction, "height").at(0) - (p.x * p.x + p.y * p.y)) <
          0.2 * pixel);
  }
  CHECK(hits > 1000);
}

TEST_CASE("a bilinear patch, heights and orientation", "[patch]") {
  // z = x y, a saddle; the corners are (0,0) (1,0) (0,1) (1,1).
  TestScene scene("WorldBegin Translate 0 0 3 Patch \"bilinear\" \"Pz\" [0 0 0 1] WorldEnd");
  auto point = scene.look({0.25, 0.5, 3.125});
  REQUIRE(point);
  CHECK(maxAbs(point->frame.P - Vec3d(0.25, 0.5, 3.125)) < 1e-3);
  CHECK(maxAbs(point->normal - normalized(Vec3d(-0.5, -0.25, 1))) < 1e-3);
  // A mirror and ReverseOrientation turn the normal, each by itself; Sides 1 shows the outside.
  TestScene mirrored(
      "WorldBegin Scale -1 1 1 Translate 0 0 3 Patch \"bilinear\" \"Pz\" [0 0 0 1] WorldEnd");
  CHECK(mirrored.look({-0.25, 0.5, 3.125})->normal.z > 0);
  TestScene reversed("WorldBegin ReverseOrientation Sides 1 Translate 0 0 3 "
                     "Patch \"bilinear\" \"Pz\" [0 0 0 1] WorldEnd");
  CHECK(reversed.look({0.25, 0.5, 3.125})->normal.z < 0);
  TestScene behind(
      "WorldBegin Sides 1 Translate 0 0 3 Patch \"bilinear\" \"Pz\" [0 0 0 1] WorldEnd");
  CHECK_FALSE(behind.look({0.25, 0.5, 3.125}));
}

TEST_CASE("a periodic mesh closes without a crack", "[patch]") {
  // A tube round y, of b-splines in u.
  std::vector<double> points;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 12; ++i) {
      double angle = 2 * std::numbers::pi * i / 12;
      points.insert(points.end(), {std::cos(angle), j * 4.0 - 6, std::sin(angle)});
    }
  TestScene scene(
      "Format 1024 1024 1 WorldBegin Basis \"b-spline\" 1 \"bezier\" 3 PatchMesh \"bicubic\" "
      "12 \"periodic\" 4 \"nonperiodic\" \"P\" " +
      list(points) + " \"uniform float strip\" [0 1 2 3 4 5 6 7 8 9 10 11] \"varying float x\" " +
      list({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}) +
      " WorldEnd");
  CHECK(scene.warnings.count() == 0);
  auto mesh = facets(scene);
  // Every edge but those of the two open ends belongs to two facets.
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const auto &triangle : mesh->triangles)
    for (size_t k = 0; k < 3; ++k) {
      uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      ++edges[{std::min(a, b), std::max(a, b)}];
    }
  size_t open = 0;
  for (const auto &[edge, count] : edges) {
    CHECK(count <= 2);
    bool atEnd = std::fabs(std::fabs(mesh->points[edge.first].y) - 6) < 1e-5 &&
                 std::fabs(std::fabs(mesh->points[edge.second].y) - 6) < 1e-5;
    open += count == 1 && !atEnd;
  }
  CHECK(open == 0);
  int missed = 0;
  for (uint32_t i = 0; i < 10000; ++i) {
    double angle = 2 * std::numbers::pi * unitNumber(hash(i, 1));
    missed += !scene.look({std::cos(angle), unitNumber(hash(i, 2)) - 0.5, std::sin(angle)});
  }
  CHECK(missed == 0);
  // The middle of strip k is at an angle of k + 1.5 twelfths; there x is between k and k + 1, and
  // the last strip's goes back to 0.
  for (int k : {0, 5, 11}) {
    double angle = 2 * std::numbers::pi * (k + 1.5) / 12;
    Vec3d direction(std::cos(angle), 0, std::sin(angle));
    CHECK(scene.value(direction, "strip") == std::vector<float>{float(k)});
    CHECK(scene.value(direction, "x").at(0) == Approx(k == 11 ? 5.5 : k + 0.5).epsilon(0.02));
    CHECK(scene.look(direction)->frame.u == Approx((k + 0.5) / 12).epsilon(0.02));
  }
}

TEST_CASE("a sphere of NURBS is exactly round", "[patch]") {
  TestScene scene("Format 800 800 1 WorldBegin Translate 0 0 4 " + nurbsSphere() + " WorldEnd");
  auto mesh = facets(scene);
  double worst = 0, worstNormal = 0;
  for (size_t t = 0; t < mesh->triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k) {
      Vec3d p = Vec3d(mesh->points[mesh->triangles[t][k]]) - Vec3d(0, 0, 4);
      worst = std::max(worst, std::fabs(length(p) - 1));
      // Outwards, at the poles as well.
      worstNormal =
          std::max(worstNormal, length(vector(*mesh, mesh->corners[t][k]) - normalized(p)));
    }
  CHECK(worst < 1e-6);
  CHECK(worstNormal < 1e-4);
  CHECK(area(*mesh) == Approx(4 * std::numbers::pi).epsilon(2e-3));
  auto point = scene.look({0, 0, 1});
  REQUIRE(point);
  CHECK(point->normal.z == Approx(-1).epsilon(1e-4));
  CHECK(point->frame.v == Approx(0).margin(1e-3));

  TestScene inside("Format 800 800 1 WorldBegin " + nurbsSphere() + " WorldEnd");
  int missed = 0;
  for (uint32_t i = 0; i < 20000; ++i)
    missed += !inside.look(
        {unitNumber(hash(i, 1)) - 0.5, unitNumber(hash(i, 2)) - 0.5, unitNumber(hash(i, 3)) - 0.5});
  CHECK(missed == 0);
}

TEST_CASE("a part of a NURBS surface, of linear and cubic order", "[patch]") {
  // x = t exactly, by uneven knots: control values are the knots' running means.
  TestScene scene("WorldBegin Translate 0 0 2 NuPatch 5 4 [0 0 0 0 1 4 4 4 4] 0.5 2 "
                  "3 2 [0 0 1 2 2] 0 2 \"P\" " +
                  list([] {
                    std::vector<double> points;
                    for (double y : {-1., 0., 1.})
                      for (double x : {0., 1. / 3, 5. / 3, 3., 4.})
                        points.insert(points.end(), {x - 1, y, 0});
                    return points;
                  }()) +
                  " WorldEnd");
  CHECK(scene.warnings.count() == 0);
  CHECK_FALSE(scene.look({-0.51, 0.1, 2}));
  CHECK_FALSE(scene.look({1.01, 0.1, 2}));
  for (double x : {-0.45, 0.1, 0.9}) {
    auto point = scene.look({x, 0.5, 2});
    REQUIRE(point);
    CHECK(point->frame.u == Approx((x + 1 - 0.5) / 1.5).epsilon(1e-5));
    CHECK(point->frame.v == Approx(0.75).epsilon(1e-5));
    CHECK(maxAbs(point->frame.dPdu - Vec3d(1.5, 0, 0)) < 1e-5);
    CHECK(maxAbs(point->frame.dPdv - Vec3d(0, 2, 0)) < 1e-5);
    CHECK(point->normal == Vec3d(0, 0, 1));
  }
}

TEST_CASE("wrong patches are left out", "[patch]") {
  auto check = [](const std::string &shape, const std::string &message) {
    TestScene scene("WorldBegin " + shape + " WorldEnd");
    INFO(shape);
    CHECK(scene.description.shapes.empty());
    CHECK(scene.warnings.count() == 1);
    CHECK(scene.warnings.contains(message));
  };
  check("Patch \"cubic\" \"P\" []", "\"cubic\" is neither bilinear nor bicubic");
  check("Patch \"bilinear\" \"P\" [0 0 0 1 0 0]",
        "\"P\": expected 12 numbers, 4 control points, found 6");
  check("Patch \"bilinear\" \"Pz\" [0 0 1]", "this shape needs its control points");
  check("PatchMesh \"bicubic\" 5 \"nonperiodic\" 4 \"nonperiodic\" \"P\" [0]",
        "5 control points in u do not make patches, with a step of 3 in Basis");
  check("PatchMesh \"bilinear\" 3 \"open\" 4 \"periodic\" \"P\" [0]",
        "\"open\" is neither periodic");
  check(
      "PatchMesh \"bilinear\" 2 \"nonperiodic\" 2 \"nonperiodic\" \"P\" [0 0 0 1 0 0 0 1 0 1 1 0] "
      "\"varying float a\" [1 2 3]",
      "\"a\": expected 4 numbers, 4 varying values of 1, found 3");
  check("NuPatch 2 3 [0 0 0 1 1] 0 1 2 2 [0 0 1 1] 0 1 \"P\" []",
        "do not make a surface of order 3");
  check("NuPatch 2 2 [0 0 1] 0 1 2 2 [0 0 1 1] 0 1 \"P\" []", "expected 4 knots in u, found 3");
  check("NuPatch 2 2 [0 0 1 1] 0 1 2 2 [0 1 0 1] 0 1 \"P\" []", "the knots in v decrease");
  check("NuPatch 2 2 [0 0 1 1] 2 3 2 2 [0 0 1 1] 0 1 \"P\" []",
        "nothing of the surface lies between");
}

namespace {

/// The square from (-1, -1) to (1, 1) at z = 2, whose parameters run from 2 to 6 and from 10 to 14,
/// trimmed.
std::string trimmed(const std::string &curves) {
  return "WorldBegin Translate 0 0 2 " + curves +
         " NuPatch 2 2 [2 2 6 6] 2 6 2 2 [10 10 14 14] 10 14 "
         "\"P\" [-1 -1 0  1 -1 0  -1 1 0  1 1 0] WorldEnd";
}
/// The circle of radius 1 about the middle of those parameters, of x^2 + y^2 <= 1/4: quadratic arcs
/// that weights make round, and a square of four lines round the whole, 0.2 from its edges.
std::string circleNumbers() {
  const double h = std::sqrt(0.5);
  const double arcs[9][3] = {{1, 0, 1},   {1, 1, h},  {0, 1, 1},  {-1, 1, h}, {-1, 0, 1},
                             {-1, -1, h}, {0, -1, 1}, {1, -1, h}, {1, 0, 1}};
  std::vector<double> u, v, w;
  for (const auto &[x, y, weight] : arcs) {
    u.push_back((4 + x) * weight);
    v.push_back((12 + y) * weight);
    w.push_back(weight);
  }
  auto inner = [](const std::vector<double> &numbers) {
    std::string text = list(numbers);
    return text.substr(1, text.size() - 2);
  };
  return inner(u) + "|" + inner(v) + "|" + inner(w);
}
std::string circle(const std::string &loops = "1", const std::string &orders = "3",
                   const std::string &knots = "0 0 0 1 1 2 2 3 3 4 4 4",
                   const std::string &mins = "0", const std::string &maxs = "4",
                   const std::string &counts = "9", const std::string &u = "",
                   const std::string &v = "", const std::string &w = "") {
  std::string numbers = circleNumbers();
  size_t first = numbers.find('|'), second = numbers.rfind('|');
  return "TrimCurve [" + loops + "] [" + orders + "] [" + knots + "] [" + mins + "] [" + maxs +
         "] [" + counts + "] [" + numbers.substr(0, first) + u + "] [" +
         numbers.substr(first + 1, second - first - 1) + v + "] [" + numbers.substr(second + 1) +
         w + "]";
}
/// The circle within a square of four lines, each a curve of the second loop, 0.8 from the middle.
std::string circleInSquare() {
  return circle("1 4", "3 2 2 2 2", "0 0 0 1 1 2 2 3 3 4 4 4  0 0 1 1  0 0 1 1  0 0 1 1  0 0 1 1",
                "0 0 0 0 0", "4 1 1 1 1", "9 2 2 2 2", "2.4 5.6  5.6 5.6  5.6 2.4  2.4 2.4",
                "10.4 10.4  10.4 13.6  13.6 13.6  13.6 10.4", "1 1 1 1 1 1 1 1");
}

/// How many of many places are seen or not other than a rule says.
template <typename Rule>
int wrongPlaces(const TestScene &scene, const Rule &rule) {
  int wrong = 0;
  for (uint32_t i = 0; i < 20000; ++i) {
    double x = 2 * unitNumber(hash(i, 1)) - 1, y = 2 * unitNumber(hash(i, 2)) - 1;
    wrong += scene.look({x, y, 2}).has_value() != rule(x, y);
  }
  return wrong;
}

} // namespace

TEST_CASE("trim curves leave what is within an odd number of loops", "[patch]") {
  auto inCircle = [](double x, double y) { return x * x + y * y < 0.25; };
  auto inSquare = [](double x, double y) { return std::max(std::fabs(x), std::fabs(y)) < 0.8; };
  // The chords of the circle miss less than 1e-4 of its radius: two places of 20000 at most.
  TestScene disk(trimmed(circle()));
  CHECK(disk.warnings.count() == 0);
  CHECK(wrongPlaces(disk, inCircle) <= 2);
  // Parameters are those of the whole surface.
  CHECK(disk.look({0.25, -0.25, 2})->frame.u == Approx(0.625));
  TestScene ring(trimmed(circleInSquare()));
  CHECK(wrongPlaces(ring, [&](double x, double y) { return inSquare(x, y) && !inCircle(x, y); }) <=
        2);
  TestScene hole(trimmed("Attribute \"trimcurve\" \"sense\" [\"outside\"] " + circle()));
  CHECK(hole.warnings.count() == 0);
  CHECK(wrongPlaces(hole, [&](double x, double y) { return !inCircle(x, y); }) <= 2);
  // A part of the circle, from angle 0 to half a turn, is closed by a line.
  TestScene half(trimmed(circle("1", "3", "0 0 0 1 1 2 2 3 3 4 4 4", "0", "2")));
  CHECK(wrongPlaces(half, [&](double x, double y) { return inCircle(x, y) && y > 0; }) <= 2);
  // Shadow rays as well.
  Ray through;
  through.direction = Vec3f(0, 0, 1);
  CHECK_FALSE(ring.shoot(through, OpaqueShadowRays).isHit());
  // Trim curves are attributes; none ends them.
  TestScene ended(trimmed("AttributeBegin " + circle() + " AttributeEnd"));
  CHECK(wrongPlaces(ended, [](double, double) { return true; }) == 0);
  TestScene none(trimmed(circle() + " TrimCurve [] [] [] [] [] [] [] [] []"));
  CHECK(wrongPlaces(none, [](double, double) { return true; }) == 0);
}

TEST_CASE("wrong trim curves are errors", "[patch]") {
  auto check = [](const std::string &curve, const std::string &message) {
    INFO(curve);
    std::string found;
    try {
      TestScene scene(trimmed(curve));
    } catch (const UserError &error) {
      found = error.message;
    }
    CHECK(found == "TrimCurve: " + message);
  };
  check("TrimCurve [1] [3] [0 0 0 1 1 1] [0] [1] [3] [0 1 2] [0 1] [1 1 1]",
        "expected 3 control points, found 2");
  check("TrimCurve [2] [3] [0 0 0 1 1 1] [0] [1] [3] [0 1 2] [0 1 2] [1 1 1]",
        "expected 2 orders, found 1");
  check("TrimCurve [1] [3] [0 0 0 1 1] [0] [1] [3] [0 1 2] [0 1 2] [1 1 1]",
        "expected 6 knots, found 5");
  check("TrimCurve [1] [3] [0 0 0 1 1 0] [0] [1] [3] [0 1 2] [0 1 2] [1 1 1]",
        "the knots decrease");
  check("TrimCurve [1] [4] [0 0 0 1 1 1 1] [0] [1] [3] [0 1 2] [0 1 2] [1 1 1]",
        "3 control points do not make a curve of order 4");
  check("TrimCurve [1] [3] [0 0 0 1 1 1] [1] [1] [3] [0 1 2] [0 1 2] [1 1 1]",
        "nothing of the curve lies between its ends");
  check("TrimCurve [1] [3] [0 0 0 1 1 1] [0] [1] [3] [0 1 2] [0 1 2] [1 0 1]",
        "a weight is not positive");
}
