//===-- test/unit/runtimes/LookupTest.cpp - operators that look pictures up or meet surfaces --===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Batch.h"
#include <anysl/standard/hit-call.h>
#include <anysl/standard/texture-call.h>

namespace {

/// The last lookup that a renderer was asked for, and the numbers of its first point.
struct Lookup {
  AnyslTextureRequest request;
  float at[3], dx[3], dy[3], blur[2];
  uint32_t times = 0, masks[4] = {};
} lookup;

/// Answers with the point's number, and 10 and 100 more.
void answerLookup(void *, const AnyslShadeArgs *, uint32_t first, uint32_t width, uint32_t mask,
                  const AnyslTextureRequest *request, const AnyslTexturePoints *points,
                  float *result) {
  lookup.request = *request;
  lookup.masks[lookup.times++] = mask;
  for (int k = 0; k < 3; ++k) {
    lookup.at[k] = *points->at[k];
    lookup.dx[k] = *points->dx[k];
    lookup.dy[k] = *points->dy[k];
  }
  lookup.blur[0] = *points->blur[0], lookup.blur[1] = *points->blur[1];
  for (uint32_t c = 0; c < request->channels; ++c)
    for (uint32_t i = 0; i < width; ++i)
      result[c * width + i] = float(first + i) + (c == 0 ? 0 : c == 1 ? 10 : 100);
}

void checkTriple(const float (&v)[3], double x, double y, double z) {
  CHECK(v[0] == Approx(x));
  CHECK(v[1] == Approx(y));
  CHECK(v[2] == Approx(z));
}

} // namespace

TEST_CASE("lookups say where, how wide and what") {
  Batch batch;
  batch.services.texture = batch.services.environment = batch.services.shadow = answerLookup;
  anysl_string name = "wood.tif", filter = "box", swrap = "clamp", twrap = "black";
  Real s(0.25), t(0.5), du(0.1), dv(0.2), channel(2), fill(0.75), sblur(0.125), tblur(0.0625),
      swidth(2), twidth(3), zero(0), one(1), bias(0.5), samples(4);
  batch.shade(5, [&](anysl_context *context) {
    Real number;
    anysl_color color;
    lookup = {};
    use<anysl_texture_float>()(&number, context, &name, &s, &t, &du, &dv, &channel, &filter, &swrap,
                               &twrap, &fill, &sblur, &tblur, &swidth, &twidth);
    CHECK(number == 5);
    CHECK((lookup.times == 1 && lookup.masks[0] == 1));
    CHECK((lookup.request.channels == 1 && lookup.request.first_channel == 2));
    CHECK(std::string(lookup.request.name) == "wood.tif");
    CHECK(std::string(lookup.request.filter) == "box");
    CHECK(std::string(lookup.request.swrap) == "clamp");
    CHECK(std::string(lookup.request.twrap) == "black");
    CHECK(lookup.request.fill == 0.75f);
    checkTriple(lookup.at, 0.25, 0.5, 0);
    CHECK((lookup.blur[0] == 0.125f && lookup.blur[1] == 0.0625f));
    use<anysl_texture_color>()(&color, context, &name, &s, &t, &du, &dv, &channel, &filter, &swrap,
                               &twrap, &fill, &sblur, &tblur, &swidth, &twidth);
    checkColor(color, 5, 15, 105);
    CHECK(lookup.request.channels == 3);

    // The quadrilateral (0, 0) (1, 0) (0, 1/2) (1, 1/2), row by row and around.
    use<anysl_texture_corners_float>()(&number, context, &name, &zero, &zero, &one, &zero, &zero,
                                       &t, &one, &t, &channel, &filter, &swrap, &twrap, &fill,
                                       &sblur, &tblur, &swidth, &twidth);
    checkTriple(lookup.at, 0.5, 0.25, 0);
    checkTriple(lookup.dx, 2, 0, 0);
    checkTriple(lookup.dy, 0, 1.5, 0);
    use<anysl_texture_corners_color>()(&color, context, &name, &zero, &zero, &one, &zero, &one, &t,
                                       &zero, &t, &channel, &filter, &swrap, &twrap, &fill, &sblur,
                                       &tblur, &swidth, &twidth);
    checkTriple(lookup.at, 0.5, 0.25, 0);
    checkTriple(lookup.dx, 2, 0, 0);
    checkTriple(lookup.dy, 0, 1.5, 0);

    anysl_vector a(1, 2, 3), b(3, 2, 3), c(1, 4, 3), d(3, 4, 3);
    use<anysl_environment_float>()(&number, context, &name, &a, &du, &dv, &channel, &filter, &fill,
                                   &sblur, &tblur, &swidth, &twidth);
    CHECK(number == 5);
    checkTriple(lookup.at, 1, 2, 3);
    use<anysl_environment_color>()(&color, context, &name, &a, &du, &dv, &channel, &filter, &fill,
                                   &sblur, &tblur, &swidth, &twidth);
    checkColor(color, 5, 15, 105);
    use<anysl_environment_corners_float>()(&number, context, &name, &a, &b, &c, &d, &channel,
                                           &filter, &fill, &sblur, &tblur, &swidth, &twidth);
    checkTriple(lookup.at, 2, 3, 3);
    checkTriple(lookup.dx, 4, 0, 0);
    checkTriple(lookup.dy, 0, 6, 0);
    use<anysl_environment_corners_color>()(&color, context, &name, &a, &b, &d, &c, &channel,
                                           &filter, &fill, &sblur, &tblur, &swidth, &twidth);
    checkTriple(lookup.dx, 4, 0, 0);
    use<anysl_shadow>()(&number, context, &name, &a, &du, &dv, &bias, &samples, &sblur, &tblur,
                        &swidth, &twidth);
    CHECK(number == 5);
    CHECK((lookup.request.bias == 0.5f && lookup.request.samples == 4));
    checkTriple(lookup.at, 1, 2, 3);
    use<anysl_shadow_corners>()(&number, context, &name, &a, &b, &c, &d, &bias, &samples, &sblur,
                                &tblur, &swidth, &twidth);
    checkTriple(lookup.at, 2, 3, 3);
    checkTriple(lookup.dy, 0, 6, 0);

    // A renderer without pictures shows black.
    batch.services = {};
    use<anysl_texture_color>()(&color, context, &name, &s, &t, &du, &dv, &channel, &filter, &swrap,
                               &twrap, &fill, &sblur, &tblur, &swidth, &twidth);
    checkColor(color, 0, 0, 0);
  });
}

