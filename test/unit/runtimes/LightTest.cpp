//===-- test/unit/runtimes/LightTest.cpp - operators that ask about lights --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Batch.h"
#include <cmath>
#include <string>

namespace {

struct Sample {
  bool reaches;
  anysl_vector L;
  anysl_color Cl, Ol, shadowed;
};

const anysl_normal up(0, 0, 1);

Sample sample(Batch &batch, const AnyslLight &light, const anysl_vector &P) {
  Sample result;
  batch.args.lights = &light;
  batch.args.light_count = 1;
  batch.shade(2, [&](anysl_context *context) {
    CHECK(use<anysl_light_count>()(context) == 1);
    result.reaches =
        use<anysl_light_sample>()(context, 0, &P, &up, &result.L, &result.Cl, &result.Ol);
    result.shadowed = result.Cl;
    use<anysl_light_shadow>()(context, 0, &P, &result.L, &result.shadowed);
  });
  return result;
}

} // namespace

TEST_CASE("ambient light comes with the batch") {
  Batch batch;
  batch.args.ambient[0] = 0.5f, batch.args.ambient[1] = 0.25f, batch.args.ambient[2] = 1;
  batch.shade(0, [&](anysl_context *context) {
    anysl_color color;
    anysl_vector P(1, 2, 3);
    use<anysl_ambient>()(&color, context, &P, &up);
    checkColor(color, 0.5, 0.25, 1);
  });
}

TEST_CASE("a distant light is the same everywhere") {
  Batch batch;
  AnyslLight light = {};
  light.kind = ANYSL_LIGHT_DISTANT;
  light.color[0] = 1, light.color[1] = 0.5f, light.color[2] = 2;
  light.direction[2] = -1;
  for (Real x : {Real(0), Real(1e6)}) {
    Sample s = sample(batch, light, {x, x, x});
    CHECK(s.reaches);
    checkVector(s.L, 0, 0, 1);
    checkColor(s.Cl, 1, 0.5, 2);
    checkColor(s.Ol, 1, 1, 1);
  }
}

TEST_CASE("a point light fades with the square of the distance") {
  Batch batch;
  AnyslLight light = {};
  light.kind = ANYSL_LIGHT_POINT;
  light.color[0] = 36;
  light.from[0] = 1, light.from[1] = 2, light.from[2] = 3;
  Sample s = sample(batch, light, {1, 2, -3});
  CHECK(s.reaches);
  checkVector(s.L, 0, 0, 6);
  checkColor(s.Cl, 1, 0, 0);
  // In the light itself there is no direction and no light, rather than infinity.
  checkColor(sample(batch, light, {1, 2, 3}).Cl, 0, 0, 0);
}

TEST_CASE("a spotlight fades with distance, across its edge and with its beam") {
  Batch batch;
  AnyslLight light = {};
  light.kind = ANYSL_LIGHT_SPOT;
  light.color[1] = 1;
  light.from[2] = 2;
  light.direction[2] = -1;
  light.cos_outer = 0.5f, light.cos_inner = 0.75f, light.beam = 3;
  checkColor(sample(batch, light, {0, 0, 0}).Cl, 0, 0.25, 0);
  auto atCosine = [&](double cosine, bool reaches, double expected) {
    INFO("cosine " << cosine);
    double distance = 2 / cosine, x = std::sqrt(distance * distance - 4);
    Sample s = sample(batch, light, {Real(x), 0, 0});
    CHECK(s.reaches == reaches);
    CHECK(s.Cl.g == near(expected / (distance * distance), 64));
  };
  atCosine(0.9, true, 0.9 * 0.9 * 0.9);
  atCosine(0.625, true, 0.5 * 0.625 * 0.625 * 0.625);
  atCosine(0.49, false, 0);
  CHECK_FALSE(sample(batch, light, {0, 0, 5}).reaches);
}

