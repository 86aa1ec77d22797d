//===-- tools/anysl-render/Render.cpp - tiles in threads --------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Render.h"
#include "tools/anysl-render/Imager.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

using namespace anysl::render;

namespace {

constexpr int tileSize = 32;
constexpr int blockSize = 4; ///< rays of neighbouring pixels follow each other

/// Renders pixels of one tile.
class TileJob {
public:
  TileJob(const Host &host, const PixelSampler &sampler, Film &film, ThreadState &state)
      : host(host), sampler(sampler), film(film), state(state) {}

  void run(int x0, int x1, int y0, int y1);
  uint64_t badPixels = 0;

private:
  void flush();
  void normalizeWeights();
  void addChannels(size_t pixel, float weight, const Radiance &radiance, float *numbers);

  const Host &host;
  const PixelSampler &sampler;
  Film &film;
  ThreadState &state;
  std::vector<Ray> rays;
  std::vector<size_t> pixelOf;
  std::vector<float> weightOf; ///< once flush() begins, of a pixel's samples the sum is 1
  std::vector<Radiance> results;
  std::vector<float> channels;           ///< of each ray
  std::map<size_t, unsigned> badSamples; ///< by pixel; nearly always empty
};

void TileJob::run(int x0, int x1, int y0, int y1) {
  for (int blockY = y0; blockY < y1; blockY += blockSize)
    for (int blockX = x0; blockX < x1; blockX += blockSize) {
      for (unsigned index = 0; index < sampler.samplesPerPixel(); ++index)
        for (int y = blockY; y < std::min(y1, blockY + blockSize); ++y)
          for (int x = blockX; x < std::min(x1, blockX + blockSize); ++x) {
            PixelSample sample = sampler.sample(x, y, index);
            rays.push_back(host.scene().camera.ray(sample.x, sample.y, sample.seed, sample.lensX,
                                                   sample.lensY));
            pixelOf.push_back(size_t(y) * size_t(film.width) + size_t(x));
            weightOf.push_back(float(sample.weight));
          }
      if (rays.size() >= host.preferredCount())
        flush();
    }
  flush();
}

void TileJob::flush() {
  const Channels &wanted = film.channels;
  results.resize(rays.size());
  channels.resize(rays.size() * wanted.size());
  for (size_t i = 0; i < rays.size(); ++i)
    wanted.clear(channels.data() + i * wanted.size());
  host.trace(state, rays.data(), uint32_t(rays.size()), results.data(), channels.data());
  const bool opaque = host.scene().background.isVisible();
  normalizeWeights();
  for (size_t i = 0; i < rays.size(); ++i) {
    // Samples come in the order of their numbers, so that the sum is the same every time.
    const Radiance &r = results[i];
    if (!isFinite(r.color) || !std::isfinite(r.alpha)) {
      ++badSamples[pixelOf[i]];
      continue;
    }
    auto &pixel = film.pixels[pixelOf[i]];
    const float weight = weightOf[i];
    for (int k = 0; k < 3; ++k)
      pixel[size_t(k)] += r.color[k] * weight;
    pixel[3] += opaque ? weight : r.alpha * weight;
    if (wanted.size() > 0)
      addChannels(pixelOf[i], weight, r, channels.data() + i * wanted.size());
  }
  // All samples of a pixel are in the same flush.
  for (auto [index, bad] : badSamples) {
    unsigned good = sampler.samplesPerPixel() - bad;
    float scale = good > 0 ? float(sampler.samplesPerPixel()) / float(good) : 0;
    for (float &value : film.pixels[index])
      value *= scale;
    for (const Channel &channel : wanted.list())
      for (unsigned k = 0; channel.source != Channel::Depth && k < channel.components; ++k)
        film.extra[index * wanted.size() + channel.first + k] *= scale;
  }
  badPixels += badSamples.size();
  badSamples.clear();
  rays.clear();
  pixelOf.clear();
  weightOf.clear();
}

void TileJob::normalizeWeights() {
  const float all = float(sampler.samplesPerPixel());
  if (!sampler.hasWeights()) {
    std::fill(weightOf.begin(), weightOf.end(), 1 / all);
    return;
  }
  // All samples of a pixel are in the same flush. Where by chance most of the few samples lie where
  // the filter is negative, the pixel is better without it.
  std::map<size_t, float> sums;
  for (size_t i = 0; i < weightOf.size(); ++i)
    sums[pixelOf[i]] += weightOf[i];
  for (size_t i = 0; i < weightOf.size(); ++i) {
    float sum = sums[pixelOf[i]];
    weightOf[i] = sum < 0.25f * all ? 1 / all : weightOf[i] / sum;
  }
}

void TileJob::addChannels(size_t pixel, float weight, const Radiance &radiance, float *numbers) {
  float *sums = film.extra.data() + pixel * film.channels.size();
  for (const Channel &channel : film.channels.list())
    for (unsigned k = 0; k < channel.components; ++k) {
      float value = numbers[channel.first + k], &sum = sums[channel.first + k];
      if (channel.source == Channel::Opacity)
        value = radiance.opacity[int(k)];
      // A mean of distances is the distance of nothing.
      sum = channel.source == Channel::Depth ? std::min(sum, value)
            : std::isfinite(value)           ? sum + value * weight
                                             : sum;
    }
}

} // namespace

