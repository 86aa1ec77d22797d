//===-- lib/Host/LightShaders.cpp - runs light shaders for other shaders ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What a renderer gets that offers no service `light` of its own.
//
// diffuse(), specular() and so on ask for the same positions one after the other. Results are kept
// by light for sixteen points at a time, from anysl_lights_begin() to anysl_lights_end(), during
// which nothing but the position and the normal can change that a light shader sees. What depends
// on values that were sent is kept apart, for the point that was asked last and the values sent to
// it.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/LightRun.h"
#include "lib/Host/Message.h"
#include <algorithm>
#include <string_view>

using namespace anysl::host;

//===-- What is kept --------------------------------------------------------------------------===//

namespace {

/// A light shader's parameters with values that were sent, and what it gave with them.
struct SentAnswer {
  std::string what;
  std::vector<double> numbers;
  std::vector<std::string> texts;
  std::vector<AnyslCell> cells; ///< texts in them live in `texts`
  Answer answer;

  bool isOf(const AnyslMessage &sent) const {
    return what == sent.what && texts.size() == sent.text_count &&
           std::equal(numbers.begin(), numbers.end(), sent.numbers,
                      sent.numbers + sent.number_count) &&
           std::equal(texts.begin(), texts.end(), sent.texts);
  }
  void set(const AnyslInstance &light, const AnyslMessage &sent);
};

} // namespace

/// The answers for one call that shades, by light.
struct anysl::host::LightCache {
  std::vector<std::unique_ptr<Answer>> answers;
  std::vector<std::unique_ptr<SentAnswer>> sent;
};

namespace {

/// The caches of the calls that are under way on this thread, the outermost first; those behind
/// them are there to be used again.
struct CacheStack {
  std::vector<std::unique_ptr<LightCache>> caches;
  size_t used = 0;
};
thread_local CacheStack stack;

/// The place for a light's answers: kept, or only for this question.
template <class Kept>
Kept &placeOf(const AnyslShadeArgs &args, uint32_t light,
              std::vector<std::unique_ptr<Kept>> LightCache::*kept, std::unique_ptr<Kept> &own) {
  auto *cache = static_cast<LightCache *>(args.light_cache);
  if (cache && (cache->*kept).size() < args.light_count)
    (cache->*kept).resize(args.light_count);
  std::unique_ptr<Kept> &place = cache ? (cache->*kept)[light] : own;
  if (!place)
    place = std::make_unique<Kept>();
  return *place;
}

/// Parameters that are there and can take what is sent get it. What depends on them keeps the
/// instance's value: defaults are computed when a light is made.
void SentAnswer::set(const AnyslInstance &light, const AnyslMessage &sent) {
  what = sent.what;
  numbers.assign(sent.numbers, sent.numbers + sent.number_count);
  texts.assign(sent.texts, sent.texts + sent.text_count);
  cells = light.cells;
  answer.known = 0;
  std::vector<const char *> words;
  for (const std::string &text : texts)
    words.push_back(text.c_str());
  AnyslMessage own = sent;
  own.texts = words.data();
  for (const ValuePlace &place : placesOf(own)) {
    const AnyslParamInfo *param = anysl_shader_param(light.shader, std::string(place.name).c_str());
    if (!param || param->flags & ANYSL_PARAM_FIXED)
      continue;
    uint32_t length = elementsOf(own, place);
    bool isArray = place.shape.isArray;
    for (uint32_t i = 0; i < length; ++i) {
      AnyslCell value[16];
      readElement(own, place, i, value);
      AnyslQuery variable = {};
      variable.type = param->type;
      variable.array_length = param->array_length;
      if (isArray != (param->array_length > 0) || (isArray && length != param->array_length))
        break;
      variable.array_length = 0;
      if (!anysl_answer(&variable, place.shape.type(), 0, value,
                        &cells[param->first_cell + i * anysl_type_components(param->type)]))
        break;
    }
  }
}

/// What a light shader gives at a point, and the parameters that it has there.
struct PointAnswer {
  std::unique_ptr<Answer> own;
  std::unique_ptr<SentAnswer> ownSent;
  const AnyslCell *cells = nullptr;
  Answer *answer = nullptr;

  PointAnswer(const AnyslShadeArgs &args, uint32_t light, const AnyslMessage *sent) {
    const auto &instance = *static_cast<const AnyslInstance *>(args.lights[light].shader);
    if (!sent) {
      answer = &placeOf(args, light, &LightCache::answers, own);
      cells = instance.cells.data();
      return;
    }
    SentAnswer &kept = placeOf(args, light, &LightCache::sent, ownSent);
    if (kept.cells.empty() || !kept.isOf(*sent))
      kept.set(instance, *sent);
    answer = &kept.answer;
    cells = kept.cells.data();
  }