TEST_CASE("points that name different files are served file by file") {
  Batch batch;
  batch.services.texture = answerLookup;
  const char *other = "b";
  std::string again = "a"; // equal text elsewhere
  const char *names[4] = {"a", other, again.c_str(), other}, *none[4] = {"", "", "", ""};
  float zeros[4] = {}, fills[4] = {1, 2, 1, 2}, r[4], g[4], b[4];
  lookup = {};
  anysl::askForTextures(&batch.args, 8, anysl::textureQuery(anysl::flatTexture, 1), names, none,
                        none, none, zeros, fills, zeros, zeros, zeros, zeros, zeros, zeros, zeros,
                        zeros, zeros, zeros, zeros, zeros, zeros, r, g, b, 4, 0b0111);
  CHECK(lookup.times == 2);
  CHECK((lookup.masks[0] == 0b0101 && lookup.masks[1] == 0b0010));
  CHECK((r[0] == 8 && r[1] == 9 && r[2] == 10 && r[3] == 0));
  CHECK(lookup.request.fill == 2);
}

TEST_CASE("rays tell what they meet first") {
  static uint32_t shades;
  static std::string asked;
  Batch batch;
  batch.services.trace_hit = [](void *, const AnyslShadeArgs *, uint32_t point, uint32_t width,
                                uint32_t mask, const float *const P[3], const float *const R[3],
                                const float *reach, const AnyslHits *hits) {
    CHECK((width == 1 && mask == 1));
    CHECK((P[0][0] == 1 && P[1][0] == 2 && P[2][0] == 3));
    CHECK((R[0][0] == 4 && R[1][0] == 5 && R[2][0] == 6));
    shades = hits->shades;
    asked = std::string(hits->kind) + ' ' + hits->subset + ' ' + hits->sides;
    if (reach[0] < 10)
      return;
    hits->distance[0] = float(point);
    for (int c = 0; c < 3; ++c) {
      hits->N[c][0] = float(c), hits->Ng[c][0] = float(10 + c);
      hits->color[c][0] = float(20 + c), hits->opacity[c][0] = float(30 + c);
    }
  };
  batch.shade(7, [&](anysl_context *context) {
    anysl_vector P(1, 2, 3), R(4, 5, 6);
    Real far(100), near(1), distance;
    anysl_normal N, Ng;
    anysl_color color, opacity;
    anysl_string kind = "diffuse", subset = "-a", sides = "front";
    auto shade = [&](const Real &reach) {
      return use<anysl_trace_shade>()(context, &P, &R, &reach, &kind, &subset, &sides, &distance,
                                      &N, &Ng, &color, &opacity);
    };
    CHECK(shade(far));
    CHECK(shades == ANYSL_SHADE_FIRST);
    CHECK(asked == "diffuse -a front");
    CHECK(distance == 7);
    checkVector(N, 0, 1, 2);
    checkVector(Ng, 10, 11, 12);
    checkColor(color, 20, 21, 22);
    checkColor(opacity, 30, 31, 32);
    CHECK_FALSE(
        use<anysl_trace_hit>()(context, &P, &R, &near, &kind, &subset, &sides, &distance, &N, &Ng));
    CHECK(shades == ANYSL_SHADE_NOTHING);
    CHECK(distance == Real(1e30));
    use<anysl_trace_light>()(&color, context, &P, &R, &far, &kind, &subset, &sides, &opacity);
    CHECK(shades == ANYSL_SHADE_ALL);
    checkColor(color, 20, 21, 22);
    use<anysl_transmission_among>()(&color, context, &P, &R, &far, &subset, &sides);
    CHECK(asked == "transmission -a front");
    checkColor(color, -29, -30, -31);
    batch.services = {};
    CHECK_FALSE(shade(far));
    checkColor(color, 0, 0, 0);
    use<anysl_transmission_among>()(&color, context, &P, &R, &far, &subset, &sides);
    checkColor(color, 1, 1, 1);
  });
}