TEST_CASE("flags of a light leave it out of diffuse or specular") {
  Batch batch;
  AnyslLight lights[3] = {};
  lights[1].flags = ANYSL_LIGHT_NONDIFFUSE, lights[2].flags = ANYSL_LIGHT_NONSPECULAR;
  batch.args.lights = lights, batch.args.light_count = 3;
  batch.shade(0, [&](anysl_context *context) {
    anysl_vector P(1, 2, 3);
    for (int i = 0; i < 3; ++i) {
      CHECK(use<anysl_light_is_nondiffuse>()(context, i, &P, &up) == (i == 1));
      CHECK(use<anysl_light_is_nonspecular>()(context, i, &P, &up) == (i == 2));
    }
  });
}

TEST_CASE("categories are lists of names; a negated list means the lights of none of them") {
  Batch batch;
  AnyslLight lights[3] = {};
  lights[1].category = "key", lights[2].category = "fill,warm";
  batch.args.lights = lights, batch.args.light_count = 3;
  struct Case {
    const char *wanted;
    bool belongs[3];
  } const cases[] = {{"", {true, true, true}},        {nullptr, {true, true, true}},
                     {"key", {false, true, false}},   {"ke", {false, false, false}},
                     {"keys", {false, false, false}}, {"warm", {false, false, true}},
                     {"fill", {false, false, true}},  {"key,warm", {false, true, true}},
                     {"-key", {true, false, true}},   {"-warm,key", {true, false, false}},
                     {"-other", {true, true, true}},  {"-", {true, true, true}},
                     {",", {false, false, false}}};
  batch.shade(0, [&](anysl_context *context) {
    for (const Case &wanted : cases)
      for (int i = 0; i < 3; ++i) {
        INFO((wanted.wanted ? wanted.wanted : "null") << " of light " << i);
        CHECK(use<anysl_light_in_category>()(context, i, &wanted.wanted) == wanted.belongs[i]);
      }
  });
}

TEST_CASE("a light shader is asked for through the services") {
  Batch batch;
  AnyslLight light = {};
  light.kind = ANYSL_LIGHT_SHADER;
  light.color[0] = light.color[1] = light.color[2] = 1;
  // Without the service it is dark.
  CHECK_FALSE(sample(batch, light, {1, 2, 3}).reaches);
  batch.services.light = [](void *, const AnyslShadeArgs *, uint32_t point, uint32_t index,
                            const double P[3], const double N[3], double result[9]) {
    double values[] = {P[0], P[1], P[2] - 3, double(point), double(index), N[2], 0.25, 0.5, 0.75};
    std::memcpy(result, values, sizeof values);
  };
  Sample s = sample(batch, light, {1, 2, 3});
  CHECK(s.reaches);
  checkVector(s.L, 1, 2, 0);
  checkColor(s.Cl, 2, 0, 1);
  checkColor(s.Ol, 0.25, 0.5, 0.75);
  light.color[0] = 0.5f;
  checkColor(sample(batch, light, {1, 2, 3}).Cl, 1, 0, 1);
  light.color[0] = 1;
  // L is zero where it does not reach.
  CHECK_FALSE(sample(batch, light, {0, 0, 3}).reaches);
  // An ambient one reaches no point, and is there for ambient().
  light.flags = ANYSL_LIGHT_AMBIENT;
  CHECK_FALSE(sample(batch, light, {1, 2, 3}).reaches);
  batch.args.ambient[0] = 0.5f;
  batch.shade(2, [&](anysl_context *context) {
    anysl_color color;
    anysl_vector P(1, 2, 3);
    use<anysl_ambient>()(&color, context, &P, &up);
    checkColor(color, 2.5, 0, 1);
  });
}

TEST_CASE("the shadow of a light shader comes from where L ends, or from far along it") {
  static double to[3];
  Batch batch;
  batch.services.transmission = [](void *, const AnyslShadeArgs *, uint32_t, const double *,
                                   const double t[3], double color[3]) {
    std::memcpy(to, t, sizeof to);
    color[0] = color[1] = color[2] = 0.5;
  };
  batch.services.light = [](void *, const AnyslShadeArgs *, uint32_t, uint32_t, const double *,
                            const double *, double result[9]) {
    double values[] = {0, 0, 4, 1, 2, 3, 1, 1, 1};
    std::memcpy(result, values, sizeof values);
  };
  AnyslLight light = {};
  light.kind = ANYSL_LIGHT_SHADER;
  light.color[0] = light.color[1] = light.color[2] = 1;
  light.flags = ANYSL_LIGHT_CASTS_SHADOW;
  checkColor(sample(batch, light, {1, 2, 3}).shadowed, 0.5, 1, 1.5);
  CHECK((to[0] == 1 && to[1] == 2 && to[2] == 7));
  light.flags |= ANYSL_LIGHT_FAR;
  sample(batch, light, {1, 2, 3});
  CHECK((to[0] == 1 && to[1] == 2 && to[2] > 1e10));
}

