//===-- tools/anysl-render/Displacement.cpp - surfaces moved by shaders -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Displacement.h"
#include "tools/anysl-render/Footprint.h"
#include "tools/anysl-render/ParameterArrays.h"
#include "tools/anysl-render/Pictures.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

using namespace anysl::render;

namespace {

int serveMatrix(void *renderer, const AnyslShadeArgs *args, const char *from, const char *to,
                double *matrix) {
  return serveSpaceMatrix(renderer, static_cast<const Space *>(args->batch), from, to, matrix);
}

AnyslServices makeServices() {
  AnyslServices services = {};
  services.struct_size = sizeof services;
  services.space_matrix = serveMatrix;
  services.texture = serveTexture;
  services.environment = serveEnvironment;
  services.shadow = serveShadow;
  return services;
}

constexpr uint64_t moved = uint64_t(1) << ANYSL_P | uint64_t(1) << ANYSL_N;

class Displacer {
public:
  Displacer(const Scene &scene, const Shader &shader, std::span<const Binding> bound,
            const Shape &shape, AnyslLayout layout, Mesh &mesh)
      : scene(scene), shader(shader), bound(bound), object(shape.objectToCamera), layout(layout),
        mesh(mesh) {}

  template <typename Real>
  void run();

private:
  void prepare();
  template <typename Real>
  void shade(Arena &arena, uint32_t first, uint32_t count);
  void prepareOutputs();
  void movePoints();
  void findTangents();
  void findNormals();