TEST_CASE("rays of points that ask for different things are different calls") {
  static std::vector<std::pair<uint32_t, std::string>> calls;
  Batch batch;
  batch.services.trace_hit = [](void *, const AnyslShadeArgs *, uint32_t, uint32_t, uint32_t mask,
                                const float *const *, const float *const *, const float *,
                                const AnyslHits *hits) {
    calls.push_back({mask, std::string(hits->kind) + hits->subset + hits->sides});
    for (uint32_t i = 0; i < 4; ++i)
      if (mask >> i & 1)
        hits->distance[i] = float(10 * calls.size() + i);
  };
  std::string again = "a"; // equal text elsewhere
  const char *kinds[4] = {"", "", "", nullptr}, *sides[4] = {"", "", "", nullptr};
  const char *subsets[4] = {"a", "b", again.c_str(), nullptr};
  float in[4] = {}, out[13][4];
  anysl::askForHits(&batch.args, 8, ANYSL_SHADE_NOTHING, kinds, subsets, sides, in, in, in, in, in,
                    in, in, out[0], out[1], out[2], out[3], out[4], out[5], out[6], out[7], out[8],
                    out[9], out[10], out[11], out[12], nullptr, 4, 0b0111);
  CHECK(calls.size() == 2);
  CHECK((calls[0].first == 0b0101 && calls[0].second == "a"));
  CHECK((calls[1].first == 0b0010 && calls[1].second == "b"));
  CHECK((out[0][0] == 10 && out[0][1] == 21 && out[0][2] == 12 && out[0][3] == -1));
}

TEST_CASE("a ray also brings what is asked about the surface that it meets") {
  Batch batch;
  batch.services.trace_hit = [](void *, const AnyslShadeArgs *, uint32_t point, uint32_t width,
                                uint32_t mask, const float *const P[3], const float *const R[3],
                                const float *reach, const AnyslHits *hits) {
    CHECK((point == 7 && width == 1 && mask == 1 && hits->shades == 1));
    AnyslMessage &asked = hits->values[0];
    CHECK(std::string(asked.what) == "surface:x:f2,attribute:name:s");
    CHECK((asked.number_count == 2 && asked.text_count == 1));
    if (*reach < 1)
      return;
    hits->distance[0] = P[0][0] + R[0][0];
    hits->N[1][0] = 1;
    hits->opacity[2][0] = 0.5f;
    asked.numbers[1] += 10;
    asked.texts[0] = "box";
  };
  batch.shade(7, [&](anysl_context *context) {
    anysl_vector P(1, 2, 3), R(4, 5, 6);
    Real far(100), near(0.5), distance, numbers[2] = {1, 2};
    anysl_string what = "surface:x:f2,attribute:name:s", texts[1] = {"old"}, none = "";
    anysl_normal N, Ng;
    anysl_color color, opacity;
    CHECK_FALSE(use<anysl_trace_values>()(context, &P, &R, &near, &none, &none, &none, &what,
                                          numbers, 2u, texts, 1u, &distance, &N, &Ng, &color,
                                          &opacity));
    CHECK((numbers[1] == 2 && distance == Real(1e30)));
    CHECK(std::string(texts[0]) == "old");
    CHECK(use<anysl_trace_values>()(context, &P, &R, &far, &none, &none, &none, &what, numbers, 2u,
                                    texts, 1u, &distance, &N, &Ng, &color, &opacity));
    CHECK((numbers[0] == 1 && numbers[1] == 12 && distance == 5));
    CHECK(std::string(texts[0]) == "box");
    checkVector(N, 0, 1, 0);
    checkColor(opacity, 0, 0, 0.5);
  });
}