RenderResult anysl::render::render(const Host &host, const RenderOptions &options) {
  using Clock = std::chrono::steady_clock;
  const Scene &scene = host.scene();
  RenderResult result;
  Film &film = result.film;
  film.width = scene.camera.width();
  film.height = scene.camera.height();
  film.pixels.resize(size_t(film.width) * size_t(film.height));
  film.channels = scene.channels();
  film.extra.resize(film.pixels.size() * film.channels.size());
  for (size_t i = 0; i < film.pixels.size() && film.channels.size() > 0; ++i)
    film.channels.clear(film.extra.data() + i * film.channels.size());
  int cropX0, cropX1, cropY0, cropY1;
  scene.camera.cropPixels(cropX0, cropX1, cropY0, cropY1);
  PixelSampler sampler(scene.description);

  int columns = (cropX1 - cropX0 + tileSize - 1) / tileSize;
  int rows = (cropY1 - cropY0 + tileSize - 1) / tileSize;
  std::atomic<int> done = 0;
  std::atomic<uint64_t> badPixels = 0;
  std::atomic<bool> stop = false;
  std::mutex progressLock;
  tbb::enumerable_thread_specific<ThreadState> states;

  auto begin = Clock::now();
  uint64_t ticks = __rdtsc();
  tbb::parallel_for(
      0, rows * columns,
      [&](int tile) {
        if (stop || (options.cancelled && options.cancelled())) {
          stop = true;
          return;
        }
        ThreadState &state = states.local();
        state.timed = options.timed;
        state.recorder = options.recorder;
        state.again = options.again;
        int x0 = cropX0 + tile % columns * tileSize, y0 = cropY0 + tile / columns * tileSize;
        TileJob job(host, sampler, film, state);
        job.run(x0, std::min(x0 + tileSize, cropX1), y0, std::min(y0 + tileSize, cropY1));
        badPixels += job.badPixels;
        int finished = ++done;
        if (std::unique_lock lock(progressLock, std::try_to_lock); lock && options.progress)
          options.progress(double(finished) / (rows * columns));
      },
      tbb::simple_partitioner());
  ticks = __rdtsc() - ticks;
  result.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  for (const ThreadState &state : states)
    result.counts += state.counts;
  if (ticks > 0)
    result.shadingSeconds = double(result.counts.shadingTicks) * result.seconds / double(ticks);
  result.complete = !stop;
  if (scene.imager() && result.complete)
    badPixels += runImager(scene, film);
  film.badPixels = badPixels;
  return result;
}
