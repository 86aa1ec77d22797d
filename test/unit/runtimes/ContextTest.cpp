//===-- test/unit/runtimes/ContextTest.cpp - operators that take a context --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Compiled with the sources of one interface runtime. ANYSL_TEST_AOS says which layout it reads.
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <anysl/standard/hit-call.h>
#include <anysl/standard/texture-call.h>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {

std::function<void(anysl_context *)> shader, defaults;

/// Sixteen points of a batch, whose globals and per-point parameters are set by name, whatever the
/// layout.
class Batch {
public:
  static constexpr uint32_t count = 16;

  Batch() {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc)                                     \
  first[ANYSL_##name] = ANYSL_COMPONENT_##name;                                                    \
  isUniform[ANYSL_##name] = std::strcmp(#storage, "uniform") == 0;
#include <anysl/Globals.def>
#ifdef ANYSL_TEST_AOS
    pointers = {reals.data()};
#else
    for (int c = 0; c < ANYSL_COMPONENT_COUNT; ++c)
      pointers.push_back(&reals[c * count]);
#endif
    services.struct_size = sizeof services;
    args.struct_size = sizeof args;
    args.count = count;
    args.globals = pointers.data();
    args.services = &services;
    args.data_stride = count;
    args.renderer = this;
    args.params = cells.data();
    args.param_is_set = isSet;
    args.param_data = data;
  }

  Real &global(int id, int component, uint32_t point) {
#ifdef ANYSL_TEST_AOS
    return reals[point * ANYSL_COMPONENT_COUNT + first[id] + component];
#else
    return reals[(first[id] + component) * count + (isUniform[id] ? 0 : point)];
#endif
  }

  /// Element `element`, component `component` of `components`, of a parameter given point by point.
  Real &varying(std::vector<Real> &values, int components, int element, int component,
                uint32_t point) {
#ifdef ANYSL_TEST_AOS
    return values[(element * count + point) * components + component];
#else
    return values[(element * components + component) * count + point];
#endif
  }

  void shade(uint32_t point, std::function<void(anysl_context *)> body) {
    shader = std::move(body);
    anysl_runtime_shade_point(&args, point);
  }

  std::vector<Real> reals = std::vector<Real>(ANYSL_COMPONENT_COUNT * count);
  std::vector<void *> pointers;
  std::vector<AnyslCell> cells = std::vector<AnyslCell>(64);
  uint8_t isSet[8] = {};
  void *data[8] = {};
  int first[ANYSL_GLOBAL_COUNT];
  bool isUniform[ANYSL_GLOBAL_COUNT];
  AnyslServices services = {};
  AnyslShadeArgs args = {};
};

template <auto Load>
auto load(anysl_context *context, uint32_t id) {
  auto result = [&]<typename T>(void (*op)(T *, anysl_context *, uint32_t)) {
    T value;
    op(&value, context, id);
    return value;
  };
  return result(use<Load>());
}

} // namespace

extern "C" void anysl_shader_body(anysl_context *context) { shader(context); }
extern "C" void anysl_shader_init(anysl_context *context) { defaults(context); }

//===-- Globals and parameters ----------------------------------------------------------------===//

