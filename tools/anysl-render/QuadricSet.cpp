//===-- tools/anysl-render/QuadricSet.cpp - exact quadrics in Embree --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/QuadricSet.h"

#include <algorithm>
#include <limits>

using namespace anysl::render;

namespace {

/// Component k of ray i of Embree's N rays is rays[k * N + i]; these are the k.
enum RayComponent {
  OriginX,
  Near = 3,
  DirectionX = 4,
  Far = 8,
  HitNormal = 12,
  HitU = 15,
  HitV,
  HitPrimitive,
  HitGeometry,
  HitInstance
};

} // namespace

void QuadricSet::add(const QuadricShape &shape, const ParameterList &variables,
                     const Placement &placement, const SurfaceOwner &owner) {
  std::vector<Variable> list;
  for (const Parameter &parameter : variables) {
    if (isPosition(parameter.name) || parameter.declaration->type == ValueType::String)
      continue;
    list.push_back(cameraVariable(parameter, placement));
    bool perShape = parameter.declaration->storage == StorageClass::Constant ||
                    parameter.declaration->storage == StorageClass::Uniform;
    list.back().domain = perShape ? Domain::Constant : Domain::Point;
  }
  if (!list.empty())
    values.emplace(uint32_t(quadrics.size()), std::move(list));
  quadrics.emplace_back(shape, placement.toCamera, *owner.appearance);
  owners.push_back(owner);
}

const SurfaceVariables &QuadricSet::variables(uint32_t primitive) const {
  static const SurfaceVariables none;
  auto entry = values.find(primitive);
  return entry == values.end() ? none : entry->second;
}

template <bool IsOccluded>
void QuadricSet::intersect(void *userData, unsigned primitive, unsigned geometry,
                           RTCIntersectContext *context, int *valid, float *rays, unsigned count) {
  const Quadric &quadric = static_cast<QuadricSet *>(userData)->quadrics[primitive];
  constexpr unsigned most = 16;
  double nearer[most], farther[most];
  for (unsigned begin = 0; begin < count; begin += most) {
    unsigned end = std::min(count, begin + most);
    quadric.roots(rays + begin, count, end - begin, nearer, farther);
    for (unsigned i = begin; i < end; ++i) {
      auto component = [&](unsigned k) -> float & { return rays[k * count + i]; };
      auto index = [&](unsigned k) -> unsigned & {
        return reinterpret_cast<unsigned *>(rays)[k * count + i];
      };
      double t0 = nearer[i - begin], t1 = farther[i - begin];
      // Written so that NaN fails.
      if (!valid[i] || !(float(t1) > component(Near)) || !(float(t0) < component(Far)))
        continue;
      Vec3f origin(component(OriginX), component(OriginX + 1), component(OriginX + 2));
      Vec3f direction(component(DirectionX), component(DirectionX + 1), component(DirectionX + 2));
      double t = t0;
      if (!(float(t0) > component(Near)) || !quadric.accepts(origin, direction, t0)) {
        t = t1;
        if (!(float(t1) < component(Far)) || !quadric.accepts(origin, direction, t1))
          continue;
      }
      if constexpr (IsOccluded) {
        component(Far) = -std::numeric_limits<float>::infinity();
        continue;
      }
      component(Far) = float(t);
      for (unsigned k = HitNormal; k < HitNormal + 3; ++k)
        component(k) = 0; // computed by evaluate() for the one hit that stays
      component(HitU) = component(HitV) = 0;
      index(HitPrimitive) = primitive;
      index(HitGeometry) = geometry;
      index(HitInstance) = context->instID[0];
    }
  }
}

RTCGeometry QuadricSet::make(RTCDevice device) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, unsigned(quadrics.size()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments *arguments) {
        const auto *set = static_cast<const QuadricSet *>(arguments->geometryUserPtr);
        Vec3f lower, upper;
        set->quadrics[arguments->primID].bounds(lower, upper);
        RTCBounds &b = *arguments->bounds_o;
        b.lower_x = lower.x, b.lower_y = lower.y, b.lower_z = lower.z;
        b.upper_x = upper.x, b.upper_y = upper.y, b.upper_z = upper.z;
      },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments *a) {
    intersect<false>(a->geometryUserPtr, a->primID, a->geomID, a->context, a->valid,
                     reinterpret_cast<float *>(a->rayhit), a->N);
  });
  rtcSetGeometryOccludedFunction(geometry, [](const RTCOccludedFunctionNArguments *a) {
    intersect<true>(a->geometryUserPtr, a->primID, a->geomID, a->context, a->valid,
                    reinterpret_cast<float *>(a->ray), a->N);
  });
  return geometry;
}

void QuadricSet::evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &needs,
                          SurfacePoint &point) const {
  point.frame = quadrics[hit.primitive].evaluate(origin, direction, hit.t, needs.parametric);
  point.normal = point.frame.normal;
  if (!needs.derivatives)
    return;
  quadrics[hit.primitive].normalDerivatives(point.frame, point.dNdu, point.dNdv);
  point.dNgdu = point.dNdu, point.dNgdv = point.dNdv;
}

void QuadricSet::interpolate(const Variable &variable, const Hit &, const SurfacePoint &point,
                             float *value) const {
  interpolateCorners(variable, point.frame.u, point.frame.v, value);
}

void QuadricSet::differentiate(const Variable &variable, uint32_t component, const Hit &,
                               const SurfacePoint &point, double &byU, double &byV) const {
  byU = byV = 0;
  if (variable.domain == Domain::Constant)
    return;
  auto at = [&](size_t corner) { return double(variable.at(corner)[component]); };
  double u = point.frame.u, v = point.frame.v;
  byU = (1 - v) * (at(1) - at(0)) + v * (at(3) - at(2));
  byV = (1 - u) * (at(2) - at(0)) + u * (at(3) - at(1));
}
