//===-- test/unit/Host/BatchTests.cpp - points in, shaded points out --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Host/Fixture.h"
#include <cstdint>
#include <thread>
#include <vector>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace {

const char *const everyLayout[] = {"soa-float", "soa-double", "aos-float", "aos-double"};

/// The light from direction R is R / 2 plus the renderer's own number.
void traceHalf(void *renderer, const AnyslShadeArgs *, uint32_t, const double[3], const double R[3],
               double color[3]) {
  for (int c = 0; c < 3; ++c)
    color[c] = R[c] / 2 + *static_cast<double *>(renderer);
}

std::vector<float> values(uint32_t count, float scale) {
  std::vector<float> result(count);
  for (uint32_t i = 0; i < count; ++i)
    result[i] = float(i) * scale;
  return result;
}

} // namespace

TEST_CASE("what goes in comes out again in every layout", "[host]") {
  for (std::string name : everyLayout) {
    INFO(name);
    Library library = open(name);
    Instance instance = instantiate(library.get());
    Batch batch = batchFor(instance.get(), 21, 1 << ANYSL_Cs | 1 << ANYSL_E);
    CHECK(anysl_batch_globals(batch.get()) ==
          (1 << ANYSL_P | 1 << ANYSL_N | 1 << ANYSL_s | 1 << ANYSL_time | 1 << ANYSL_Ci |
           1 << ANYSL_Oi | 1 << ANYSL_Cs | 1 << ANYSL_E));
    std::vector<float> P = values(21 * 4, 0.5f), back(21 * 3, -1);
    REQUIRE(anysl_batch_write_float(batch.get(), ANYSL_P, 0, 21, P.data(), 4) == ANYSL_OK);
    REQUIRE(anysl_batch_read_float(batch.get(), ANYSL_P, 0, 21, back.data(), 3) == ANYSL_OK);
    for (int i = 0; i < 21; ++i)
      for (int c = 0; c < 3; ++c)
        CHECK(back[i * 3 + c] == P[i * 4 + c]);
    // A part, from double, one value for all.
    double grey[3] = {0.25, 0.5, 0.75}, point[3];
    REQUIRE(anysl_batch_write_double(batch.get(), ANYSL_Cs, 5, 10, grey, 0) == ANYSL_OK);
    REQUIRE(anysl_batch_read_double(batch.get(), ANYSL_Cs, 14, 1, point, 3) == ANYSL_OK);
    CHECK(point[2] == 0.75);
    REQUIRE(anysl_batch_read_double(batch.get(), ANYSL_Cs, 15, 1, point, 3) == ANYSL_OK);
    CHECK(point[2] == 0);
    // A uniform value is the same everywhere.
    double eye[3] = {1, 2, 3};
    REQUIRE(anysl_batch_write_double(batch.get(), ANYSL_E, 0, 1, eye, 3) == ANYSL_OK);
    REQUIRE(anysl_batch_read_double(batch.get(), ANYSL_E, 20, 1, point, 3) == ANYSL_OK);
    CHECK(point[1] == 2);
  }
}

TEST_CASE("arrays lie as the binary interface says", "[host]") {
  for (std::string name : everyLayout) {
    INFO(name);
    Library library = open(name);
    Instance instance = instantiate(library.get());
    for (uint32_t capacity : {1u, 16u, 17u, 1024u}) {
      Batch batch = batchFor(instance.get(), capacity);
      bool soa = name[0] == 's', wide = name.find("double") != std::string::npos;
      size_t stride = 99;
      auto *x = static_cast<char *>(anysl_batch_global(batch.get(), ANYSL_Ci, 0, &stride));
      auto *y = static_cast<char *>(anysl_batch_global(batch.get(), ANYSL_Ci, 1, nullptr));
      CHECK(stride == (soa ? 1 : ANYSL_COMPONENT_COUNT));
      size_t real = wide ? 8 : 4, apart = size_t(y - x) / real;
      if (soa) {
        CHECK(apart >= (capacity + 15) / 16 * 16);
        CHECK(reinterpret_cast<uintptr_t>(x) % 64 == 0);
        CHECK(reinterpret_cast<uintptr_t>(y) % 64 == 0);
      } else {
        CHECK(apart == 1);
        // The first component of all is P.x.
        CHECK(reinterpret_cast<uintptr_t>(anysl_batch_global(batch.get(), ANYSL_P, 0, nullptr)) %
                  64 ==
              0);
      }
      CHECK(anysl_batch_global(batch.get(), ANYSL_Cs, 0, nullptr) == nullptr);
      CHECK(anysl_batch_global(batch.get(), ANYSL_Ci, 3, nullptr) == nullptr);
    }
  }
}

