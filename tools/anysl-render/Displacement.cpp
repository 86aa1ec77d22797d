//===-- tools/anysl-render/Displacement.cpp - surfaces moved by shaders -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Displacement.h"
#include "tools/anysl-render/Footprint.h"
#include "tools/anysl-render/MeshCorners.h"
#include "tools/anysl-render/ParameterArrays.h"
#include "tools/anysl-render/Pictures.h"

#include <algorithm>
#include <functional>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace stc = anysl::stc;
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

/// Runs a displacement shader at some points of a surface.
class Displacer {
public:
  Displacer(const Scene &scene, const Shader &shader, std::span<const Binding> bound,
            const Shape &shape, AnyslLayout layout, ShapeSurface &surface, const SurfaceSet &seen)
      : scene(scene), shader(shader), bound(bound), object(shape.objectToCamera), layout(layout),
        surface(surface), seen(seen) {}

  /// Where a point of the surface lies.
  struct Start {
    Hit hit;
    Vec3f origin; ///< of the hit, which is at distance 0, where that tells its place
  };
  /// Fills in what is below for points start(0) to start(count - 1). What the shader puts out
  /// becomes variables of `domain`.
  void run(uint32_t count, Domain domain, const std::function<Start(uint32_t)> &start);

  std::vector<Vec3d> places, normals;       ///< as the shader leaves them
  std::vector<Vec3d> dPdu, dPdv;            ///< where givesTangents()
  std::vector<Vec3d> oldPlaces, oldNormals; ///< before that

  bool setsNormals() const { return (shader.source.globals_written >> ANYSL_N & 1) != 0; }
  /// Whether the shader says how P changes (anysl-link --tangents).
  bool givesTangents() const { return (shader.info->globals_written >> ANYSL_dPdu & 1) != 0; }
  /// A place that is none, or further off than Embree can go, is not gone to.
  Vec3d newPlace(uint32_t i) const {
    return isFinite(places[i]) && maxAbs(places[i]) < 1e18 ? places[i] : oldPlaces[i];
  }
  /// Of unit length; one that has no direction is not taken.
  Vec3d newNormal(uint32_t i) const {
    Vec3d result = normalized(normals[i]);
    return setsNormals() && isFinite(result) && result != Vec3d() ? result : oldNormals[i];
  }

  /// Whether the shader finds the normals of what it moves, as calculatenormal() does, and may not
  /// know how that changes.
  bool findsNormals() const {
    return setsNormals() && stc::has(shader.source.effects, stc::Effect::Derivatives) &&
           !givesTangents();
  }
  bool isTurned(uint32_t i) const {
    return dot(newNormal(i), normalized(oldNormals[i])) < 1 - 1e-6;
  }
  bool isMoved(uint32_t i) const {
    return maxAbs(newPlace(i) - oldPlaces[i]) > 1e-6 * maxAbs(oldPlaces[i]);
  }

private:
  void prepareOutputs(Domain domain);
  template <typename Real>
  void shade(Arena &arena, uint32_t first, uint32_t count,
             const std::function<Start(uint32_t)> &start);

  const Scene &scene;
  const Shader &shader;
  std::span<const Binding> bound;
  Space object;
  AnyslLayout layout;
  ShapeSurface &surface;                   ///< gets the outputs
  const SurfaceSet &seen;                  ///< tells what is there
  std::vector<Shader::Output> outputs;     ///< channel: number in surface.values.list
  std::vector<Shader::Output> textOutputs; ///< channel: number in surface.values.texts
};

/// What other shaders may ask for is kept at every point.
void Displacer::prepareOutputs(Domain domain) {
  for (uint32_t i = 0; i < shader.info->param_count; ++i) {
    const AnyslParamInfo &param = shader.info->params[i];
    if (!(param.flags & ANYSL_PARAM_OUTPUT))
      continue;
    if (param.type == ANYSL_STRING) {
      textOutputs.push_back({i, uint32_t(surface.values.texts.size())});
      surface.values.texts.push_back(
          {std::string(displacementPrefix) + param.name, param.array_length > 0,
           std::vector<const char *>(std::max(param.array_length, 1u), "")});
      continue;
    }
    Variable variable;
    variable.name = std::string(displacementPrefix) + param.name;
    variable.type = param.type == ANYSL_FLOAT    ? ValueType::Float
                    : param.type == ANYSL_COLOR  ? ValueType::Color
                    : param.type == ANYSL_MATRIX ? ValueType::Matrix
                                                 : ValueType::Vector;
    variable.domain = domain;
    variable.components =
        anysl_type_components(param.type) * (param.array_length ? param.array_length : 1);
    variable.values.resize(places.size() * variable.components);
    outputs.push_back({i, uint32_t(surface.values.list.size())});
    surface.values.list.push_back(std::move(variable));
  }
}

