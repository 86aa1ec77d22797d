//===-- tools/anysl-render/Imager.cpp - shaders of finished pixels ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// An imager sees pixels before exposure and encoding: their colour, opacity and coverage, and where
// they are. Its "current" space is the raster, so that P is a pixel's place as a number and as a
// point of every other space.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Imager.h"
#include "tools/anysl-render/Scene.h"

#include <tbb/parallel_for.h>

#include <atomic>

using namespace anysl::render;

namespace {

struct FreeBatch {
  void operator()(AnyslBatch *batch) const { anysl_batch_free(batch); }
};
using BatchHandle = std::unique_ptr<AnyslBatch, FreeBatch>;

void check(AnyslStatus status) {
  if (status != ANYSL_OK)
    throw UserError(anysl_last_error());
}

/// Works on the pixels [x0, x1) of row y.
class ImagerRow {
public:
  ImagerRow(const Scene &scene, Film &film, int x0, int x1, int y)
      : scene(scene), film(film), shader(*scene.imager()), count(uint32_t(x1 - x0)), x0(x0), y(y),
        first(size_t(y) * size_t(film.width) + size_t(x0)) {}

  uint64_t run();

private:
  const Scene &scene;
  Film &film;
  const Shader &shader;
  uint32_t count;
  int x0, y;
  size_t first;
  BatchHandle batch;
};

uint64_t ImagerRow::run() {
  AnyslBatch *created = nullptr;
  constexpr uint64_t outputs =
      uint64_t(1) << ANYSL_Ci | uint64_t(1) << ANYSL_Oi | uint64_t(1) << ANYSL_alpha;
  check(anysl_batch_create(shader.instance.get(), count, outputs, &created));
  batch.reset(created);

  const Channel *opacity = film.channels.find("Oi");
  std::vector<float> places(3 * count), opacities(3 * count);
  std::vector<uint32_t> seeds;
  for (uint32_t i = 0; i < count; ++i) {
    places[3 * i] = float(x0) + float(i) + 0.5f;
    places[3 * i + 1] = float(y) + 0.5f;
    seeds.push_back(uint32_t(first + i));
    for (unsigned k = 0; k < 3; ++k)
      opacities[3 * i + k] =
          opacity ? film.extra[(first + i) * film.channels.size() + opacity->first + k]
                  : film.pixels[first + i][3];
  }
  float *pixels = film.pixels[first].data();
  check(anysl_batch_write_float(created, ANYSL_P, 0, count, places.data(), 3));
  check(anysl_batch_write_float(created, ANYSL_Ci, 0, count, pixels, 4));
  check(anysl_batch_write_float(created, ANYSL_Oi, 0, count, opacities.data(), 3));
  check(anysl_batch_write_float(created, ANYSL_alpha, 0, count, pixels + 3, 4));
  const float time = float(scene.description.camera.shutterOpen), ncomps = 3;
  check(anysl_batch_write_float(created, ANYSL_time, 0, count, &time, 0));
  check(anysl_batch_write_float(created, ANYSL_ncomps, 0, count, &ncomps, 0));
  check(anysl_batch_set_seeds(created, seeds.data()));
  check(anysl_shade(shader.instance.get(), created, 0, count, shader.width));
  check(anysl_batch_read_float(created, ANYSL_Ci, 0, count, pixels, 4));
  check(anysl_batch_read_float(created, ANYSL_alpha, 0, count, pixels + 3, 4));
  check(anysl_batch_read_float(created, ANYSL_Oi, 0, count, opacities.data(), 3));

  uint64_t bad = 0;
  for (uint32_t i = 0; i < count; ++i) {
    auto &pixel = film.pixels[first + i];
    bool good = true;
    for (float value : pixel)
      good &= std::isfinite(value);
    if (!good)
      pixel = {}, ++bad;
    for (unsigned k = 0; opacity && k < 3; ++k)
      film.extra[(first + i) * film.channels.size() + opacity->first + k] = opacities[3 * i + k];
  }
  return bad;
}

} // namespace

uint64_t anysl::render::runImager(const Scene &scene, Film &film) {
  int x0, x1, y0, y1;
  scene.camera.cropPixels(x0, x1, y0, y1);
  std::atomic<uint64_t> bad = 0;
  if (x0 < x1)
    tbb::parallel_for(y0, y1, [&](int y) { bad += ImagerRow(scene, film, x0, x1, y).run(); });
  return bad;
}
