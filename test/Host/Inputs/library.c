/*===-- test/Host/Inputs/library.c - a shader library written by hand ---------------------*- C -*-===
 *
 * Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
 * SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
 *
 *===--------------------------------------------------------------------------------------------===
 *
 * What anysl-link writes, in C, so that the host side is tested by itself. -D chooses layout and number
 * format, and makes the library wrong in one way or another. The shader is
 *
 *   surface ramp(float Kd = 0.5; color tint = color(Kd, 1, 0); string label = "none";
 *                float weights[3] = {1, 2, 3}; varying float gain = 2; output varying color doubled = 0;
 *                matrix m = 1; varying float steps[2] = {0, 0}; float fixed = 7)
 *   { Ci = gain * tint * s + steps[1]; Oi = trace(P, N) * time; doubled = 2 * Ci; }
 *
 * The entry of width 4 does the same, and leaves the number of its groups of 4 in P.x, so that tests see which entry
 * ran. The displacement `plain` does nothing.
 *
 *===--------------------------------------------------------------------------------------------===*/

#include <anysl/abi.h>

#ifndef MAGIC
#define MAGIC ANYSL_MAGIC
#endif
#ifndef ABI
#define ABI ANYSL_ABI_VERSION
#endif
#ifndef FEATURES
#define FEATURES "sse2,cmov"
#endif
#ifndef ARGS_SIZE
#define ARGS_SIZE sizeof(AnyslShadeArgs)
#endif
#ifndef LAYOUT
#define LAYOUT ANYSL_LAYOUT_SOA
#endif
#ifndef GLOBALS
#define GLOBALS ANYSL_GLOBAL_COUNT
#endif
#ifndef COMPONENTS
#define COMPONENTS ANYSL_COMPONENT_COUNT
#endif
#ifndef CELLS
#define CELLS 31
#endif
#ifdef DOUBLE
typedef double real;
#define REAL ANYSL_REAL_DOUBLE
#else
typedef float real;
#define REAL ANYSL_REAL_FLOAT
#endif

enum { Kd, Tint, Label, Weights, Gain, Doubled, M, Steps, Fixed };

static const AnyslParamInfo params[] = {
    {"Kd", ANYSL_FLOAT, 0, 0, 0},
    {"tint", ANYSL_COLOR, 0, 0, 1},
    {"label", ANYSL_STRING, 0, 0, 4},
    {"weights", ANYSL_FLOAT, 0, 3, 5},
    {"gain", ANYSL_FLOAT, ANYSL_PARAM_VARYING, 0, 8},
    {"doubled", ANYSL_COLOR, ANYSL_PARAM_VARYING | ANYSL_PARAM_OUTPUT, 0, 9},
    {"m", ANYSL_MATRIX, 0, 0, 12},
    {"steps", ANYSL_FLOAT, ANYSL_PARAM_VARYING | ANYSL_PARAM_DIFFERENTIATED, 2, 28},
    {"fixed", ANYSL_FLOAT, ANYSL_PARAM_FIXED, 0, 30},
};

static real *global(const AnyslShadeArgs *args, int component, uint32_t point, int uniform) {
  if (LAYOUT == ANYSL_LAYOUT_AOS)
    return (real *)args->globals[0] + (size_t)point * ANYSL_COMPONENT_COUNT + component;
  return (real *)args->globals[component] + (uniform ? 0 : point);
}

/* Component c of element e of a parameter that has n components, as <anysl/abi.h> says. */
static real *varying(const AnyslShadeArgs *args, int param, int n, int e, int c, uint32_t point) {
  real *data;
  if (!args->param_data || !args->param_data[param])
    return 0;
  data = args->param_data[param];
  return LAYOUT == ANYSL_LAYOUT_AOS ? data + (e * args->data_stride + point) * n + c
                                    : data + (e * n + c) * args->data_stride + point;
}