TEST_CASE("shading gives the same in every layout and width", "[host]") {
  double own = 0.125;
  AnyslServices services = {};
  services.struct_size = sizeof services;
  services.trace = traceHalf;
  for (std::string name : everyLayout) {
    INFO(name);
    Library library = open(name);
    Instance instance = instantiate(library.get(), &services, &own);
    double tint[3] = {1, 0.5, 0.25};
    REQUIRE(anysl_instance_set_numbers(instance.get(), "tint", tint, 3) == ANYSL_OK);
    for (uint32_t width : {1u, 4u, 0u}) {
      Batch batch = batchFor(instance.get(), 11);
      std::vector<float> s = values(11, 0.25f), color(11 * 3), opacity(11 * 3), doubled(11 * 3);
      float N[3] = {0, 0, 1}, time = 2;
      anysl_batch_write_float(batch.get(), ANYSL_s, 0, 11, s.data(), 1);
      anysl_batch_write_float(batch.get(), ANYSL_N, 0, 11, N, 0);
      anysl_batch_write_float(batch.get(), ANYSL_time, 0, 1, &time, 1);
      REQUIRE(anysl_batch_want_output(batch.get(), "doubled") == ANYSL_OK);
      // Not the first and not the last point: those stay black.
      REQUIRE(anysl_shade(instance.get(), batch.get(), 1, 10, width) == ANYSL_OK);
      anysl_batch_read_float(batch.get(), ANYSL_Ci, 0, 11, color.data(), 3);
      anysl_batch_read_float(batch.get(), ANYSL_Oi, 0, 11, opacity.data(), 3);
      anysl_batch_read_output_float(batch.get(), "doubled", 0, 11, doubled.data(), 3);
      for (int i = 0; i < 11; ++i) {
        float on = i > 0 && i < 10;
        for (int c = 0; c < 3; ++c) {
          CHECK(color[i * 3 + c] == on * 2 * float(tint[c]) * s[i]); // gain is 2 by default
          CHECK(doubled[i * 3 + c] == on * 4 * float(tint[c]) * s[i]);
        }
        CHECK(opacity[i * 3] == on * 2 * 0.125f);
        CHECK(opacity[i * 3 + 2] == on * 2 * 0.625f);
      }
      // The fixture's wide entry leaves the number of its full groups in P.x.
      float P[3];
      anysl_batch_read_float(batch.get(), ANYSL_P, 5, 1, P, 3);
      CHECK(P[0] == (width == 1 ? 0 : 2));
    }
  }
}

TEST_CASE("varying parameters come point by point", "[host]") {
  for (std::string name : everyLayout) {
    INFO(name);
    Library library = open(name);
    Instance instance = instantiate(library.get());
    Batch batch = batchFor(instance.get(), 19);
    float one = 1;
    anysl_batch_write_float(batch.get(), ANYSL_s, 0, 19, &one, 0);
    std::vector<float> gain = values(19, 1), steps(38);
    std::vector<double> wideSteps(38);
    for (int i = 0; i < 38; ++i)
      wideSteps[i] = i % 2 ? 100 * i : -1;
    REQUIRE(anysl_batch_bind_float(batch.get(), "gain", 0, 19, gain.data(), 1) == ANYSL_OK);
    REQUIRE(anysl_batch_bind_double(batch.get(), "steps", 0, 19, wideSteps.data(), 2) == ANYSL_OK);
    REQUIRE(anysl_shade(instance.get(), batch.get(), 0, 19, 0) == ANYSL_OK);
    std::vector<double> color(19 * 3);
    anysl_batch_read_double(batch.get(), ANYSL_Ci, 0, 19, color.data(), 3);
    for (int i = 0; i < 19; ++i)
      CHECK(color[i * 3 + 1] == i + 100 * (2 * i + 1)); // tint.g is 1
    // Without them, the instance's own values count again.
    CHECK(anysl_batch_unbind(batch.get(), "gain") == ANYSL_OK);
    CHECK(anysl_batch_unbind(batch.get(), "steps") == ANYSL_OK);
    REQUIRE(anysl_shade(instance.get(), batch.get(), 0, 19, 0) == ANYSL_OK);
    anysl_batch_read_double(batch.get(), ANYSL_Ci, 0, 19, color.data(), 3);
    CHECK(color[18 * 3 + 1] == 2);
  }
}

