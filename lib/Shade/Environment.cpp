//===-- lib/Shade/Environment.cpp - a world in closed form ------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Environment.h"
#include "lib/Textures/Answer.h"

#include <anysl/anysl.h>
#include <cmath>
#include <cstring>
#include <utility>

namespace anysl::shade {
namespace {

constexpr Matrix identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr double groundHeight = -1;
constexpr double far = 1e30;

const Environment &world(void *renderer) { return *static_cast<const Environment *>(renderer); }

/// What the world looks like in a direction, of any length. Without branches, so that the packet
/// form below becomes vector code. A length of zero sees nothing; double precision holds every
/// float's square.
struct Sky {
  static void look(double x, double y, double z, double *color) {
    static constexpr double horizon[3] = {0.9, 0.95, 1}, zenith[3] = {0.25, 0.5, 0.9};
    static constexpr double ground[3] = {0.3, 0.25, 0.2};
    double length = std::sqrt(x * x + y * y + z * z);
    double up = z / (length > 0 ? length : 1);
    for (int c = 0; c < 3; ++c) {
      double above = horizon[c] * (1 - up) + zenith[c] * up;
      double seen = up < 0 ? ground[c] : above;
      color[c] = length > 0 ? seen : 0;
    }
  }
};

struct Direction {
  static void look(double x, double y, double z, double *color) {
    double length = std::sqrt(x * x + y * y + z * z);
    double whole = length > 0 ? length : 1, half = length > 0 ? 0.5 : 0;
    color[0] = half + 0.5 * (x / whole);
    color[1] = half + 0.5 * (y / whole);
    color[2] = half + 0.5 * (z / whole);
  }
};

struct Black {
  static void look(double, double, double, double *color) { color[0] = color[1] = color[2] = 0; }
};

void trace(void *renderer, const AnyslShadeArgs *, uint32_t, const double *, const double *R,
           double *color) {
  switch (world(renderer).surroundings) {
  case Surroundings::Sky:
    return Sky::look(R[0], R[1], R[2], color);
  case Surroundings::Direction:
    return Direction::look(R[0], R[1], R[2], color);
  case Surroundings::Black:
    return Black::look(R[0], R[1], R[2], color);
  }
}

template <class World>
void lookPacket(uint32_t width, uint32_t mask, const float *__restrict R, float *__restrict color) {
  for (uint32_t lane = 0; lane < width; ++lane) {
    // Points that do not ask hold anything at all, also what would raise a floating-point
    // exception.
    bool asks = mask >> lane & 1;
    double x = asks ? R[lane] : 0, y = asks ? R[width + lane] : 0,
           z = asks ? R[2 * width + lane] : 1;
    double seen[3];
    World::look(x, y, z, seen);
    color[lane] = float(seen[0]);
    color[width + lane] = float(seen[1]);
    color[2 * width + lane] = float(seen[2]);
  }
}

template <class World>
void lookPacketOf(uint32_t width, uint32_t mask, const float *R, float *color) {
  switch (width) { // loops of a known length
  case 4:
    return lookPacket<World>(4, mask, R, color);
  case 8:
    return lookPacket<World>(8, mask, R, color);
  case 16:
    return lookPacket<World>(16, mask, R, color);
  default:
    return lookPacket<World>(width, mask, R, color);
  }
}

void tracePacket(void *renderer, const AnyslShadeArgs *, uint32_t, uint32_t width, uint32_t mask,
                 const float *, const float *R, float *color) {
  switch (world(renderer).surroundings) {
  case Surroundings::Sky:
    return lookPacketOf<Sky>(width, mask, R, color);
  case Surroundings::Direction:
    return lookPacketOf<Direction>(width, mask, R, color);
  case Surroundings::Black:
    return lookPacketOf<Black>(width, mask, R, color);
  }
}

double traceDistance(void *renderer, const AnyslShadeArgs *, uint32_t, const double *P,
                     const double *R) {
  double above = P[2] - groundHeight;
  if (world(renderer).surroundings == Surroundings::Black || !(R[2] < 0) || !(above > 0))
    return far;
  return above / -R[2] * std::hypot(R[0], R[1], R[2]);
}

void transmission(void *renderer, const AnyslShadeArgs *, uint32_t, const double *from,
                  const double *to, double *color) {
  bool crosses = (from[2] > groundHeight) != (to[2] > groundHeight);
  bool hidden = crosses && world(renderer).surroundings != Surroundings::Black;
  color[0] = color[1] = color[2] = hidden ? 0 : 1;
}

/// Serves the lanes of a packet one by one.
template <class Ask>
void forLanes(uint32_t width, uint32_t mask, const float *a, const float *b, Ask ask) {
  for (uint32_t lane = 0; lane < width; ++lane) {
    if (!(mask >> lane & 1))
      continue;
    double wideA[3], wideB[3];
    for (uint32_t c = 0; c < 3; ++c) {
      wideA[c] = a[c * width + lane];
      wideB[c] = b[c * width + lane];
    }
    ask(lane, wideA, wideB);
  }
}

void transmissionPacket(void *renderer, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                        uint32_t mask, const float *from, const float *to, float *color) {
  forLanes(width, mask, from, to, [&](uint32_t lane, const double *wideFrom, const double *wideTo) {
    double result[3];
    transmission(renderer, args, first + lane, wideFrom, wideTo, result);
    for (uint32_t c = 0; c < 3; ++c)
      color[c * width + lane] = float(result[c]);
  });
}

void traceDistancePacket(void *renderer, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                         uint32_t mask, const float *P, const float *R, float *distance) {
  forLanes(width, mask, P, R, [&](uint32_t lane, const double *wideP, const double *wideR) {
    distance[lane] = float(traceDistance(renderer, args, first + lane, wideP, wideR));
  });
}

int spaceMatrix(void *renderer, const AnyslShadeArgs *, const char *from, const char *to,
                double *matrix) {
  const auto &spaces = world(renderer).toCurrent;
  auto source = spaces.find(from), target = spaces.find(to);
  if (source == spaces.end() || target == spaces.end())
    return 0;
  Matrix back = inverse(target->second);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      double sum = 0;
      for (int k = 0; k < 4; ++k)
        sum += source->second[row * 4 + k] * back[k * 4 + column];
      matrix[row * 4 + column] = sum;
    }
  return 1;
}

void print(void *renderer, const AnyslShadeArgs *, uint32_t, const char *text) {
  std::fputs(text, world(renderer).printTo);
}

void texture(void *renderer, const AnyslShadeArgs *args, uint32_t, uint32_t width, uint32_t mask,
             const AnyslTextureRequest *request, const AnyslTexturePoints *points, float *result) {
  if (textures::Textures *textures = world(renderer).pictures->get())
    textures->texture(args, width, mask, *request, *points, result);
}

void environment(void *renderer, const AnyslShadeArgs *args, uint32_t, uint32_t width,
                 uint32_t mask, const AnyslTextureRequest *request,
                 const AnyslTexturePoints *points, float *result) {
  if (textures::Textures *textures = world(renderer).pictures->get())
    textures->environment(args, width, mask, *request, *points, result);
}

void shadow(void *renderer, const AnyslShadeArgs *args, uint32_t, uint32_t width, uint32_t mask,
            const AnyslTextureRequest *request, const AnyslTexturePoints *points, float *result) {
  if (textures::Textures *textures = world(renderer).pictures->get())
    textures->shadow(args, width, mask, *request, *points, result);
}

void traceHit(void *renderer, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
              uint32_t mask, const float *const *P, const float *const *R, const float *reach,
              const AnyslHits *hits) {
  for (uint32_t lane = 0; lane < width; ++lane) {
    if (!(mask >> lane & 1))
      continue;
    double from[3] = {P[0][lane], P[1][lane], P[2][lane]};
    double along[3] = {R[0][lane], R[1][lane], R[2][lane]};
    double distance = traceDistance(renderer, args, first + lane, from, along);
    bool hit = distance < far && distance <= double(reach[lane]);
    hits->distance[lane] = hit ? float(distance) : -1;
    double color[3];
    trace(renderer, args, first + lane, from, along, color);
    for (uint32_t c = 0; c < 3; ++c) {
      hits->N[c][lane] = hits->Ng[c][lane] = hit && c == 2 ? 1 : 0;
      hits->color[c][lane] = float(color[c]);
      hits->opacity[c][lane] = hit ? 1 : 0;
    }
  }
}

int callMethod(void *renderer, const AnyslShadeArgs *args, uint32_t point, const char *shader,
               AnyslMessage *message) {
  const auto &coshaders = static_cast<const Environment *>(renderer)->coshaders;
  auto found = coshaders.find(shader);
  return found != coshaders.end() ? anysl_method_call(found->second, args, point, message)
                                  : anysl_light_call(args, point, shader, message);
}

/// A shader says with its parameter __category what it belongs to.
bool belongsTo(const AnyslInstance &shader, const char *category) {
  const char *own = nullptr;
  return !*category || (anysl_instance_get_strings(&shader, "__category", &own, 1) == ANYSL_OK &&
                        !std::strcmp(own, category));
}

const char *shaderName(void *renderer, const AnyslShadeArgs *, const char *category,
                       uint32_t index) {
  for (const auto &[name, shader] : static_cast<const Environment *>(renderer)->coshaders)
    if (belongsTo(*shader, category) && !index--)
      return name.c_str();
  return nullptr;
}

int query(void *renderer, const AnyslShadeArgs *args, uint32_t, const AnyslQuery *query,
          AnyslCell *value) {
  std::string name = query->name;
  if (*query->subject)
    name = std::string(query->subject) + ":" + name;
  const auto &answers = world(renderer).answers;
  auto found = answers.find({query->kind, name});
  if (found == answers.end()) {
    if (query->kind != ANYSL_QUERY_textureinfo)
      return 0;
    textures::Textures *textures = world(renderer).pictures->get();
    return textures ? textures::answer(*textures, renderer, args, *query, value) : 0;
  }
  const KnownValue &known = found->second;
  size_t components = anysl_type_components(query->type);
  size_t have =
      query->type == ANYSL_STRING ? known.texts.size() : known.numbers.size() / components;
  size_t elements = query->array_length == ANYSL_ANY_LENGTH ? have
                    : query->array_length                   ? query->array_length
                                                            : 1;
  if (query->type == ANYSL_STRING) {
    if (known.texts.size() != elements || query->element >= elements)
      return 0;
    value->string = known.texts[query->element].c_str();
    return 1;
  }
  // A single number also does for a triple or a matrix.
  if (known.numbers.size() == 1 && !query->array_length) {
    AnyslCell cell = {known.numbers[0]};
    return anysl_answer(query, ANYSL_FLOAT, 0, &cell, value);
  }
  if (known.numbers.size() != components * elements || query->element >= elements)
    return 0;
  for (size_t c = 0; c < components; ++c)
    value[c].number = known.numbers[query->element * components + c];
  return 1;
}

} // namespace