  /// Runs the light, if it is not known what it gives; its lane in the answer.
  uint32_t run(const AnyslShadeArgs &args, uint32_t light, uint32_t point, const double *P,
               const double *N) {
    Question question;
    for (int c = 0; c < 3; ++c) {
      question.P[c][0] = P[c];
      question.N[c][0] = N[c];
    }
    answerLanes(args, light, cells, point, 1, question, *answer);
    return point - answer->base;
  }
};

uint32_t lowestLane(uint32_t mask) { return uint32_t(__builtin_ctz(mask)); }

bool isShader(const AnyslShadeArgs &args, uint32_t light) {
  return light < args.light_count && args.lights[light].kind == ANYSL_LIGHT_SHADER &&
         args.lights[light].shader;
}

//===-- Services ------------------------------------------------------------------------------===//

/// Up to 16 lanes; what no light answers is darkness.
template <class Value>
void serve(const AnyslShadeArgs &args, uint32_t first, uint32_t width, uint32_t mask,
           uint32_t light, const Value *P, const Value *N, Value *result) {
  for (uint32_t i = 0; i < resultCount * width; ++i)
    result[i] = i / width < 6 ? 0 : 1;
  if (!mask || !isShader(args, light))
    return;
  guarded([&] {
    Question question;
    for (uint32_t c = 0; c < 3; ++c)
      for (uint32_t lane = 0; lane < width; ++lane) {
        question.P[c][lane] = P[c * width + lane];
        question.N[c][lane] = N[c * width + lane];
      }
    PointAnswer place(args, light, nullptr);
    Answer &answer = *place.answer;
    answerLanes(args, light, place.cells, first, mask, question, answer);
    for (uint32_t rest = mask; rest; rest &= rest - 1) {
      uint32_t lane = lowestLane(rest), at = first + lane - answer.base;
      for (uint32_t i = 0; i < resultCount; ++i)
        result[i * width + lane] = Value(answer.result[i][at]);
    }
    return ANYSL_OK;
  });
}

void serveLight(void *, const AnyslShadeArgs *args, uint32_t point, uint32_t light, const double *P,
                const double *N, double *result) {
  serve(*args, point, 1, 1, light, P, N, result);
}

void serveLightPacket(void *, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                      uint32_t mask, uint32_t light, const float *P, const float *N,
                      float *result) {
  serve(*args, first, width, mask, light, P, N, result);
}

void serveLightSent(void *, const AnyslShadeArgs *args, uint32_t point, uint32_t light,
                    const double *P, const double *N, const AnyslMessage *sent, double *result) {
  for (uint32_t i = 0; i < resultCount; ++i)
    result[i] = i < 6 ? 0 : 1;
  if (light < args->light_count && args->lights[light].kind != ANYSL_LIGHT_SHADER)
    return sampleStandardSent(args->lights[light], P, *sent, result);
  if (!isShader(*args, light))
    return;
  guarded([&] {
    PointAnswer place(*args, light, sent);
    uint32_t lane = place.run(*args, light, point, P, N);
    for (uint32_t i = 0; i < resultCount; ++i)
      result[i] = place.answer->result[i][lane];
    return ANYSL_OK;
  });
}

int serveLightValue(void *, const AnyslShadeArgs *args, uint32_t point, uint32_t light,
                    const double *P, const double *N, const AnyslMessage *sent,
                    const AnyslQuery *query, AnyslCell *value) {
  if (light < args->light_count && args->lights[light].kind != ANYSL_LIGHT_SHADER)
    return standardLightValue(args->lights[light], *query, value, sent);
  if (!isShader(*args, light))
    return 0;
  const auto &instance = *static_cast<const AnyslInstance *>(args->lights[light].shader);
  const AnyslParamInfo *param = anysl_shader_param(instance.shader, query->name);
  if (!param)
    return anysl_instance_answer(&instance, nullptr, 0, query, value); // its name
  int known = 0;
  guarded([&] {
    PointAnswer place(*args, light, sent);
    std::vector<AnyslCell> cells(place.cells + param->first_cell,
                                 place.cells + param->first_cell + cellsOf(*param));
    // Only for a question that it can answer does a light run.
    known = anysl_answer(query, param->type, param->array_length, cells.data(), value);
    if (!known || !isOutput(*param))
      return ANYSL_OK;
    uint32_t lane = place.run(*args, light, point, P, N);
    readOutput(instance, *place.answer, *param, lane, cells.data());
    anysl_answer(query, param->type, param->array_length, cells.data(), value);
    return ANYSL_OK;
  });
  return known;
}

} // namespace

void anysl::host::completeLightServices(AnyslServices &services) {
  // All or none: they answer for the same lights.
  if (services.light || services.light_packet || services.light_value || services.light_sent)
    return;
  services.light = serveLight;
  services.light_packet = serveLightPacket;
  services.light_value = serveLightValue;
  services.light_sent = serveLightSent;
}

extern "C" {

void anysl_lights_begin(AnyslShadeArgs *args) {
  args->light_cache = nullptr;
  guarded([&] {
    if (stack.used == stack.caches.size())
      stack.caches.push_back(std::make_unique<LightCache>());
    LightCache &cache = *stack.caches[stack.used++];
    for (std::unique_ptr<Answer> &answer : cache.answers)
      if (answer)
        answer->known = 0;
    cache.sent.clear(); // the lights may be others than before
    args->light_cache = &cache;
    return ANYSL_OK;
  });
}

void anysl_lights_end(AnyslShadeArgs *args) {
  if (!args->light_cache)
    return;
  args->light_cache = nullptr;
  --stack.used;
}

} // extern "C"
