//===-- tools/anysl-render/Quadric.cpp - exact quadrics ---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Quadric.h"

#include <algorithm>
#include <limits>
#include <numbers>

using namespace anysl::render;

namespace {
constexpr double pi = std::numbers::pi;
double square(double x) { return x * x; }
} // namespace

bool Quadric::isQuadric(const QuadricShape &shape) {
  if (shape.kind == QuadricShape::Hyperboloid)
    return shape.point1.z != shape.point2.z;
  return shape.kind != QuadricShape::Torus;
}

Quadric::Quadric(const QuadricShape &given, const Matrix4 &objectToCamera,
                 const Appearance &appearance)
    : shape(given), toCamera(objectToCamera), toObject(objectToCamera.inverse()),
      reverse(appearance.reverseOrientation), oneSided(appearance.sides == 1) {
  thetaMax = shape.thetaMax * (pi / 180);
  limitedSweep = std::fabs(shape.thetaMax) < 360;
  zmin = std::min(shape.zmin, shape.zmax);
  zmax = std::max(shape.zmin, shape.zmax);
  double radius = shape.radius;
  maxRadius = std::fabs(radius);
  limitedZ = true;
  double middle = 0.5 * (zmin + zmax), middleRadius = maxRadius;
  switch (shape.kind) {
  case QuadricShape::Sphere: {
    a = b = 1;
    d = -square(radius);
    zmin = std::max(zmin, -maxRadius);
    zmax = std::min(zmax, maxRadius);
    limitedZ = zmin > -maxRadius || zmax < maxRadius;
    phiMin = std::asin(zmin / maxRadius);
    phiMax = std::asin(zmax / maxRadius);
    middle = 0.5 * (zmin + zmax);
    middleRadius = std::sqrt(std::max(0.0, square(radius) - square(middle)));
    break;
  }
  case QuadricShape::Cylinder:
    a = 1;
    d = -square(radius);
    break;
  case QuadricShape::Cone: {
    double k = square(radius / shape.height);
    a = 1;
    b = -k;
    c = 2 * k * shape.height;
    d = -k * square(shape.height);
    zmin = std::min(0.0, shape.height);
    zmax = std::max(0.0, shape.height);
    middle = 0.5 * shape.height;
    middleRadius = 0.5 * maxRadius;
    break;
  }
  case QuadricShape::Paraboloid: {
    double k = square(radius) / shape.zmax;
    a = 1;
    c = -k;
    // Only the side of the apex on which the surface lies.
    if (shape.zmax > 0)
      zmin = std::max(zmin, 0.0);
    else
      zmax = std::min(zmax, 0.0);
    middle = 0.5 * (zmin + zmax);
    middleRadius = std::sqrt(std::max(0.0, k * middle));
    break;
  }
  case QuadricShape::Disk:
    c = 1;
    d = -shape.height;
    limitedZ = false;
    limitedRadius = true;
    zmin = zmax = middle = shape.height;
    middleRadius = 0.5 * maxRadius;
    break;
  case QuadricShape::Hyperboloid: {
    // The squared radius along the swept line, k0 + k1 v + k2 v², with v = (z - z1) / dz.
    Vec3d p = shape.point1, q = shape.point2 - shape.point1;
    double k2 = square(q.x) + square(q.y), k1 = 2 * (p.x * q.x + p.y * q.y);
    double k0 = square(p.x) + square(p.y), dz = q.z;
    a = 1;
    b = -k2 / square(dz);
    c = 2 * k2 * p.z / square(dz) - k1 / dz;
    d = -k2 * square(p.z / dz) + k1 * p.z / dz - k0;
    zmin = std::min(shape.point1.z, shape.point2.z);
    zmax = std::max(shape.point1.z, shape.point2.z);
    maxRadius = std::sqrt(std::max(k0, k0 + k1 + k2));
    middle = 0.5 * (zmin + zmax);
    middleRadius = std::sqrt(std::max(0.0, k0 + 0.5 * k1 + 0.25 * k2));
    break;
  }
  case QuadricShape::Torus:
    break;
  }
  // dPdu x dPdv points to one side everywhere: compare with the gradient at one point.
  double theta = 0.5 * thetaMax;
  Vec3d sample{middleRadius * std::cos(theta), middleRadius * std::sin(theta), middle};
  SurfaceFrame frame = objectFrame(sample);
  normalSign = dot(cross(frame.dPdu, frame.dPdv), gradient(sample)) < 0 ? -1 : 1;
  if (shape.kind == QuadricShape::Sphere && radius < 0)
    normalSign = -normalSign;
}

Vec3d Quadric::gradient(Vec3d p) const { return {2 * a * p.x, 2 * a * p.y, 2 * b * p.z + c}; }