TEST_CASE("rays for shadows end where a light is, or far away in its direction") {
  Batch batch;
  AnyslLight light = {};
  batch.args.lights = &light, batch.args.light_count = 1;
  light.from[0] = 1, light.from[1] = 2, light.from[2] = 3;
  light.direction[2] = -1;
  const anysl_point P(4, 0, 1);
  const anysl_vector L(0, 3, 4);
  auto endOf = [&](uint32_t kind, uint32_t flags) {
    light.kind = kind, light.flags = flags;
    anysl_point end;
    batch.shade(0,
                [&](anysl_context *context) { use<anysl_light_end>()(&end, context, 0, &P, &L); });
    return end;
  };
  checkVector(endOf(ANYSL_LIGHT_POINT, 0), 1, 2, 3);
  checkVector(endOf(ANYSL_LIGHT_SPOT, 0), 1, 2, 3);
  checkVector(endOf(ANYSL_LIGHT_SHADER, 0), 4, 3, 5);
  anysl_point far = endOf(ANYSL_LIGHT_DISTANT, 0);
  CHECK((far.x == 4 && far.y == 0 && far.z > 1e9));
  far = endOf(ANYSL_LIGHT_SHADER, ANYSL_LIGHT_FAR); // 3 to 4
  CHECK((far.y > 1e9 && std::fabs(double(far.y) * 4 / 3 - double(far.z)) < 1e6));
}

TEST_CASE("a light shader that is linked in has its parameters and its place") {
  Batch batch;
  AnyslLight light = {};
  AnyslCell cells[17];
  for (int i = 0; i < 16; ++i)
    cells[i].number = i + 0.5;
  cells[16].string = "word";
  light.kind = ANYSL_LIGHT_SHADER;
  light.params = cells;
  light.color[0] = 1, light.color[1] = 0.5f, light.color[2] = 2;
  light.from[0] = 1, light.from[1] = 2, light.from[2] = 3;
  light.direction[1] = -1;
  batch.args.lights = &light, batch.args.light_count = 1;
  batch.shade(3, [&](anysl_context *context) {
    anysl_float number;
    use<anysl_linked_light_float>()(&number, context, 0, 4);
    CHECK(number == anysl_float(4.5));
    anysl_color color;
    use<anysl_linked_light_color>()(&color, context, 0, 1);
    checkColor(color, 1.5, 2.5, 3.5);
    anysl_vector vector;
    use<anysl_linked_light_vector>()(&vector, context, 0, 7);
    checkVector(vector, 7.5, 8.5, 9.5);
    anysl_matrix matrix;
    use<anysl_linked_light_matrix>()(&matrix, context, 0, 0);
    CHECK((matrix.m[0][1] == anysl_float(1.5) && matrix.m[3][2] == anysl_float(14.5)));
    anysl_string text;
    use<anysl_linked_light_string>()(&text, context, 0, 16);
    CHECK(std::string(text) == "word");
    use<anysl_linked_light_from>()(&vector, context, 0);
    checkVector(vector, 1, 2, 3);
    use<anysl_linked_light_direction>()(&vector, context, 0);
    checkVector(vector, 0, -1, 0);
    // It shines away from itself, and the surface looks the other way.
    anysl_vector L(0, 3, -4);
    color = anysl_color(1, 2, 3);
    CHECK(use<anysl_linked_light_arrives>()(context, 0, &L, &color));
    checkVector(L, 0, -3, 4);
    checkColor(color, 1, 1, 6);
    L = anysl_vector(0, 0, 0);
    CHECK_FALSE(use<anysl_linked_light_arrives>()(context, 0, &L, &color));
  });
}