TEST_CASE("a point's globals are read and written where the layout has them") {
  Batch batch;
  for (uint32_t p = 0; p < Batch::count; ++p) {
    for (int c = 0; c < 3; ++c) {
      batch.global(ANYSL_N, c, p) = Real(100 * c + p);
      batch.global(ANYSL_Cs, c, p) = Real(1000 * c + p);
    }
    batch.global(ANYSL_s, 0, p) = Real(10000 + p);
    batch.global(ANYSL_time, 0, p) = Real(0.25);
  }
  for (uint32_t p = 0; p < Batch::count; ++p)
    batch.shade(p, [&](anysl_context *context) {
      checkVector(load<anysl_load_global_vector>(context, ANYSL_N), p, 100 + p, 200 + p);
      checkColor(load<anysl_load_global_color>(context, ANYSL_Cs), p, 1000 + p, 2000 + p);
      CHECK(load<anysl_load_global_float>(context, ANYSL_s) == Real(10000 + p));
      CHECK(load<anysl_load_global_float>(context, ANYSL_time) == Real(0.25));
      anysl_color Ci(Real(p), Real(p + 1), Real(p + 2));
      use<anysl_store_global_color>()(context, ANYSL_Ci, &Ci);
      anysl_vector P(Real(-1.0 * p), 7, 8);
      use<anysl_store_global_vector>()(context, ANYSL_P, &P);
      Real alpha = Real(0.5 * p);
      use<anysl_store_global_float>()(context, ANYSL_alpha, &alpha);
    });
  for (uint32_t p = 0; p < Batch::count; ++p) {
    CHECK(batch.global(ANYSL_Ci, 0, p) == Real(p));
    CHECK(batch.global(ANYSL_Ci, 2, p) == Real(p + 2));
    CHECK(batch.global(ANYSL_P, 0, p) == -Real(p));
    CHECK(batch.global(ANYSL_P, 2, p) == 8);
    CHECK(batch.global(ANYSL_alpha, 0, p) == Real(0.5 * p));
    CHECK(batch.global(ANYSL_N, 1, p) == Real(100 + p));
  }
}

TEST_CASE("uniform parameters lie in cells") {
  Batch batch;
  for (size_t k = 0; k < batch.cells.size(); ++k)
    batch.cells[k].number = double(k);
  batch.cells[40].string = "marble";
  batch.shade(3, [&](anysl_context *context) {
    CHECK(load<anysl_load_param_float>(context, 5) == 5);
    checkColor(load<anysl_load_param_color>(context, 6), 6, 7, 8);
    checkVector(load<anysl_load_param_vector>(context, 9), 9, 10, 11);
    checkMatrix(load<anysl_load_param_matrix>(context, 12),
                {{12, 13, 14, 15}, {16, 17, 18, 19}, {20, 21, 22, 23}, {24, 25, 26, 27}});
    CHECK(std::strcmp(load<anysl_load_param_string>(context, 40), "marble") == 0);
  });
}

TEST_CASE("defaults are stored in cells") {
  Batch batch;
  batch.isSet[1] = 1;
  defaults = [&](anysl_context *context) {
    CHECK_FALSE(use<anysl_param_is_set>()(context, 0));
    CHECK(use<anysl_param_is_set>()(context, 1));
    Real x = 2;
    anysl_color color(3, 4, 5);
    anysl_vector vector(6, 7, 8);
    anysl_matrix matrix;
    for (int k = 0; k < 16; ++k)
      matrix.m[k / 4][k % 4] = Real(10 + k);
    anysl_string text = "text";
    use<anysl_store_param_float>()(context, 2, &x);
    use<anysl_store_param_color>()(context, 3, &color);
    use<anysl_store_param_vector>()(context, 6, &vector);
    use<anysl_store_param_matrix>()(context, 10, &matrix);
    use<anysl_store_param_string>()(context, 26, &text);
  };
  anysl_runtime_init(&batch.args);
  for (int k = 2; k < 9; ++k)
    CHECK(batch.cells[k].number == k);
  for (int k = 10; k < 26; ++k)
    CHECK(batch.cells[k].number == k);
  CHECK(std::strcmp(batch.cells[26].string, "text") == 0);
}