  const Scene &scene;
  const Shader &shader;
  std::span<const Binding> bound;
  Space object;
  AnyslLayout layout;
  Mesh &mesh;
  std::vector<uint32_t> placeOf; ///< of each corner: three times a triangle, and which of its three
  std::vector<Vec3d> places, normals;       ///< of each corner, as the shader leaves them
  std::vector<Vec3d> oldPlaces, oldNormals; ///< before that
  std::vector<Shader::Output> outputs;      ///< channel: number in mesh.values.list
  bool anyMoved = false;
};

/// What other shaders may ask for is kept at every corner.
void Displacer::prepareOutputs() {
  for (uint32_t i = 0; i < shader.info->param_count; ++i) {
    const AnyslParamInfo &param = shader.info->params[i];
    if (!(param.flags & ANYSL_PARAM_OUTPUT) || param.type == ANYSL_STRING)
      continue;
    Variable variable;
    variable.name = std::string(displacementPrefix) + param.name;
    variable.type = param.type == ANYSL_FLOAT    ? ValueType::Float
                    : param.type == ANYSL_COLOR  ? ValueType::Color
                    : param.type == ANYSL_MATRIX ? ValueType::Matrix
                                                 : ValueType::Vector;
    variable.domain = Domain::Corner;
    variable.components =
        anysl_type_components(param.type) * (param.array_length ? param.array_length : 1);
    variable.values.resize(places.size() * variable.components);
    outputs.push_back({i, uint32_t(mesh.values.list.size())});
    mesh.values.list.push_back(std::move(variable));
  }
}

void Displacer::prepare() {
  if (mesh.corners.empty())
    mesh.corners = mesh.triangles;
  uint32_t count = 0;
  for (const auto &corner : mesh.corners)
    count = std::max(count, *std::max_element(corner.begin(), corner.end()) + 1);
  constexpr uint32_t unused = ~uint32_t(0);
  placeOf.assign(count, unused);
  for (uint32_t t = 0; t < mesh.corners.size(); ++t)
    for (uint32_t k = 0; k < 3; ++k)
      placeOf[mesh.corners[t][k]] = 3 * t + k;
  for (std::vector<Vec3d> *list : {&places, &normals, &oldPlaces, &oldNormals})
    list->resize(count);
  if (!mesh.parameters.empty())
    return;
  // A polygon's parameters are its places before they move.
  mesh.parameters.resize(count);
  mesh.unitParameters = false;
  mesh.dPdu.resize(count);
  mesh.dPdv.resize(count);
  for (uint32_t corner = 0; corner < count; ++corner)
    if (placeOf[corner] != unused) {
      Vec3d p = mesh.placement.toObject.affinePoint(
          Vec3d(mesh.points[mesh.triangles[placeOf[corner] / 3][placeOf[corner] % 3]]));
      mesh.parameters[corner] = {float(p.x), float(p.y)};
      SurfaceFrame frame = mesh.planarFrameAt(placeOf[corner] / 3);
      mesh.dPdu[corner] = Vec3f(frame.dPdu);
      mesh.dPdv[corner] = Vec3f(frame.dPdv);
    }
}

template <typename Real>
void Displacer::shade(Arena &arena, uint32_t first, uint32_t count) {
  Arena::Scope scope(arena);
  size_t size = (size_t(count) + 15) / 16 * 16;
  Real *arrays[ANYSL_COMPONENT_COUNT] = {};
  bool soa = layout == ANYSL_LAYOUT_SOA;
  Real *points = soa ? nullptr : arena.allocate<Real>(size * ANYSL_COMPONENT_COUNT);
  auto at = [&](int component, size_t i) -> Real & {
    return soa ? arrays[component][i] : points[i * ANYSL_COMPONENT_COUNT + size_t(component)];
  };
  uint64_t wanted = shader.globals | moved;
  auto allocate = [&](int component, double) {
    if (soa) {
      arrays[component] = arena.allocate<Real>(size);
      std::fill_n(arrays[component], size, Real(0));
    }
  };
  storeGlobals(wanted, SurfacePoint(), Ray(), 0, allocate);
  storeUniformGlobals(wanted, scene, allocate);
  ParameterArrays<Real> parameters(arena, shader, bound, false, !outputs.empty(), layout, size);

  for (uint32_t i = 0; i < count; ++i) {
    uint32_t place = placeOf[first + i];
    Hit hit;
    if (place == ~uint32_t(0))
      place = 0; // a corner of no facet
    hit.primitive = place / 3;
    hit.u = place % 3 == 1;
    hit.v = place % 3 == 2;
    Ray ray;
    SurfacePoint point;
    evaluateSurface(mesh, hit, ray.origin, ray.direction, shader.needed | moved, point);
    if (!scene.description.camera.perspective)
      ray.origin = {float(point.frame.P.x), float(point.frame.P.y), 0};
    if (shader.needed & footprintBits)
      findFootprint(scene.camera, true, ray.origin,
                    Vec3f(normalized(point.frame.P - Vec3d(ray.origin))), point);
    oldPlaces[first + i] = point.frame.P;
    oldNormals[first + i] = point.normal;
    auto store = [&](int component, double value) { at(component, i) = Real(value); };
    storeGlobals(wanted, point, ray, 0, store);
    storeUniformGlobals(wanted, scene, store);
    parameters.set(i, bound, [&](uint32_t variable, float *value) {
      mesh.interpolate(mesh.values.list[variable], hit, point, value);
    });
  }
  AnyslShadeArgs args;
  anysl_instance_fill_args(shader.instance.get(), &args);
  args.count = count;
  args.batch = &object;
  args.globals =
      soa ? reinterpret_cast<void *const *>(arrays) : reinterpret_cast<void *const *>(&points);
  parameters.fill(args);
  shader.shade(&args, 0, count);
  for (const Shader::Output &output : outputs) {
    Variable &variable = mesh.values.list[output.channel];
    for (uint32_t i = 0; i < count; ++i)
      for (uint32_t k = 0; k < variable.components; ++k)
        variable.values[(first + i) * variable.components + k] =
            float(parameters.output(output, k, i));
  }
  for (uint32_t i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) {
      places[first + i][k] = at(ANYSL_COMPONENT_P + k, i);
      normals[first + i][k] = at(ANYSL_COMPONENT_N + k, i);
    }
}

template <typename Real>
void Displacer::run() {
  prepare();
  prepareOutputs();
  constexpr uint32_t chunk = 1024;
  uint32_t count = uint32_t(places.size());
  tbb::enumerable_thread_specific<Arena> arenas;
  tbb::parallel_for(uint32_t(0), (count + chunk - 1) / chunk, [&](uint32_t i) {
    shade<Real>(arenas.local(), i * chunk, std::min(chunk, count - i * chunk));
  });
  movePoints();
  findTangents();
  if (shader.info->globals_written >> ANYSL_N & 1)
    findNormals();
  else
    normals = oldNormals;
  mesh.normals.name = "N";
  mesh.normals.type = ValueType::Normal;
  mesh.normals.domain = Domain::Corner;
  mesh.normals.components = 3;
  mesh.normals.values.clear();
  for (const Vec3d &n : normals)
    for (int k = 0; k < 3; ++k)
      mesh.normals.values.push_back(float(n[k]));
}

void Displacer::movePoints() {
  std::vector<Vec3d> sums(mesh.points.size());
  std::vector<uint32_t> counts(mesh.points.size());
  for (uint32_t corner = 0; corner < places.size(); ++corner) {
    uint32_t place = placeOf[corner];
    if (place == ~uint32_t(0))
      continue;
    uint32_t point = mesh.triangles[place / 3][place % 3];
    // A place that is none, or further off than Embree can go, is not gone to.
    bool usable = isFinite(places[corner]) && maxAbs(places[corner]) < 1e18;
    sums[point] += usable ? places[corner] : oldPlaces[corner];
    ++counts[point];
    anyMoved |=
        usable && maxAbs(places[corner] - oldPlaces[corner]) > 1e-6 * maxAbs(oldPlaces[corner]);
  }
  for (size_t i = 0; i < sums.size(); ++i)
    if (counts[i] > 0)
      mesh.points[i] = Vec3f(sums[i] * (1. / counts[i]));
}

void Displacer::findTangents() {
  std::vector<Vec3d> byU(places.size()), byV(places.size());
  std::vector<double> weights(places.size());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec3d dPdu, dPdv;
    double weight = mesh.tangents(t, dPdu, dPdv);
    for (uint32_t corner : mesh.corners[t]) {
      byU[corner] += dPdu * weight;
      byV[corner] += dPdv * weight;
      weights[corner] += weight;
    }
  }
  for (size_t i = 0; i < places.size(); ++i)
    if (weights[i] > 0) {
      mesh.dPdu[i] = Vec3f(byU[i] * (1 / weights[i]));
      mesh.dPdv[i] = Vec3f(byV[i] * (1 / weights[i]));
    }
}