TEST_CASE("derivatives of varying parameters lie as their values do", "[host]") {
  for (std::string name : everyLayout) {
    INFO(name);
    Library library = open(name);
    Instance instance = instantiate(library.get());
    Batch batch = batchFor(instance.get(), 19);
    const AnyslShadeArgs *args = anysl_batch_args(batch.get());
    const AnyslShaderInfo *shader = anysl_instance_shader(instance.get());
    const auto steps = uint32_t(anysl_shader_param(shader, "steps") - shader->params);
    const auto gain = uint32_t(anysl_shader_param(shader, "gain") - shader->params);
    std::vector<double> byU(38), byV(38);
    for (int i = 0; i < 38; ++i)
      byU[i] = i, byV[i] = -2 * i;
    auto bind = [&](const char *param) {
      return anysl_batch_bind_derivatives_double(batch.get(), param, 0, 19, byU.data(), byV.data(),
                                                 2);
    };
    CHECK(bind("steps") == ANYSL_ERROR_STATE); // it has no values yet
    float zero[2] = {};
    for (const char *param : {"gain", "steps"})
      REQUIRE(anysl_batch_bind_float(batch.get(), param, 0, 19, zero, 0) == ANYSL_OK);
    REQUIRE(bind("gain") == ANYSL_OK); // nobody reads those
    CHECK(args->param_by_u == nullptr);
    REQUIRE(bind("steps") == ANYSL_OK);
    CHECK(args->param_by_u[gain] == nullptr);
    auto at = [&](void *const *arrays, uint32_t element, uint32_t point) {
      // Of one component, both layouts are alike.
      size_t index = element * args->data_stride + point;
      return anysl_library_info(library.get())->real == ANYSL_REAL_DOUBLE
                 ? static_cast<const double *>(arrays[steps])[index]
                 : double(static_cast<const float *>(arrays[steps])[index]);
    };
    for (uint32_t i = 0; i < 38; ++i) {
      CHECK(at(args->param_by_u, i % 2, i / 2) == byU[i]);
      CHECK(at(args->param_by_v, i % 2, i / 2) == byV[i]);
    }
    REQUIRE(anysl_batch_unbind(batch.get(), "steps") == ANYSL_OK);
    CHECK(args->param_by_u[steps] == nullptr);
    CHECK(args->param_by_v[steps] == nullptr);
    CHECK(bind("tent") == ANYSL_ERROR_NAME);
    CHECK(anysl_batch_bind_derivatives_float(batch.get(), "steps", 18, 2, zero, zero, 0) ==
          ANYSL_ERROR_RANGE);
  }
}

TEST_CASE("mistakes with batches are refused", "[host]") {
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  Batch batch = batchFor(instance.get(), 8);
  float value[3] = {};
  CHECK(anysl_batch_write_float(batch.get(), ANYSL_P, 4, 5, value, 0) == ANYSL_ERROR_RANGE);
  CHECK(message() == "soa-float.so: shader 'ramp': points 4 to 9 are outside a batch of 8");
  CHECK(anysl_batch_write_float(batch.get(), 77, 0, 1, value, 0) == ANYSL_ERROR_NAME);
  CHECK(anysl_batch_write_float(batch.get(), ANYSL_dPdu, 0, 8, value, 0) == ANYSL_OK); // not needed
  CHECK(anysl_batch_read_float(batch.get(), ANYSL_dPdu, 0, 1, value, 0) == ANYSL_ERROR_NAME);
  CHECK(message() ==
        "soa-float.so: shader 'ramp': the batch has no room for the global 'dPdu', which the "
        "shader does not use");
  CHECK(anysl_shade(instance.get(), batch.get(), 0, 9, 0) == ANYSL_ERROR_RANGE);
  CHECK(anysl_shade(instance.get(), batch.get(), 0, 8, 16) == ANYSL_ERROR_RANGE);
  CHECK(message() == "soa-float.so: shader 'ramp': no code for width 16; it has 1, 4");
  CHECK(anysl_batch_set_count(batch.get(), 3) == ANYSL_OK);
  CHECK(anysl_shade(instance.get(), batch.get(), 0, 4, 0) == ANYSL_ERROR_RANGE);
  CHECK(anysl_batch_set_count(batch.get(), 9) == ANYSL_ERROR_RANGE);
  CHECK(anysl_batch_bind_float(batch.get(), "Kd", 0, 1, value, 1) == ANYSL_ERROR_TYPE);
  CHECK(message() == "soa-float.so: shader 'ramp': parameter 'Kd' is uniform");
  CHECK(anysl_batch_bind_float(batch.get(), "label", 0, 1, value, 1) == ANYSL_ERROR_TYPE);
  CHECK(anysl_batch_want_output(batch.get(), "gain") == ANYSL_ERROR_TYPE);
  CHECK(message() == "soa-float.so: shader 'ramp': parameter 'gain' is not an output parameter");
  CHECK(anysl_batch_read_output_float(batch.get(), "doubled", 0, 1, value, 3) == ANYSL_ERROR_STATE);
  AnyslBatch *none = nullptr;
  CHECK(anysl_batch_create(instance.get(), 0, 0, &none) == ANYSL_ERROR_RANGE);
  CHECK(none == nullptr);

  AnyslInstance *other = nullptr;
  REQUIRE(anysl_instance_create(library.get(), "plain", nullptr, nullptr, &other) == ANYSL_OK);
  CHECK(anysl_shade(other, batch.get(), 0, 1, 0) == ANYSL_ERROR_STATE);
  anysl_instance_free(other);
}