Environment::Environment() {
  answers[{ANYSL_QUERY_rendererinfo, "renderer"}].texts = {"anysl-shade"};
  answers[{ANYSL_QUERY_rayinfo, "depth"}] = {{"0"}, {0}};
  answers[{ANYSL_QUERY_rayinfo, "type"}].texts = {"camera"};
  for (const char *name : {"", "current", "camera", "world", "object", "shader"})
    toCurrent[name] = identity;
}

AnyslServices environmentServices() {
  AnyslServices services = {};
  services.struct_size = sizeof services;
  services.trace = trace;
  services.trace_packet = tracePacket;
  services.trace_distance = traceDistance;
  services.trace_distance_packet = traceDistancePacket;
  services.transmission = transmission;
  services.transmission_packet = transmissionPacket;
  services.space_matrix = spaceMatrix;
  services.print = print;
  services.texture = texture;
  services.environment = environment;
  services.shadow = shadow;
  services.trace_hit = traceHit;
  services.call_method = callMethod;
  services.shader_name = shaderName;
  services.query = query;
  return services;
}

// Gauss-Jordan elimination with row pivots.
Matrix inverse(const Matrix &matrix) {
  Matrix left = matrix, right = identity;
  for (int column = 0; column < 4; ++column) {
    int pivot = column;
    for (int row = column + 1; row < 4; ++row)
      if (std::fabs(left[row * 4 + column]) > std::fabs(left[pivot * 4 + column]))
        pivot = row;
    for (int k = 0; k < 4; ++k) {
      std::swap(left[column * 4 + k], left[pivot * 4 + k]);
      std::swap(right[column * 4 + k], right[pivot * 4 + k]);
    }
    double scale = 1 / left[column * 4 + column];
    for (int k = 0; k < 4; ++k) {
      left[column * 4 + k] *= scale;
      right[column * 4 + k] *= scale;
    }
    for (int row = 0; row < 4; ++row) {
      double factor = left[row * 4 + column];
      for (int k = 0; row != column && k < 4; ++k) {
        left[row * 4 + k] -= factor * left[column * 4 + k];
        right[row * 4 + k] -= factor * right[column * 4 + k];
      }
    }
  }
  return right;
}

} // namespace anysl::shade
