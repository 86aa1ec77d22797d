//===-- lib/Textures/Textures.cpp - the texture services of a renderer --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Textures/Textures.h"

#include "lib/Textures/Lookup.h"
#include "lib/Textures/ShadowMap.h"

namespace anysl::textures {
namespace {

static_assert(Batch::size >= 16, "all points of a call fit into one batch");

/// Calls f(i) for each point of a mask.
template <typename F>
void forPoints(uint32_t width, uint32_t mask, const F &f) {
  for (uint32_t i = 0; i < width; ++i)
    if (mask >> i & 1)
      f(i);
}

/// Whether a caller, which may be older than the member, asks how values change.
bool asksForSlopes(const AnyslTexturePoints &points) {
  return points.struct_size >= offsetof(AnyslTexturePoints, result_by) + sizeof points.result_by &&
         points.result_by[0];
}

class OiioTextures final : public Textures {
public:
  explicit OiioTextures(TextureSettings settings) : files(std::move(settings)) {}

  void texture(const AnyslShadeArgs *, uint32_t width, uint32_t mask,
               const AnyslTextureRequest &request, const AnyslTexturePoints &points,
               float *result) override {
    const File &file = files.find(request.name);
    const float *const *at = points.at, *const *x = points.dx, *const *y = points.dy;
    if (!file.handle)
      return forPoints(width, mask, [&](uint32_t i) {
        lookUpMissing(request, at[0][i], at[1][i], i, width, result);
      });
    Batch batch;
    forPoints(width, mask, [&](uint32_t i) {
      batch.set(i, at[0][i], at[1][i], x[0][i], x[1][i], y[0][i], y[1][i], points.blur[0][i],
                points.blur[1][i]);
    });
    Values values = {result};
    if (asksForSlopes(points))
      values.byS = points.result_by[0], values.byT = points.result_by[1];
    lookUp(files, file, request, batch, width, values);
  }

  void environment(const AnyslShadeArgs *, uint32_t width, uint32_t mask,
                   const AnyslTextureRequest &request, const AnyslTexturePoints &points,
                   float *result) override {
    const File &file = files.find(request.name);
    AnyslTextureRequest wrapped = request;
    bool isCube =
        file.layout == EnvironmentLayout::CubeColumn || file.layout == EnvironmentLayout::CubeRows;
    wrapped.swrap = isCube ? "clamp" : "periodic";
    wrapped.twrap = "clamp";
    auto vector = [](const float *const *v, uint32_t i) {
      return Direction{v[0][i], v[1][i], v[2][i]};
    };
    Batch batch;
    std::array<PictureFilter, Batch::size> filters;
    forPoints(width, mask, [&](uint32_t i) {
      PictureFilter &f = filters[i];
      bool isDirection = findDirection(file.layout, vector(points.at, i), vector(points.dx, i),
                                       vector(points.dy, i), f);
      if (!file.handle)
        lookUpMissing(request, float(f.s), float(f.t), i, width, result);
      else if (isDirection)
        batch.set(i, float(f.s), float(f.t), float(f.ds[0]), float(f.dt[0]), float(f.ds[1]),
                  float(f.dt[1]), points.blur[0][i], points.blur[1][i]);
    });
    if (!file.handle)
      return;
    std::array<float, 3 * Batch::size> byS, byT;
    Values values = {result};
    if (asksForSlopes(points))
      values.byS = byS.data(), values.byT = byT.data();
    lookUp(files, file, wrapped, batch, width, values);
    for (uint32_t k = 0; values.byS && k < 3; ++k)
      for (uint32_t c = 0; c < request.channels; ++c)
        forPoints(width, mask, [&](uint32_t i) {
          uint32_t at = c * width + i;
          points.result_by[k][at] =
              float(byS[at] * filters[i].sBy[k] + byT[at] * filters[i].tBy[k]);
        });
  }

  void shadow(const AnyslShadeArgs *args, uint32_t width, uint32_t mask,
              const AnyslTextureRequest &request, const AnyslTexturePoints &points,
              float *result) override {
    std::fill_n(result, width, 0.0f);
    const File &file = files.find(request.name);
    if (!file.handle)
      return;
    std::optional<ShadowMap> map = ShadowMap::open(files, file, request, args);
    if (map)
      forPoints(width, mask, [&](uint32_t i) { result[i] = map->shadowAt(points, i); });
  }

  void tellPlaces(std::function<void(const std::string &)> tell) override {
    files.tellPlaces(std::move(tell));
  }

  std::optional<TextureFact> fact(const std::string &name, const std::string &what) override;

private:
  Files files;
};

TextureFact number(double x) { return {{x}, std::nullopt}; }

TextureFact matrix(const std::array<float, 16> &m) {
  return {std::vector<double>(m.begin(), m.end()), std::nullopt};
}

/// An entry of the file's own metadata.
std::optional<TextureFact> metadata(const OIIO::ImageSpec &spec, const std::string &name) {
  const OIIO::ParamValue *value = spec.find_attribute(name);
  if (!value)
    return std::nullopt;
  if (value->type() == OIIO::TypeString)
    return TextureFact{{}, value->get_string()};
  TextureFact fact;
  for (int i = 0; i < int(value->type().numelements() * value->type().aggregate); ++i)
    fact.numbers.push_back(value->get_float_indexed(i));
  return fact;
}

std::optional<TextureFact> OiioTextures::fact(const std::string &name, const std::string &what) {
  if (what == "exists")
    return number(files.exists(name));
  if (!files.exists(name))
    return std::nullopt;
  const File &file = files.find(name.c_str());
  OIIO::ImageSpec spec;
  if (!file.handle || !files.system().get_imagespec(file.handle, nullptr, 0, spec))
    return std::nullopt;
  if (what == "resolution")
    return TextureFact{{double(spec.full_width), double(spec.full_height)}, std::nullopt};
  if (what == "channels")
    return number(spec.nchannels);
  if (what == "bitsperchannel")
    return number(double(spec.format.size()) * 8);
  if (what == "type") {
    std::string format = spec.get_string_attribute("textureformat");
    bool isEnvironment = format.find("Environment") != std::string::npos;
    return TextureFact{{},
                       file.worldToCamera ? "shadow"
                       : isEnvironment    ? "environment"
                                          : "texture"};
  }
  if (what == "viewingmatrix")
    return file.worldToCamera ? std::optional(matrix(*file.worldToCamera)) : std::nullopt;
  if (what == "projectionmatrix")
    return file.worldToScreen ? std::optional(matrix(*file.worldToScreen)) : std::nullopt;
  return metadata(spec, what);
}

} // namespace

std::unique_ptr<Textures> Textures::create(TextureSettings settings) {
  return std::make_unique<OiioTextures>(std::move(settings));
}

} // namespace anysl::textures