TEST_CASE("parameters given point by point are read, and written where they are wanted") {
  Batch batch;
  const uint32_t p = 5;
  std::vector<Real> numbers(2 * Batch::count), triples(6 * Batch::count),
      matrices(16 * Batch::count);
  batch.data[1] = numbers.data(), batch.data[2] = triples.data(), batch.data[3] = matrices.data();
  batch.varying(numbers, 1, 1, 0, p) = 4;
  for (int c = 0; c < 3; ++c)
    batch.varying(triples, 3, 1, c, p) = Real(10 + c);
  for (int c = 0; c < 16; ++c)
    batch.varying(matrices, 16, 0, c, p) = Real(c);
  batch.shade(p, [&](anysl_context *context) {
    CHECK_FALSE(use<anysl_param_is_bound>()(context, 0));
    CHECK(use<anysl_param_is_bound>()(context, 1));
    Real x;
    use<anysl_load_varying_float>()(&x, context, 1, 1);
    CHECK(x == 4);
    anysl_color color;
    use<anysl_load_varying_color>()(&color, context, 2, 1);
    checkColor(color, 10, 11, 12);
    anysl_vector vector;
    use<anysl_load_varying_vector>()(&vector, context, 2, 1);
    checkVector(vector, 10, 11, 12);
    anysl_matrix matrix;
    use<anysl_load_varying_matrix>()(&matrix, context, 3, 0);
    checkMatrix(matrix, {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13, 14, 15}});

    x = 40, color = {1, 2, 3}, matrix.m[3][3] = 99;
    vector = {4, 5, 6};
    for (uint32_t id : {0u, 1u})
      use<anysl_store_varying_float>()(context, id, 0, &x);
    for (uint32_t id : {0u, 2u}) {
      use<anysl_store_varying_color>()(context, id, 0, &color);
      use<anysl_store_varying_vector>()(context, id, 1, &vector);
    }
    for (uint32_t id : {0u, 3u})
      use<anysl_store_varying_matrix>()(context, id, 0, &matrix);
  });
  CHECK(batch.varying(numbers, 1, 0, 0, p) == 40);
  CHECK(batch.varying(numbers, 1, 0, 0, p + 1) == 0);
  CHECK(batch.varying(triples, 3, 0, 2, p) == 3);
  CHECK(batch.varying(triples, 3, 1, 0, p) == 4);
  CHECK(batch.varying(triples, 3, 1, 0, p + 1) == 0);
  CHECK(batch.varying(matrices, 16, 0, 15, p) == 99);
}

TEST_CASE("texts are written point by point, element by element, where they are wanted") {
  Batch batch;
  const uint32_t p = 5;
  std::vector<anysl_string> texts(2 * Batch::count);
  batch.data[1] = texts.data();
  batch.shade(p, [&](anysl_context *context) {
    anysl_string text = "chrome";
    for (uint32_t id : {0u, 1u})
      use<anysl_store_varying_string>()(context, id, 1, &text);
  });
  CHECK(std::strcmp(texts[Batch::count + p], "chrome") == 0);
  CHECK(texts[p] == nullptr);
  CHECK(texts[Batch::count + p + 1] == nullptr);
}

TEST_CASE("a batch without any per-point parameters binds none") {
  Batch batch;
  batch.args.param_data = nullptr;
  batch.shade(0, [&](anysl_context *context) {
    CHECK_FALSE(use<anysl_param_is_bound>()(context, 3));
    Real x = 1;
    use<anysl_store_varying_float>()(context, 3, 0, &x);
  });
}

//===-- Random numbers ------------------------------------------------------------------------===//