double Quadric::angle(Vec3d p) const {
  double theta = std::atan2(p.y, p.x);
  if (shape.kind == QuadricShape::Hyperboloid) {
    Vec3d q = lerp(shape.point1, shape.point2,
                   (p.z - shape.point1.z) / (shape.point2.z - shape.point1.z));
    theta -= std::atan2(q.y, q.x);
  }
  // Into [0, 2 pi), or (-2 pi, 0] where the sweep goes the other way.
  if (thetaMax >= 0)
    return theta < 0 ? theta + 2 * pi : theta >= 2 * pi ? theta - 2 * pi : theta;
  return theta > 0 ? theta - 2 * pi : theta <= -2 * pi ? theta + 2 * pi : theta;
}

void Quadric::bounds(Vec3f &lower, Vec3f &upper) const {
  Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
  if (shape.kind == QuadricShape::Sphere && !limitedZ) {
    Vec3d center = toCamera.point({0, 0, 0});
    for (int k = 0; k < 3; ++k) {
      double extent = maxRadius * std::sqrt(square(toCamera.m[0][k]) + square(toCamera.m[1][k]) +
                                            square(toCamera.m[2][k]));
      low[k] = center[k] - extent;
      high[k] = center[k] + extent;
    }
  } else {
    for (int corner = 0; corner < 8; ++corner) {
      Vec3d p = toCamera.point({corner & 1 ? maxRadius : -maxRadius,
                                corner & 2 ? maxRadius : -maxRadius, corner & 4 ? zmax : zmin});
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
  }
  // Two ulps outwards: one for the sums above, one for the conversion.
  float infinity = std::numeric_limits<float>::infinity();
  for (int k = 0; k < 3; ++k) {
    lower[k] = std::nextafter(std::nextafter(float(low[k]), -infinity), -infinity);
    upper[k] = std::nextafter(std::nextafter(float(high[k]), infinity), infinity);
  }
}

ANYSL_RENDER_WIDE void Quadric::roots(const float *__restrict rays, unsigned stride, unsigned count,
                                      double *__restrict first, double *__restrict second) const {
  const auto m = toObject.m;
  const double a = this->a, b = this->b, c = this->c, d = this->d;
  const bool flat = a == 0 && b == 0;
#pragma clang loop vectorize(enable) interleave(disable)
  for (unsigned i = 0; i < count; ++i) {
    double ox = rays[i], oy = rays[stride + i], oz = rays[2 * stride + i];
    double dx = rays[4 * stride + i], dy = rays[5 * stride + i], dz = rays[6 * stride + i];
    double px = ox * m[0][0] + oy * m[1][0] + oz * m[2][0] + m[3][0];
    double py = ox * m[0][1] + oy * m[1][1] + oz * m[2][1] + m[3][1];
    double pz = ox * m[0][2] + oy * m[1][2] + oz * m[2][2] + m[3][2];
    double qx = dx * m[0][0] + dy * m[1][0] + dz * m[2][0];
    double qy = dx * m[0][1] + dy * m[1][1] + dz * m[2][1];
    double qz = dx * m[0][2] + dy * m[1][2] + dz * m[2][2];

    // Start from the ray's point nearest to the object's origin.
    double shift = -(px * qx + py * qy + pz * qz) / (qx * qx + qy * qy + qz * qz);
    px += shift * qx;
    py += shift * qy;
    pz += shift * qz;

    double qa = a * (qx * qx + qy * qy) + b * qz * qz;
    double half = a * (px * qx + py * qy) + b * pz * qz + 0.5 * c * qz;
    double qc = a * (px * px + py * py) + b * pz * pz + c * pz + d;
    double discriminant = half * half - qa * qc;
    double root = __builtin_sqrt(discriminant); // NaN where there is no hit
    // The root whose terms have the same sign, and the other from the product of the two.
    double sum = half < 0 ? half - root : half + root;
    double t0 = -sum / qa, t1 = -qc / sum;
    double linear = -qc / (2 * half);
    // qa is exactly 0 for a plane and along a straight line of the surface.
    t0 = flat || qa == 0 ? linear : t0;
    t1 = flat || qa == 0 ? linear : t1;
    // A tangent ray through the middle: both roots are the middle.
    t0 = half == 0 && root == 0 ? 0.0 : t0;
    t1 = half == 0 && root == 0 ? 0.0 : t1;
    double nearer = t0 < t1 ? t0 : t1, farther = t0 < t1 ? t1 : t0;
    first[i] = nearer + shift;
    second[i] = farther + shift;
  }
}

bool Quadric::accepts(Vec3f origin, Vec3f direction, double t) const {
  if (!std::isfinite(t))
    return false;
  if (!limitedZ && !limitedRadius && !limitedSweep && !oneSided)
    return true;
  Vec3d p = toObject.affinePoint(Vec3d(origin) + Vec3d(direction) * t);
  if (limitedZ && !(p.z >= zmin && p.z <= zmax))
    return false;
  if (limitedRadius && !(square(p.x) + square(p.y) <= square(maxRadius)))
    return false;
  if (limitedSweep && std::fabs(angle(p)) > std::fabs(thetaMax))
    return false;
  if (oneSided) {
    double side = normalSign * dot(gradient(p), toObject.vector(Vec3d(direction)));
    if ((reverse ? -side : side) > 0)
      return false;
  }
  return true;
}

Vec3d Quadric::refine(Vec3d p) const {
  if (shape.kind == QuadricShape::Sphere) {
    double r = length(p);
    return r > 0 ? p * (maxRadius / r) : p;
  }
  if (shape.kind == QuadricShape::Disk)
    return {p.x, p.y, shape.height};
  // Newton's method along the gradient; the start is within a float's rounding of the surface.
  for (int step = 0; step < 2; ++step) {
    Vec3d g = gradient(p);
    double gg = dot(g, g);
    if (!(gg > 0))
      break;
    double f = a * (square(p.x) + square(p.y)) + b * square(p.z) + c * p.z + d;
    p = p - g * (f / gg);
  }
  return p;
}

SurfaceFrame Quadric::objectFrame(Vec3d p) const {
  SurfaceFrame frame;
  frame.P = p;
  double theta = angle(p);
  frame.u = theta / thetaMax;
  frame.dPdu = Vec3d(-p.y, p.x, 0) * thetaMax;
  double rho = std::sqrt(square(p.x) + square(p.y));
  // On the axis the sweep's start stands for all directions.
  Vec3d out = rho > 0 ? Vec3d(p.x / rho, p.y / rho, 0) : Vec3d(1, 0, 0);
  switch (shape.kind) {
  case QuadricShape::Sphere: {
    double range = phiMax - phiMin;
    frame.v = (std::atan2(p.z, rho) - phiMin) / range;
    frame.dPdv = (Vec3d(0, 0, rho) - out * p.z) * range;
    break;
  }
  case QuadricShape::Cylinder:
    frame.v = (p.z - shape.zmin) / (shape.zmax - shape.zmin);
    frame.dPdv = {0, 0, shape.zmax - shape.zmin};
    break;
  case QuadricShape::Cone:
    frame.v = p.z / shape.height;
    frame.dPdv = Vec3d(0, 0, shape.height) - out * shape.radius;
    break;
  case QuadricShape::Paraboloid: {
    double range = shape.zmax - shape.zmin;
    frame.v = (p.z - shape.zmin) / range;
    double slope = p.z != 0 ? rho / (2 * p.z) : 0;
    frame.dPdv = (out * slope + Vec3d(0, 0, 1)) * range;
    break;
  }
  case QuadricShape::Disk:
    frame.v = 1 - rho / maxRadius;
    frame.dPdv = out * -maxRadius;
    break;
  case QuadricShape::Hyperboloid: {
    Vec3d along = shape.point2 - shape.point1;
    frame.v = (p.z - shape.point1.z) / along.z;
    double cosine = std::cos(theta), sine = std::sin(theta);
    frame.dPdv = {along.x * cosine - along.y * sine, along.x * sine + along.y * cosine, along.z};
    break;
  }
  case QuadricShape::Torus:
    break;
  }
  return frame;
}

SurfaceFrame Quadric::evaluate(Vec3f origin, Vec3f direction, double t, bool parametric) const {
  Vec3d p = refine(toObject.affinePoint(Vec3d(origin) + Vec3d(direction) * t));
  SurfaceFrame frame;
  if (parametric) {
    frame = objectFrame(p);
    frame.dPdu = toCamera.vector(frame.dPdu);
    frame.dPdv = toCamera.vector(frame.dPdv);
  }
  Vec3d normal = gradient(p) * (reverse ? -normalSign : normalSign);
  if (normal == Vec3d())
    normal = {0, 0, shape.height < 0 ? -1.0 : 1.0}; // a cone's apex
  frame.P = toCamera.affinePoint(p);
  frame.normal = toObject.normalByInverse(normal);
  return frame;
}

void Quadric::normalDerivatives(const SurfaceFrame &frame, Vec3d &byU, Vec3d &byV) const {
  double sign = reverse ? -normalSign : normalSign;
  auto derive = [&](Vec3d dP) {
    dP = toObject.vector(dP);
    return toObject.normalByInverse(Vec3d(2 * a * dP.x, 2 * a * dP.y, 2 * b * dP.z) * sign);
  };
  byU = derive(frame.dPdu);
  byV = derive(frame.dPdv);
}
