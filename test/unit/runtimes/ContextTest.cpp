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

#include "Batch.h"
#include <string>

namespace {

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

TEST_CASE("the layout is the one that the runtime reads") {
#ifdef ANYSL_TEST_AOS
  CHECK(anysl_runtime_layout == ANYSL_LAYOUT_AOS);
#else
  CHECK(anysl_runtime_layout == ANYSL_LAYOUT_SOA);
#endif
}