template <typename Real>
void Displacer::shade(Arena &arena, uint32_t first, uint32_t count,
                      const std::function<Start(uint32_t)> &start) {
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
  ParameterArrays<Real> parameters(arena, shader, bound, false,
                                   !outputs.empty() || !textOutputs.empty(), layout, size);

  for (uint32_t i = 0; i < count; ++i) {
    const auto [hit, origin] = start(first + i);
    Ray ray;
    SurfacePoint point;
    evaluateSurface(seen, hit, origin, ray.direction, shader.needed | moved, point);
    if (!scene.description.camera.perspective)
      ray.origin = {float(point.frame.P.x), float(point.frame.P.y), 0};
    ray.direction = Vec3f(normalized(point.frame.P - Vec3d(ray.origin)));
    if (shader.needed & footprintBits)
      findFootprint(scene.camera, true, ray, point);
    oldPlaces[first + i] = point.frame.P;
    oldNormals[first + i] = point.normal;
    auto store = [&](int component, double value) { at(component, i) = Real(value); };
    storeGlobals(wanted, point, ray, 0, store);
    storeUniformGlobals(wanted, scene, store);
    parameters.set(i, bound, VariablesAt{seen, hit, point});
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
    Variable &variable = surface.values.list[output.channel];
    for (uint32_t i = 0; i < count; ++i)
      for (uint32_t k = 0; k < variable.components; ++k)
        variable.values[(first + i) * variable.components + k] =
            float(parameters.output(output, k, i));
  }
  // Text is uniform.
  for (const Shader::Output &output : textOutputs)
    for (uint32_t k = 0; first == 0 && k < surface.values.texts[output.channel].elements.size();
         ++k)
      surface.values.texts[output.channel].elements[k] = parameters.text(output.param, k, 0);
  for (uint32_t i = 0; i < count; ++i)
    for (int k = 0; k < 3; ++k) {
      places[first + i][k] = at(ANYSL_COMPONENT_P + k, i);
      normals[first + i][k] = at(ANYSL_COMPONENT_N + k, i);
      if (givesTangents()) {
        dPdu[first + i][k] = at(ANYSL_COMPONENT_dPdu + k, i);
        dPdv[first + i][k] = at(ANYSL_COMPONENT_dPdv + k, i);
      }
    }
}

void Displacer::run(uint32_t count, Domain domain, const std::function<Start(uint32_t)> &start) {
  for (std::vector<Vec3d> *list : {&places, &normals, &dPdu, &dPdv, &oldPlaces, &oldNormals})
    list->resize(count);
  prepareOutputs(domain);
  constexpr uint32_t chunk = 1024;
  tbb::enumerable_thread_specific<Arena> arenas;
  tbb::parallel_for(uint32_t(0), (count + chunk - 1) / chunk, [&](uint32_t i) {
    uint32_t first = i * chunk, size = std::min(chunk, count - first);
    if (scene.real() == ANYSL_REAL_DOUBLE)
      shade<double>(arenas.local(), first, size, start);
    else
      shade<float>(arenas.local(), first, size, start);
  });
}

//===-- Meshes --------------------------------------------------------------//

constexpr uint32_t unused = ~uint32_t(0);

/// Of each corner: three times a triangle, and which of its three.
std::vector<uint32_t> placesOfCorners(const Mesh &mesh) {
  uint32_t count = 0;
  for (const auto &corner : mesh.corners)
    count = std::max(count, *std::max_element(corner.begin(), corner.end()) + 1);
  std::vector<uint32_t> placeOf(count, unused);
  for (uint32_t t = 0; t < mesh.corners.size(); ++t)
    for (uint32_t k = 0; k < 3; ++k)
      placeOf[mesh.corners[t][k]] = 3 * t + k;
  return placeOf;
}

/// A polygon's parameters are its places before they move.
void keepParameters(const std::vector<uint32_t> &placeOf, Mesh &mesh) {
  mesh.parameters.resize(placeOf.size());
  mesh.unitParameters = false;
  mesh.dPdu.resize(placeOf.size());
  mesh.dPdv.resize(placeOf.size());
  for (uint32_t corner = 0; corner < placeOf.size(); ++corner)
    if (placeOf[corner] != unused) {
      Vec3d p = mesh.placement.toObject.affinePoint(
          Vec3d(mesh.points[mesh.triangles[placeOf[corner] / 3][placeOf[corner] % 3]]));
      mesh.parameters[corner] = {float(p.x), float(p.y)};
      SurfaceFrame frame = mesh.planarFrameAt(placeOf[corner] / 3);
      mesh.dPdu[corner] = Vec3f(frame.dPdu);
      mesh.dPdv[corner] = Vec3f(frame.dPdv);
    }
}

/// Corners at a point go together.
void movePoints(const Displacer &displacer, const std::vector<uint32_t> &placeOf, Mesh &mesh) {
  std::vector<Vec3d> sums(mesh.points.size());
  std::vector<uint32_t> counts(mesh.points.size());
  for (uint32_t corner = 0; corner < placeOf.size(); ++corner) {
    uint32_t place = placeOf[corner];
    if (place == unused)
      continue;
    uint32_t point = mesh.triangles[place / 3][place % 3];
    sums[point] += displacer.newPlace(corner);
    ++counts[point];
  }
  for (size_t i = 0; i < sums.size(); ++i)
    if (counts[i] > 0)
      mesh.points[i] = Vec3f(sums[i] * (1. / counts[i]));
}

