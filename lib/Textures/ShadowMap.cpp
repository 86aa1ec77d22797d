//===-- lib/Textures/ShadowMap.cpp - pictures of depths -----------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Textures/ShadowMap.h"

#include <algorithm>
#include <cmath>

namespace anysl::textures {
namespace {

using Matrix = std::array<double, 16>;

Matrix product(const Matrix &a, const std::array<float, 16> &b) {
  Matrix result;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      double sum = 0;
      for (int k = 0; k < 4; ++k)
        sum += a[row * 4 + k] * double(b[k * 4 + column]);
      result[row * 4 + column] = sum;
    }
  return result;
}

} // namespace

std::optional<ShadowMap> ShadowMap::open(Files &files, const File &file,
                                         const AnyslTextureRequest &request,
                                         const AnyslShadeArgs *args) {
  if (!file.worldToCamera || !file.worldToScreen) {
    files.warnOnce("shadow map '" + std::string(request.name) +
                   "' does not say from where it was made: it lacks 'worldtocamera' or "
                   "'worldtoscreen'");
    return std::nullopt;
  }
  Matrix toWorld = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  if (args && args->services && args->services->space_matrix)
    args->services->space_matrix(args->renderer, args, "current", "world", toWorld.data());
  ShadowMap map(files, file, request);
  map.toCamera = product(toWorld, *file.worldToCamera);
  map.toScreen = product(toWorld, *file.worldToScreen);
  return map;
}

ShadowMap::Projected ShadowMap::project(double x, double y, double z) const {
  auto column = [&](const Matrix &m, int k) {
    return x * m[k] + y * m[4 + k] + z * m[8 + k] + m[12 + k];
  };
  double w = column(toScreen, 3);
  bool inside = w > 0;
  double scale = inside ? 1 / w : 0;
  double cameraW = column(toCamera, 3);
  return {0.5 + 0.5 * column(toScreen, 0) * scale, 0.5 - 0.5 * column(toScreen, 1) * scale,
          column(toCamera, 2) / (cameraW != 0 ? cameraW : 1), inside};
}

float ShadowMap::shadowAt(const AnyslTexturePoints &points, uint32_t i) {
  const float *const *at = points.at, *const *dx = points.dx, *const *dy = points.dy;
  Projected here = project(at[0][i], at[1][i], at[2][i]);
  if (!here.isInside || !std::isfinite(here.s) || !std::isfinite(here.t))
    return 0;
  Projected x = project(double(at[0][i]) + dx[0][i], double(at[1][i]) + dx[1][i],
                        double(at[2][i]) + dx[2][i]);
  Projected y = project(double(at[0][i]) + dy[0][i], double(at[1][i]) + dy[1][i],
                        double(at[2][i]) + dy[2][i]);
  auto axis = [&](const Projected &end, double &s, double &t) {
    s = end.isInside && std::isfinite(end.s) ? std::clamp(end.s - here.s, -1.0, 1.0) : 0;
    t = end.isInside && std::isfinite(end.t) ? std::clamp(end.t - here.t, -1.0, 1.0) : 0;
  };
  double sx, tx, sy, ty;
  axis(x, sx, tx);
  axis(y, sy, ty);
  auto positive = [](float b) { return b > 0 && b < 1 ? double(b) : b >= 1 ? 1.0 : 0.0; };
  double sblur = positive(points.blur[0][i]), tblur = positive(points.blur[1][i]);
  // Samples at the centres of a grid's cells, over the filter and, in the same order, the blur.
  bool isPoint = sx == 0 && tx == 0 && sy == 0 && ty == 0 && sblur == 0 && tblur == 0;
  auto side = int(std::ceil(std::sqrt(double(std::clamp(request.samples, 1u, 4096u)))));
  if (isPoint)
    side = 1;
  AnyslTextureRequest depths = request;
  depths.channels = 1, depths.first_channel = 0, depths.fill = ANYSL_NO_FILL;
  depths.filter = "closest", depths.swrap = depths.twrap = "clamp";
  int hidden = 0;
  for (int first = 0; first < side * side; first += Batch::size) {
    Batch batch;
    batch.options.mipmode = OIIO::Tex::MipMode::NoMIP;
    for (int k = 0; k < Batch::size && first + k < side * side; ++k) {
      double a = ((first + k) % side + 0.5) / side - 0.5,
             b = ((first + k) / side + 0.5) / side - 0.5;
      double s = here.s + a * sx + b * sy + a * sblur, t = here.t + a * tx + b * ty + b * tblur;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
        batch.set(uint32_t(k), float(s), float(t), 0, 0, 0, 0, 0, 0);
    }
    float depth[Batch::size];
    lookUp(files, file, depths, batch, Batch::size, {depth});
    for (int k = 0; k < Batch::size; ++k)
      hidden += batch.mask >> k & 1 && here.depth - double(request.bias) > double(depth[k]);
  }
  return float(hidden) / float(side * side);
}

} // namespace anysl::textures