TEST_CASE("many threads use one library, one instance and parts of one batch", "[host]") {
  constexpr uint32_t count = 4096, threads = 8, part = count / threads;
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  Batch batch = batchFor(instance.get(), count);
  std::vector<float> s = values(count, 1);
  anysl_batch_write_float(batch.get(), ANYSL_s, 0, count, s.data(), 1);
  std::vector<std::thread> pool;
  std::vector<int> failures(threads);
  for (uint32_t t = 0; t < threads; ++t)
    pool.emplace_back([&, t] {
      for (int round = 0; round < 20; ++round)
        failures[t] +=
            anysl_shade(instance.get(), batch.get(), t * part, (t + 1) * part, 0) != ANYSL_OK;
      // Each also has a batch of its own.
      AnyslBatch *own = nullptr;
      failures[t] += anysl_batch_create(instance.get(), 16, 0, &own) != ANYSL_OK;
      float x = float(t), color[3];
      anysl_batch_write_float(own, ANYSL_s, 0, 16, &x, 0);
      failures[t] += anysl_shade(instance.get(), own, 0, 16, 0) != ANYSL_OK;
      anysl_batch_read_float(own, ANYSL_Ci, 15, 1, color, 3);
      failures[t] += color[1] != 2 * float(t);
      anysl_batch_free(own);
    });
  for (std::thread &thread : pool)
    thread.join();
  for (int failed : failures)
    CHECK(failed == 0);
  std::vector<float> color(count * 3);
  anysl_batch_read_float(batch.get(), ANYSL_Ci, 0, count, color.data(), 3);
  int wrong = 0;
  for (uint32_t i = 0; i < count; ++i)
    wrong += color[i * 3 + 1] != 2 * float(i);
  CHECK(wrong == 0);
}

TEST_CASE("a renderer with arrays of its own fills the arguments itself", "[host]") {
  double own = 1;
  Library library = open("soa-float");
  Instance instance = instantiate(library.get(), nullptr, &own);
  AnyslShadeArgs args;
  anysl_instance_fill_args(instance.get(), &args);
  CHECK(args.struct_size == sizeof args);
  CHECK(args.renderer == &own);
  REQUIRE(args.services);
  CHECK(args.services->trace == nullptr);
  CHECK(args.params[0].number == 0.5);
  CHECK(args.lights == nullptr);
  alignas(64) float arrays[16][16] = {};
  void *globals[ANYSL_COMPONENT_COUNT] = {};
  int next = 0;
  for (int global : {ANYSL_COMPONENT_P, ANYSL_COMPONENT_N, ANYSL_COMPONENT_Ci, ANYSL_COMPONENT_Oi})
    for (int c = 0; c < 3; ++c)
      globals[global + c] = arrays[next++];
  globals[ANYSL_COMPONENT_s] = arrays[next++];
  globals[ANYSL_COMPONENT_time] = arrays[next++];
  args.globals = globals;
  args.count = 5;
  arrays[12][4] = 3;
  anysl_shader_entry(anysl_instance_shader(instance.get()), 4)(&args, 0, 5);
  CHECK(arrays[7][4] == 6); // Ci.g = gain * tint.g * s
}

#if defined(__x86_64__)
TEST_CASE("opening, shading and closing leave the floating-point mode alone", "[host]") {
  unsigned before = _mm_getcsr();
  for (unsigned mode :
       {before, before | 0x8040u /* flush denormals */, before | 0x6000u /* toward 0 */}) {
    _mm_setcsr(mode);
    {
      Library library = open("soa-float");
      Instance instance = instantiate(library.get());
      Batch batch = batchFor(instance.get(), 4);
      anysl_shade(instance.get(), batch.get(), 0, 4, 0);
    }
    unsigned after = _mm_getcsr();
    _mm_setcsr(before);
    CHECK((after & 0xffc0u) == (mode & 0xffc0u)); // all but the sticky exception flags
  }
}
#endif