static void ramp_point(const AnyslShadeArgs *args, uint32_t point) {
  double traced[3] = {0, 0, 0}, P[3], N[3];
  const real *gain = varying(args, Gain, 1, 0, 0, point);
  const real *step = varying(args, Steps, 1, 1, 0, point);
  int c;
  for (c = 0; c < 3; ++c) {
    P[c] = *global(args, ANYSL_COMPONENT_P + c, point, 0);
    N[c] = *global(args, ANYSL_COMPONENT_N + c, point, 0);
  }
  if (args->services->trace)
    args->services->trace(args->renderer, args, point, P, N, traced);
  for (c = 0; c < 3; ++c) {
    real value = (real)((gain ? *gain : args->params[8].number) * args->params[1 + c].number *
                            *global(args, ANYSL_COMPONENT_s, point, 0) +
                        (step ? *step : args->params[29].number));
    real *doubled = varying(args, Doubled, 3, 0, c, point);
    *global(args, ANYSL_COMPONENT_Ci + c, point, 0) = value;
    *global(args, ANYSL_COMPONENT_Oi + c, point, 0) =
        (real)traced[c] * *global(args, ANYSL_COMPONENT_time, point, 1);
    if (doubled)
      *doubled = 2 * value;
  }
}

static void ramp_1(const AnyslShadeArgs *args, uint32_t first, uint32_t last) {
  for (; first < last; ++first)
    ramp_point(args, first);
}

static void ramp_4(const AnyslShadeArgs *args, uint32_t first, uint32_t last) {
  uint32_t groups = (last - first) / 4;
  uint32_t point;
  ramp_1(args, first, last);
  for (point = first; point < last; ++point)
    *global(args, ANYSL_COMPONENT_P, point, 0) = (real)groups;
}

static void ramp_init(const AnyslShadeArgs *args) {
  AnyslCell *cell = args->params;
  int i;
  if (!args->param_is_set[Kd])
    cell[0].number = 0.5;
  if (!args->param_is_set[Tint]) {
    cell[1].number = cell[0].number;
    cell[2].number = 1;
    cell[3].number = 0;
  }
  if (!args->param_is_set[Label])
    cell[4].string = "none";
  for (i = 0; i < 3 && !args->param_is_set[Weights]; ++i)
    cell[5 + i].number = i + 1;
  if (!args->param_is_set[Gain])
    cell[8].number = 2;
  for (i = 0; i < 16 && !args->param_is_set[M]; ++i)
    cell[12 + i].number = i % 5 == 0;
  cell[30].number = 7;
}

static void plain_1(const AnyslShadeArgs *args, uint32_t first, uint32_t last) {
  (void)args, (void)first, (void)last;
}

static const AnyslEntryInfo plain_entries[] = {{1, plain_1}};
static const AnyslEntryInfo entries[] = {{1, ramp_1}, {4, ramp_4}};

#define BIT(name) ((uint64_t)1 << ANYSL_##name)
static const AnyslShaderInfo shaders[] = {
    {"ramp", ANYSL_SURFACE, sizeof params / sizeof params[0], params, CELLS, 2, entries,
     BIT(P) | BIT(N) | BIT(s) | BIT(time), BIT(P) | BIT(Ci) | BIT(Oi), 1 << 2, 1 << 11 | 3, ramp_init},
    {"plain", ANYSL_DISPLACEMENT, 0, 0, 0, 1, plain_entries, 0, BIT(P), 0, 1, 0},
};

const AnyslLibraryInfo anysl_library = {MAGIC,
                                        ABI,
                                        sizeof(AnyslLibraryInfo),
                                        LAYOUT,
                                        REAL,
                                        GLOBALS,
                                        COMPONENTS,
                                        ARGS_SIZE,
                                        sizeof(AnyslServices),
                                        sizeof shaders / sizeof shaders[0],
                                        shaders,
                                        "by hand",
                                        "none",
                                        sizeof(real) == 4 ? "float" : "double",
                                        "cr",
                                        "x86-64",
                                        FEATURES};