TEST_CASE("parameters of lights are asked for by name and type") {
  Batch batch;
  AnyslLight light = {};
  light.kind = ANYSL_LIGHT_SHADER;
  batch.args.lights = &light, batch.args.light_count = 1;
  anysl_vector P(1, 2, 3);
  auto ask = [&](const char *name, auto check) {
    anysl_string text = name;
    batch.shade(2, [&](anysl_context *context) { check(context, &text); });
  };
  anysl_string nothing = "", sent = "level:f,mode:s", words[] = {"loud"};
  anysl_float told[] = {5};
  const anysl_string *message = &nothing;
  auto value = [&](auto op, anysl_context *context, const anysl_string *name, auto *to) {
    bool sends = message == &sent;
    return op(context, 0, &P, &up, message, told, sends ? 1u : 0u, words, sends ? 1u : 0u, name, 4u,
              3u, to);
  };
  auto numbers = [&](anysl_context *context, const anysl_string *name, bool found) {
    anysl_float x = 9;
    CHECK(value(use<anysl_light_float>(), context, name, &x) == found);
    CHECK(x == Real(found ? ANYSL_FLOAT : 9));
    anysl_color c = {9, 9, 9};
    CHECK(value(use<anysl_light_color>(), context, name, &c) == found);
    CHECK(c.b == Real(found ? ANYSL_COLOR + 2 : 9));
    anysl_vector v = {9, 9, 9};
    CHECK(value(use<anysl_light_vector>(), context, name, &v) == found);
    CHECK(v.z == Real(found ? ANYSL_VECTOR + 2 : 9));
    anysl_matrix m = {};
    CHECK(value(use<anysl_light_matrix>(), context, name, &m) == found);
    CHECK(m.m[3][3] == Real(found ? ANYSL_MATRIX + 15 : 0));
  };
  ask("there", [&](auto *context, auto *name) { numbers(context, name, false); }); // no service
  static std::string heard;
  batch.services.light_value = [](void *, const AnyslShadeArgs *, uint32_t point, uint32_t,
                                  const double P[3], const double N[3], const AnyslMessage *sent,
                                  const AnyslQuery *query, AnyslCell *value) {
    CHECK((point == 2 && P[2] == 3 && N[2] == 1));
    CHECK((query->kind == ANYSL_QUERY_lightsource && query->light == 0));
    heard = sent ? sent->what + std::to_string(int(sent->numbers[0])) + sent->texts[0] : "";
    if (std::strcmp(query->name, "there") != 0)
      return 0;
    CHECK((query->array_length == 4 && query->element == 3));
    if (query->type == ANYSL_STRING)
      value->string = "text";
    else
      for (uint32_t i = 0; i < (query->type == ANYSL_FLOAT    ? 1u
                                : query->type == ANYSL_MATRIX ? 16u
                                                              : 3u);
           ++i)
        value[i].number = query->type + i;
    return 1;
  };
  ask("there", [&](auto *context, auto *name) { numbers(context, name, true); });
  CHECK(heard.empty());
  ask("elsewhere", [&](auto *context, auto *name) { numbers(context, name, false); });
  message = &sent;
  anysl_string text = "before";
  ask("elsewhere", [&](auto *context, auto *name) {
    CHECK_FALSE(value(use<anysl_light_string>(), context, name, &text));
    CHECK(std::string(text) == "before");
  });
  ask("there", [&](auto *context, auto *name) {
    CHECK(value(use<anysl_light_string>(), context, name, &text));
    CHECK(std::string(text) == "text");
  });
  CHECK(heard == "level:f,mode:s5loud");
  // A flag that the shader computes is such a parameter.
  light.flags = ANYSL_LIGHT_COMPUTES_FLAGS;
  ask("", [&](auto *context, auto *) {
    CHECK_FALSE(use<anysl_light_is_nondiffuse>()(context, 0, &P, &up));
  });
}

