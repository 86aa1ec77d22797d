//===-- tools/anysl-render/PictureError.cpp - how far pictures are from each other ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The names and constants of FLIP are those of the paper: first what the eye blurs at that distance
// is filtered out and colours are compared in a perceptually uniform space (sections 4.1.1 to
// 4.1.3), then differences of edges and points raise the result (section 4.2).
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/PictureError.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace anysl::render;

namespace {

constexpr double pixelsPerDegree = 0.7 * 3840 / 0.7 * std::numbers::pi / 180;

using Color = std::array<double, 3>;

struct Plane {
  int width, height;
  std::vector<double> values;

  Plane(int width, int height)
      : width(width), height(height), values(size_t(width) * size_t(height)) {}
  /// Beyond the edge the picture goes on as at its edge.
  double at(int x, int y) const {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return values[size_t(y) * size_t(width) + size_t(x)];
  }
};

/// A filter of one row or column, from -radius to +radius.
using Kernel = std::vector<double>;

Plane filtered(const Plane &from, const Kernel &alongX, const Kernel &alongY) {
  Plane rows(from.width, from.height), result = rows;
  auto pass = [](const Plane &source, Plane &target, const Kernel &kernel, int dx, int dy) {
    int radius = int(kernel.size()) / 2;
    for (int y = 0; y < source.height; ++y)
      for (int x = 0; x < source.width; ++x) {
        double sum = 0;
        for (int k = -radius; k <= radius; ++k)
          sum += kernel[size_t(k + radius)] * source.at(x + k * dx, y + k * dy);
        target.values[size_t(y) * size_t(source.width) + size_t(x)] = sum;
      }
  };
  pass(from, rows, alongX, 1, 0);
  pass(rows, result, alongY, 0, 1);
  return result;
}

template <typename Function>
Kernel kernel(int radius, Function value) {
  Kernel result;
  for (int k = -radius; k <= radius; ++k)
    result.push_back(value(double(k)));
  return result;
}

/// Scales the positive weights to the sum 1, and the negative ones to -1.
Kernel normalized(Kernel from) {
  double positive = 0, negative = 0;
  for (double weight : from)
    (weight > 0 ? positive : negative) += weight;
  for (double &weight : from)
    weight /= weight > 0 ? positive : negative < 0 ? -negative : 1;
  return from;
}

//===-- Colours -------------------------------------------------------------------------------===//

constexpr double toXYZ[3][3] = {
    {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
    {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
    {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
constexpr double toRGB[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                {-0.969224334, 1.875930071, 0.041554224},
                                {0.055639423, -0.204011202, 1.057148933}};

Color times(const double (&matrix)[3][3], const Color &c) {
  Color result;
  for (size_t i = 0; i < 3; ++i)
    result[i] = matrix[i][0] * c[0] + matrix[i][1] * c[1] + matrix[i][2] * c[2];
  return result;
}

/// The white of a screen, as X, Y and Z.
const Color white = times(toXYZ, {1, 1, 1});

/// A linearised L*a*b*: luminance, and opponent colours.
Color toYCxCz(const Color &rgb) {
  Color c = times(toXYZ, rgb);
  double x = c[0] / white[0], y = c[1] / white[1], z = c[2] / white[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Color fromYCxCz(const Color &c) {
  double y = (c[0] + 16) / 116, x = y + c[1] / 500, z = y - c[2] / 200;
  return times(toRGB, {x * white[0], y * white[1], z * white[2]});
}

/// L*a*b*, its colours paled where it is dark (Hunt's effect).
Color toHuntLab(const Color &rgb) {
  Color c = times(toXYZ, rgb);
  for (size_t i = 0; i < 3; ++i) {
    constexpr double delta = 6.0 / 29;
    double t = c[i] / white[i];
    c[i] = t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  }
  double L = 116 * c[1] - 16;
  return {L, 0.01 * L * 500 * (c[0] - c[1]), 0.01 * L * 200 * (c[1] - c[2])};
}

double hyAB(const Color &a, const Color &b) {
  return std::fabs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

/// What a screen shows of a linear number.
double shown(float value) { return value > 0 ? std::min(double(value), 1.0) : 0; }

//===-- The two pipelines ---------------------------------------------------------------------===//

/// A picture as the eye sees it from afar, in L*a*b*, and its edges and points.
class Seen {
public:
  explicit Seen(const Film &film) : width(film.width), height(film.height) {
    std::vector<Plane> opponent(3, Plane(width, height));
    for (size_t i = 0; i < film.pixels.size(); ++i) {
      const auto &pixel = film.pixels[i];
      Color c = toYCxCz({shown(pixel[0]), shown(pixel[1]), shown(pixel[2])});
      for (size_t k = 0; k < 3; ++k)
        opponent[k].values[i] = c[k];
    }
    findFeatures(opponent[0]);
    blur(opponent);
    lab.resize(film.pixels.size());
    for (size_t i = 0; i < lab.size(); ++i) {
      Color rgb = fromYCxCz({opponent[0].values[i], opponent[1].values[i], opponent[2].values[i]});
      for (double &channel : rgb)
        channel = std::clamp(channel, 0.0, 1.0);
      lab[i] = toHuntLab(rgb);
    }
  }

  std::vector<Color> lab;
  std::vector<double> edges, points;

private:
  /// The eye's contrast sensitivity, as sums of Gaussians of the distance in degrees.
  static void blur(std::vector<Plane> &planes) {
    struct Gaussians {
      double a1, b1, a2, b2;
    } const channels[3] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
    constexpr double pi = std::numbers::pi, widest = 0.04;
    int radius = int(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixelsPerDegree));
    for (size_t k = 0; k < 3; ++k) {
      const Gaussians &g = channels[k];
      auto gaussian = [&](double b) {
        return kernel(radius, [=](double x) {
          double degrees = x / pixelsPerDegree;
          return std::exp(-pi * pi * degrees * degrees / b);
        });
      };
      // A sum of Gaussians in two dimensions is no product, but each of them is.
      auto sumOf = [](const Kernel &kernel) {
        double sum = 0;
        for (double weight : kernel)
          sum += weight;
        return sum;
      };
      Kernel first = gaussian(g.b1), second = gaussian(g.b2);
      double w1 = g.a1 * std::sqrt(pi / g.b1) * sumOf(first) * sumOf(first);
      double w2 = g.a2 * std::sqrt(pi / g.b2) * sumOf(second) * sumOf(second);
      Plane one = filtered(planes[k], normalized(first), normalized(first));
      if (w2 > 0) {
        Plane two = filtered(planes[k], normalized(second), normalized(second));
        for (size_t i = 0; i < one.values.size(); ++i)
          one.values[i] = (w1 * one.values[i] + w2 * two.values[i]) / (w1 + w2);
      }
      planes[k] = std::move(one);
    }
  }

  void findFeatures(Plane luminance) {
    for (double &y : luminance.values)
      y = (y + 16) / 116;
    constexpr double featureWidth = 0.082; // degrees
    const double sd = 0.5 * featureWidth * pixelsPerDegree;
    int radius = int(std::ceil(3 * sd));
    auto gaussian = [=](double x) { return std::exp(-x * x / (2 * sd * sd)); };
    Kernel smooth = normalized(kernel(radius, gaussian));
    Kernel edge = normalized(kernel(radius, [=](double x) { return -x * gaussian(x); }));
    Kernel point =
        normalized(kernel(radius, [=](double x) { return (x * x / (sd * sd) - 1) * gaussian(x); }));
    auto magnitude = [&](const Kernel &derivative) {
      Plane x = filtered(luminance, derivative, smooth),
            y = filtered(luminance, smooth, derivative);
      std::vector<double> result(x.values.size());
      for (size_t i = 0; i < result.size(); ++i)
        result[i] = std::hypot(x.values[i], y.values[i]);
      return result;
    };
    edges = magnitude(edge);
    points = magnitude(point);
  }

  int width, height;
};

/// Spreads colour distances over [0, 1], the small ones over most of it.
double redistributed(double distance) {
  constexpr double qc = 0.7, pc = 0.4, pt = 0.95;
  static const double most = std::pow(hyAB(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1})), qc);
  double error = std::pow(distance, qc), limit = pc * most;
  return error < limit ? pt / limit * error : pt + (error - limit) / (most - limit) * (1 - pt);
}

} // namespace

double anysl::render::rootMeanSquare(const Film &a, const Film &b) {
  double sum = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i)
    for (size_t k = 0; k < 3; ++k) {
      double difference = double(a.pixels[i][k]) - double(b.pixels[i][k]);
      sum += difference * difference;
    }
  return std::sqrt(sum / (3 * double(std::max<size_t>(a.pixels.size(), 1))));
}

double anysl::render::flipMean(const Film &reference, const Film &test) {
  Seen a(reference), b(test);
  double sum = 0;
  for (size_t i = 0; i < a.lab.size(); ++i) {
    double color = redistributed(hyAB(a.lab[i], b.lab[i]));
    double difference =
        std::max(std::fabs(a.edges[i] - b.edges[i]), std::fabs(a.points[i] - b.points[i]));
    double feature = std::sqrt(difference / std::numbers::sqrt2);
    sum += std::pow(color, 1 - std::clamp(feature, 0.0, 1.0));
  }
  return sum / double(std::max<size_t>(a.lab.size(), 1));
}