void Displacer::findNormals() {
  if (!anyMoved) {
    for (size_t i = 0; i < normals.size(); ++i)
      normals[i] = normalized(normals[i]) == Vec3d() ? oldNormals[i] : normalized(normals[i]);
    return;
  }
  // The mean over the facets at a point, but for those beyond a crease.
  std::vector<std::vector<uint32_t>> around(mesh.points.size());
  std::vector<Vec3d> facets(mesh.triangles.size());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto &[a, b, c] = mesh.triangles[t];
    Vec3d p(mesh.points[a]);
    facets[t] =
        cross(Vec3d(mesh.points[b]) - p, Vec3d(mesh.points[c]) - p) * mesh.placement.normalSign;
    for (uint32_t k = 0; k < 3; ++k)
      around[mesh.triangles[t][k]].push_back(3 * t + k);
  }
  for (uint32_t corner = 0; corner < normals.size(); ++corner) {
    uint32_t place = placeOf[corner];
    Vec3d own = normalized(normals[corner]), old = normalized(oldNormals[corner]);
    normals[corner] = oldNormals[corner];
    if (place == ~uint32_t(0))
      continue;
    // One that the shader has turned is its own.
    if (own != Vec3d() && dot(own, old) < 1 - 1e-6) {
      normals[corner] = own;
      continue;
    }
    Vec3d sum;
    for (uint32_t other : around[mesh.triangles[place / 3][place % 3]]) {
      uint32_t itsCorner = mesh.corners[other / 3][other % 3];
      if (dot(oldNormals[itsCorner], oldNormals[corner]) > 0.9)
        sum += facets[other / 3];
    }
    if (normalized(sum) != Vec3d())
      normals[corner] = normalized(sum);
  }
}

} // namespace

const AnyslServices anysl::render::displacementServices = makeServices();

void anysl::render::displace(const Scene &scene, const Shader &shader,
                             std::span<const Binding> bound, const Shape &shape, AnyslLayout layout,
                             Mesh &mesh) {
  if (mesh.triangles.empty())
    return;
  Displacer displacer(scene, shader, bound, shape, layout, mesh);
  if (scene.real() == ANYSL_REAL_DOUBLE)
    displacer.run<double>();
  else
    displacer.run<float>();
}