TEST_CASE("random numbers depend on the point's seed and on how many it has drawn") {
  Batch batch;
  auto draw = [&](uint32_t point) {
    std::vector<Real> numbers;
    batch.shade(point, [&](anysl_context *context) {
      for (int i = 0; i < 4; ++i) {
        Real x;
        use<anysl_random_float>()(&x, context);
        numbers.push_back(x);
      }
      anysl_color color;
      use<anysl_random_color>()(&color, context);
      anysl_vector vector;
      use<anysl_random_vector>()(&vector, context);
      for (Real x : {color.r, color.g, color.b, vector.x, vector.y, vector.z})
        numbers.push_back(x);
    });
    return numbers;
  };
  std::vector<Real> first = draw(0), second = draw(1);
  CHECK(first == draw(0));
  CHECK(first != second);
  for (size_t i = 0; i < first.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      CHECK(first[i] != first[j]);
  uint32_t seeds[Batch::count] = {1};
  batch.args.seeds = seeds;
  CHECK(draw(0) == second);
}

TEST_CASE("random numbers are even over the points of a batch and over a point's sequence") {
  Batch batch;
  const int points = 4000, draws = 10;
  double sum = 0, square = 0, neighbours = 0, successive = 0;
  for (int p = 0; p < points; ++p) {
    uint32_t seed = uint32_t(p), next = seed + 1;
    double values[2][draws];
    for (int k = 0; k < 2; ++k) {
      batch.args.seeds = k == 0 ? &seed : &next;
      batch.shade(0, [&](anysl_context *context) {
        for (double &value : values[k]) {
          Real x;
          use<anysl_random_float>()(&x, context);
          value = x;
        }
      });
    }
    for (int i = 0; i < draws; ++i) {
      double x = values[0][i];
      REQUIRE((x >= 0 && x < 1));
      sum += x, square += x * x;
      neighbours += (x - 0.5) * (values[1][i] - 0.5);
      if (i)
        successive += (x - 0.5) * (values[0][i - 1] - 0.5);
    }
  }
  const double n = points * draws;
  CHECK(sum / n == Approx(0.5).margin(0.005));
  CHECK(square / n == Approx(1.0 / 3).margin(0.005));
  CHECK(std::abs(neighbours / n) < 0.002);
  CHECK(std::abs(successive / n) < 0.002);
}

//===-- Lights --------------------------------------------------------------------------------===//

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
  auto numbers = [&](anysl_context *context, const anysl_string *name, bool found) {
    anysl_float x = 9;
    CHECK(use<anysl_light_float>()(context, 0, &P, &up, name, &x) == found);
    CHECK(x == Real(found ? ANYSL_FLOAT : 9));
    anysl_color c = {9, 9, 9};
    CHECK(use<anysl_light_color>()(context, 0, &P, &up, name, &c) == found);
    CHECK(c.b == Real(found ? ANYSL_COLOR + 2 : 9));
    anysl_vector v = {9, 9, 9};
    CHECK(use<anysl_light_vector>()(context, 0, &P, &up, name, &v) == found);
    CHECK(v.z == Real(found ? ANYSL_VECTOR + 2 : 9));
    anysl_matrix m = {};
    CHECK(use<anysl_light_matrix>()(context, 0, &P, &up, name, &m) == found);
    CHECK(m.m[3][3] == Real(found ? ANYSL_MATRIX + 15 : 0));
  };
  ask("there", [&](auto *context, auto *name) { numbers(context, name, false); }); // no service
  batch.services.light_value = [](void *, const AnyslShadeArgs *, uint32_t point, uint32_t,
                                  const double P[3], const double N[3], const char *name,
                                  uint32_t type, AnyslCell *value) {
    CHECK((point == 2 && P[2] == 3 && N[2] == 1));
    if (std::strcmp(name, "there") != 0)
      return 0;
    if (type == ANYSL_STRING)
      value->string = "text";
    else
      for (int i = 0; i < (type == ANYSL_FLOAT ? 1 : type == ANYSL_MATRIX ? 16 : 3); ++i)
        value[i].number = type + i;
    return 1;
  };
  ask("there", [&](auto *context, auto *name) { numbers(context, name, true); });
  ask("elsewhere", [&](auto *context, auto *name) { numbers(context, name, false); });
  anysl_string value = "before";
  ask("elsewhere", [&](auto *context, auto *name) {
    CHECK_FALSE(use<anysl_light_string>()(context, 0, &P, &up, name, &value));
    CHECK(std::string(value) == "before");
  });
  ask("there", [&](auto *context, auto *name) {
    CHECK(use<anysl_light_string>()(context, 0, &P, &up, name, &value));
    CHECK(std::string(value) == "text");
  });
  // A flag that the shader computes is such a parameter.
  light.flags = ANYSL_LIGHT_COMPUTES_FLAGS;
  ask("", [&](auto *context, auto *) {
    CHECK_FALSE(use<anysl_light_is_nondiffuse>()(context, 0, &P, &up));
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

//===-- Services ------------------------------------------------------------------------------===//

TEST_CASE("services that the renderer does not offer give neutral values") {
  Batch batch;
  batch.shade(0, [&](anysl_context *context) {
    anysl_vector P(1, 2, 3), R(0, 0, 1);
    anysl_color color;
    use<anysl_trace_color>()(&color, context, &P, &R);
    checkColor(color, 0, 0, 0);
    use<anysl_transmission>()(&color, context, &P, &R);
    checkColor(color, 1, 1, 1);
    Real distance;
    use<anysl_trace_float>()(&distance, context, &P, &R);
    CHECK(distance == Real(1e30));
    anysl_matrix matrix;
    anysl_string a = "current", b = "world";
    use<anysl_space_matrix>()(&matrix, context, &a, &b);
    checkMatrix(matrix, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
  });
}

TEST_CASE("services get the point, the position and the direction") {
  Batch batch;
  batch.services.trace = [](void *, const AnyslShadeArgs *, uint32_t point, const double P[3],
                            const double R[3], double color[3]) {
    color[0] = point, color[1] = P[0] + 10 * P[1] + 100 * P[2],
    color[2] = R[0] + 10 * R[1] + 100 * R[2];
  };
  batch.services.trace_distance = [](void *, const AnyslShadeArgs *, uint32_t point,
                                     const double P[3],
                                     const double R[3]) { return point + P[1] + R[2]; };
  batch.services.space_matrix = [](void *, const AnyslShadeArgs *, const char *from, const char *to,
                                   double matrix[16]) {
    if (std::string(from) != "current" || std::string(to) != "world")
      return 0;
    for (int k = 0; k < 16; ++k)
      matrix[k] = k;
    return 1;
  };
  batch.shade(7, [&](anysl_context *context) {
    anysl_vector P(1, 2, 3), R(4, 5, 6);
    anysl_color color;
    use<anysl_trace_color>()(&color, context, &P, &R);
    checkColor(color, 7, 321, 654);
    Real distance;
    use<anysl_trace_float>()(&distance, context, &P, &R);
    CHECK(distance == 15);
    anysl_matrix matrix;
    anysl_string a = "current", b = "world", c = "nowhere";
    use<anysl_space_matrix>()(&matrix, context, &a, &b);
    checkMatrix(matrix, {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13, 14, 15}});
    use<anysl_space_matrix>()(&matrix, context, &a, &c);
    checkMatrix(matrix, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
  });
}

//===-- Pictures ------------------------------------------------------------------------------===//

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
  Batch batch;
  batch.services.trace_hit = [](void *, const AnyslShadeArgs *, uint32_t point, uint32_t width,
                                uint32_t mask, const float *const P[3], const float *const R[3],
                                const float *reach, const AnyslHits *hits) {
    CHECK((width == 1 && mask == 1));
    CHECK((P[0][0] == 1 && P[1][0] == 2 && P[2][0] == 3));
    CHECK((R[0][0] == 4 && R[1][0] == 5 && R[2][0] == 6));
    shades = hits->shades;
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
    CHECK(use<anysl_trace_shade>()(context, &P, &R, &far, &distance, &N, &Ng, &color, &opacity));
    CHECK(shades == 1);
    CHECK(distance == 7);
    checkVector(N, 0, 1, 2);
    checkVector(Ng, 10, 11, 12);
    checkColor(color, 20, 21, 22);
    checkColor(opacity, 30, 31, 32);
    CHECK_FALSE(use<anysl_trace_hit>()(context, &P, &R, &near, &distance, &N, &Ng));
    CHECK(shades == 0);
    CHECK(distance == Real(1e30));
    batch.services = {};
    CHECK_FALSE(
        use<anysl_trace_shade>()(context, &P, &R, &far, &distance, &N, &Ng, &color, &opacity));
    checkColor(color, 0, 0, 0);
  });
}

TEST_CASE("the layout is the one that the runtime reads") {
#ifdef ANYSL_TEST_AOS
  CHECK(anysl_runtime_layout == ANYSL_LAYOUT_AOS);
#else
  CHECK(anysl_runtime_layout == ANYSL_LAYOUT_SOA);
#endif
}