void findTangents(Mesh &mesh) {
  std::vector<Vec3d> byU(mesh.dPdu.size()), byV(mesh.dPdu.size());
  std::vector<double> weights(mesh.dPdu.size());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec3d dPdu, dPdv;
    double weight = mesh.tangents(t, dPdu, dPdv);
    for (uint32_t corner : mesh.corners[t]) {
      byU[corner] += dPdu * weight;
      byV[corner] += dPdv * weight;
      weights[corner] += weight;
    }
  }
  for (size_t i = 0; i < mesh.dPdu.size(); ++i)
    if (weights[i] > 0) {
      mesh.dPdu[i] = Vec3f(byU[i] * (1 / weights[i]));
      mesh.dPdv[i] = Vec3f(byV[i] * (1 / weights[i]));
    }
}

/// What varies with the variables of a surface changes in ways that shaders know nothing of. Where
/// one has looked for the normal of what has moved and found it unchanged, this finds it: the mean
/// over the facets at a point, but for those beyond a crease.
void findNormals(const Displacer &displacer, const std::vector<uint32_t> &placeOf, const Mesh &mesh,
                 std::vector<Vec3d> &normals) {
  bool anyMoved = false;
  for (uint32_t corner = 0; corner < placeOf.size(); ++corner)
    anyMoved |= placeOf[corner] != unused && displacer.isMoved(corner);
  if (!anyMoved)
    return;
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
    if (place == unused || displacer.isTurned(corner))
      continue;
    Vec3d sum;
    for (uint32_t other : around[mesh.triangles[place / 3][place % 3]]) {
      uint32_t itsCorner = mesh.corners[other / 3][other % 3];
      if (dot(displacer.oldNormals[itsCorner], displacer.oldNormals[corner]) > 0.9)
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
  if (mesh.corners.empty())
    mesh.corners = mesh.triangles;
  const std::vector<uint32_t> placeOf = placesOfCorners(mesh);
  if (mesh.parameters.empty())
    keepParameters(placeOf, mesh);
  const MeshCorners corners(mesh);
  Displacer displacer(scene, shader, bound, shape, layout, mesh, corners);
  displacer.run(uint32_t(placeOf.size()), Domain::Corner, [&](uint32_t corner) {
    uint32_t place = placeOf[corner] == unused ? 0 : placeOf[corner]; // a corner of no facet
    return Displacer::Start{MeshCorners::hitOf(place), {}};
  });
  movePoints(displacer, placeOf, mesh);
  findTangents(mesh);
  for (uint32_t corner = 0; corner < placeOf.size() && displacer.givesTangents(); ++corner)
    if (isFinite(displacer.dPdu[corner]) && isFinite(displacer.dPdv[corner])) {
      mesh.dPdu[corner] = Vec3f(displacer.dPdu[corner]);
      mesh.dPdv[corner] = Vec3f(displacer.dPdv[corner]);
    }
  mesh.normals.name = "N";
  mesh.normals.type = ValueType::Normal;
  mesh.normals.domain = Domain::Corner;
  mesh.normals.components = 3;
  mesh.normals.values.clear();
  std::vector<Vec3d> normals;
  for (uint32_t corner = 0; corner < placeOf.size(); ++corner)
    normals.push_back(displacer.newNormal(corner));
  if (displacer.findsNormals())
    findNormals(displacer, placeOf, mesh, normals);
  for (const Vec3d &n : normals)
    for (int k = 0; k < 3; ++k)
      mesh.normals.values.push_back(float(n[k]));
}

void anysl::render::displace(const Scene &scene, const Shader &shader,
                             std::span<const Binding> bound, const Shape &shape, AnyslLayout layout,
                             PointSet &points) {
  bool perspective = scene.description.camera.perspective;
  Displacer displacer(scene, shader, bound, shape, layout, points, points);
  displacer.run(uint32_t(points.vertices.size()), Domain::Point, [&](uint32_t i) {
    Displacer::Start start;
    start.hit.primitive = i;
    // A ball is moved by what faces the eye.
    const auto &[x, y, z, radius] = points.vertices[i];
    Vec3d center(x, y, z);
    Vec3d toEye = perspective ? normalized(-center) : Vec3d(0, 0, -1);
    start.origin = Vec3f(points.normals.empty() ? center + toEye * double(radius) : center);
    return start;
  });
  for (uint32_t i = 0; i < points.vertices.size(); ++i) {
    Vec3d way = displacer.newPlace(i) - displacer.oldPlaces[i], normal = displacer.newNormal(i);
    for (int k = 0; k < 3; ++k)
      points.vertices[i][size_t(k)] += float(way[k]);
    if (!points.normals.empty())
      points.normals[i] = Vec3f(normal);
  }
}
