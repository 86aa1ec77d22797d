// A light shader runs once for a position however often it is asked about, for the points that ask and no others, and
// its services get the surface's own points. Arrays of the renderer's own give the same, with results kept or not.
//
// UNSUPPORTED: sanitizer
// (it links a program without the sanitizer's runtime)
// RUN: printf 'light lamp() { illuminate (point (0, 0, 4)) Cl = transmission(Ps, P) * random() / (L . L); }' > %t.lamp.sl
// RUN: printf 'surface lit() { Ci = diffuse(N) + specular(N, N, 1); Oi = 0; illuminance (P + N) Oi += Cl; if (s > 0.5) Oi += diffuse(N); }' > %t.sl
// RUN: rslc %t.sl -o %t.stc.bc
// RUN: rslc %t.lamp.sl -o %t.lamp.stc.bc
// RUN: anysl-link %t.lamp.stc.bc --width 1,4,8,16 -o %t.lamp.so
// RUN: anysl-link %t.stc.bc --width 1,4,8,16 -o %t.so
// RUN: anysl-link %t.stc.bc --runtime scalar --width 1,4,8,16 -o %t.scalar.so
// RUN: clang -std=c99 -Wall -Werror %anysl_include %s -L%lib_dir -Wl,-rpath,%lib_dir -lanysl -o %t
// RUN: %t %t.so %t.lamp.so | FileCheck %s --check-prefixes CHECK,OWN
// RUN: %t %t.scalar.so %t.lamp.so | FileCheck %s
// CHECK: width 1: 107 rays, right
// CHECK: width 4: 107 rays, right
// CHECK: width 8: 107 rays, right
// CHECK: width 16: 107 rays, right
// OWN: own arrays: 107 rays, right
// OWN: nothing kept: 150 rays, right

#include <anysl/anysl.h>
#include <stdio.h>

#define POINTS 43 /* 21 of them have s = 1 */

static float P[POINTS][3], s[POINTS], first[2][POINTS][3];
static int rays, wrong;

static void transmission(void *renderer, const AnyslShadeArgs *args, uint32_t point, const double from[3],
                         const double to[3], double color[3]) {
  ++rays;
  wrong += renderer != &rays || args->batch != (void *)P || from[0] != P[point][0] || to[2] != 0;
  color[0] = color[1] = color[2] = 1 + point % 3;
}

static void check(int error) {
  if (error) {
    printf("%s\n", anysl_last_error());
    ++wrong;
  }
}

static void report(const char *what, float results[2][POINTS][3]) {
  for (int i = 0; i < 2 * POINTS * 3; ++i) {
    wrong += results[0][0][i] != first[0][0][i];
    wrong += i < POINTS * 3 && !(results[0][0][i] > 0);
  }
  printf("%s: %d rays, %s\n", what, rays, wrong ? "wrong" : "right");
  rays = wrong = 0;
}

/* Component by component, as the packet runtime has them. */
static void shadeOwnArrays(const AnyslInstance *surface, const AnyslLight *light, int keep, const char *what) {
  static float x[16][64], results[2][POINTS][3];
  const int inputs[] = {ANYSL_COMPONENT_P, ANYSL_COMPONENT_P + 1, ANYSL_COMPONENT_P + 2, ANYSL_COMPONENT_N,
                        ANYSL_COMPONENT_N + 1, ANYSL_COMPONENT_N + 2, ANYSL_COMPONENT_s, ANYSL_COMPONENT_Ci,
                        ANYSL_COMPONENT_Ci + 1, ANYSL_COMPONENT_Ci + 2, ANYSL_COMPONENT_Oi, ANYSL_COMPONENT_Oi + 1,
                        ANYSL_COMPONENT_Oi + 2};
  void *globals[ANYSL_COMPONENT_COUNT] = {0};
  AnyslShadeArgs args;
  int i, c;
  anysl_instance_fill_args(surface, &args);
  for (c = 0; c < 13; ++c)
    globals[inputs[c]] = x[c];
  for (i = 0; i < POINTS; ++i) {
    for (c = 0; c < 3; ++c)
      x[c][i] = P[i][c];
    x[5][i] = 1;
    x[6][i] = s[i];
  }
  args.globals = globals;
  args.count = POINTS;
  args.batch = P;
  args.lights = light;
  args.light_count = 1;
  if (keep)
    anysl_lights_begin(&args);
  anysl_shader_entry(anysl_instance_shader(surface), 8)(&args, 0, POINTS);
  if (keep)
    anysl_lights_end(&args);
  for (i = 0; i < POINTS; ++i)
    for (c = 0; c < 3; ++c) {
      results[0][i][c] = x[7 + c][i];
      results[1][i][c] = x[10 + c][i];
    }
  report(what, results);
}

int main(int argc, char **argv) {
  const uint32_t widths[] = {1, 4, 8, 16};
  const float N[3] = {0, 0, 1};
  AnyslServices services = {sizeof services};
  AnyslLibrary *surfaces, *lamps;
  AnyslInstance *surface, *lamp;
  AnyslBatch *batch;
  AnyslLight light;
  int i;
  services.transmission = transmission;
  for (i = 0; i < POINTS; ++i) {
    P[i][0] = i * 0.1f - 2;
    s[i] = (i * 7) % 2;
  }
  check(anysl_library_open(argv[1], 0, &surfaces) || anysl_library_open(argv[2], 0, &lamps));
  check(anysl_instance_create(surfaces, NULL, &services, &rays, &surface) ||
        anysl_instance_create(lamps, NULL, &services, &rays, &lamp));
  check(anysl_light_from_instance(surface, &light) != ANYSL_ERROR_TYPE);
  check(anysl_light_from_instance(lamp, &light));
  check(anysl_batch_create(surface, POINTS, anysl_lights_globals(&light, 1), &batch));
  anysl_batch_set_lights(batch, &light, 1, NULL);
  anysl_batch_set_user(batch, P);
  for (i = 0; i < 4; ++i) {
    static float results[2][POINTS][3];
    char what[20];
    check(anysl_batch_write_float(batch, ANYSL_P, 0, POINTS, P[0], 3) ||
          anysl_batch_write_float(batch, ANYSL_N, 0, POINTS, N, 0) ||
          anysl_batch_write_float(batch, ANYSL_s, 0, POINTS, s, 1) ||
          anysl_shade(surface, batch, 0, POINTS, widths[i]) ||
          anysl_batch_read_float(batch, ANYSL_Ci, 0, POINTS, results[0][0], 3) ||
          anysl_batch_read_float(batch, ANYSL_Oi, 0, POINTS, results[1][0], 3));
    if (i == 0)
      for (int k = 0; k < 2 * POINTS * 3; ++k)
        first[0][0][k] = results[0][0][k];
    sprintf(what, "width %u", widths[i]);
    report(what, results);
  }
  if (anysl_library_info(surfaces)->layout == ANYSL_LAYOUT_SOA) {
    shadeOwnArrays(surface, &light, 1, "own arrays");
    shadeOwnArrays(surface, &light, 0, "nothing kept");
  }
  anysl_batch_free(batch);
  anysl_instance_free(surface);
  anysl_instance_free(lamp);
  anysl_library_close(surfaces);
  anysl_library_close(lamps);
  return 0;
}