TEST_CASE("a light shader is run with what is sent to it, and lights have handles") {
  Batch batch;
  AnyslLight lights[2] = {};
  batch.args.lights = lights, batch.args.light_count = 2;
  lights[0].kind = ANYSL_LIGHT_SHADER;
  lights[0].color[0] = 2, lights[0].color[1] = lights[0].color[2] = 1;
  lights[1].kind = ANYSL_LIGHT_POINT;
  lights[1].color[0] = lights[1].color[1] = lights[1].color[2] = 8;
  lights[1].from[2] = 5;
  lights[1].handle = "bulb";
  anysl_point P(0, 0, 3);
  anysl_string sent = "level:f";
  anysl_float told[] = {5};
  anysl_string none[] = {nullptr};
  anysl_vector L;
  anysl_color Cl, Ol;
  auto sample = [&](anysl_context *context, int32_t light) {
    return use<anysl_light_sample_sent>()(context, light, &P, &up, &sent, told, 1u, none, 0u, &L,
                                          &Cl, &Ol);
  };
  batch.shade(2, [&](anysl_context *context) { CHECK_FALSE(sample(context, 0)); }); // no service
  batch.services.light_sent = [](void *, const AnyslShadeArgs *, uint32_t point, uint32_t light,
                                 const double P[3], const double[3], const AnyslMessage *sent,
                                 double result[9]) {
    CHECK((point == 2 && light == 0 && sent->number_count == 1 && sent->text_count == 0));
    for (int i = 0; i < 9; ++i)
      result[i] = i < 3 ? P[i] : sent->numbers[0] + i;
  };
  batch.shade(2, [&](anysl_context *context) {
    CHECK(sample(context, 0));
    CHECK(L.z == 3);
    CHECK((Cl.r == 16 && Cl.g == 9 && Cl.b == 10));
    CHECK((Ol.r == 11 && Ol.b == 13));
    // A light of a standard kind is no shader: 8 / 2^2.
    CHECK(sample(context, 1));
    CHECK((L.z == 2 && Cl.r == 2 && Ol.r == 1));
    anysl_string handle = nullptr;
    CHECK_FALSE(use<anysl_light_handle>()(&handle, context, 0));
    CHECK(std::string(handle).empty());
    CHECK(use<anysl_light_handle>()(&handle, context, 1));
    CHECK(std::string(handle) == "bulb");
  });
}

TEST_CASE(
    "only a light that casts shadows asks for transmission, and only when asked for its shadow") {
  static int asked;
  static double from[3], to[3];
  asked = 0;
  Batch batch;
  batch.services.transmission = [](void *renderer, const AnyslShadeArgs *args, uint32_t point,
                                   const double f[3], const double t[3], double color[3]) {
    ++asked;
    CHECK(renderer == args->renderer);
    CHECK(point == 2);
    std::memcpy(from, f, sizeof from);
    std::memcpy(to, t, sizeof to);
    color[0] = 0.5, color[1] = 0.25, color[2] = 0;
  };
  AnyslLight light = {};
  light.kind = ANYSL_LIGHT_SPOT;
  light.color[0] = light.color[1] = light.color[2] = 4;
  light.from[2] = 2;
  light.direction[2] = -1;
  light.cos_outer = 0.5f, light.cos_inner = 0.75f;
  checkColor(sample(batch, light, {0, 0, 0}).shadowed, 1, 1, 1);
  CHECK(asked == 0);
  light.flags = ANYSL_LIGHT_CASTS_SHADOW;
  Sample s = sample(batch, light, {0, 0, 0});
  checkColor(s.Cl, 1, 1, 1);
  checkColor(s.shadowed, 0.5, 0.25, 0);
  CHECK(asked == 1);
  CHECK((from[2] == 0 && to[2] == 2));
  // A distant light's ray ends far away, in the light's direction.
  light.kind = ANYSL_LIGHT_DISTANT;
  sample(batch, light, {1, 2, 3});
  CHECK(asked == 2);
  CHECK(from[2] == 3);
  CHECK((to[2] - from[2] > 1e10 && to[0] == from[0] && to[1] == from[1]));
}
