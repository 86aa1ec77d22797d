// Every half that a varying parameter may have arrives in the shader as the float that it is, at every width; from a
// library that reads halves where they lie as from one for which libanysl converts them.
//
// UNSUPPORTED: sanitizer
// (it links a program without the sanitizer's runtime)
// RUN: rslc %S/Inputs/half.sl -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --runtime packet-half --width 1,4,8,16 -o %t.half.so
// RUN: anysl-link %t.stc.bc --runtime packet-half --width 4 --mcpu x86-64-v2 -o %t.v2.so
// RUN: anysl-link %t.stc.bc --runtime packet --width 8 -o %t.float.so
// RUN: anysl-link %t.stc.bc --runtime scalar --real double --width 4 -o %t.double.so
// RUN: clang -std=c99 -O1 %anysl_include %s -L%lib_dir -Wl,-rpath,%lib_dir -lanysl -lm -o %t
// RUN: %t %t.half.so kept && %t %t.v2.so kept && %t %t.float.so converted && %t %t.double.so converted
//
// With derivatives, which stay numbers of the library's own format.
// RUN: anysl-link %t.stc.bc --runtime packet-half --real dual --width 1,8 -o %t.dual.so
// RUN: %t %t.dual.so kept

#include <anysl/anysl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 1 << 16 };

/* By the definition of binary16. */
static double number(unsigned half) {
  int exponent = half >> 10 & 31, fraction = half & 1023;
  double magnitude = exponent == 31 ? (fraction ? NAN : INFINITY)
                     : exponent     ? ldexp(1024 + fraction, exponent - 25)
                                    : ldexp(fraction, -24);
  return half >> 15 ? -magnitude : magnitude;
}

static int isSame(double a, double b) {
  return isnan(a) ? isnan(b) : a == b && !signbit(a) == !signbit(b);
}

static void check(AnyslStatus status) {
  if (status) {
    fprintf(stderr, "%s\n", anysl_last_error());
    exit(1);
  }
}

static double results[COUNT], colors[COUNT][3];

static void shade(const AnyslInstance *instance, AnyslBatch *batch, unsigned width) {
  check(anysl_shade(instance, batch, 0, COUNT, width));
  check(anysl_batch_read_output_double(batch, "seen", 0, COUNT, results, 1));
  check(anysl_batch_read_double(batch, ANYSL_Ci, 0, COUNT, colors[0], 3));
}

int main(int argc, char **argv) {
  AnyslLibrary *library;
  AnyslInstance *instance;
  AnyslBatch *batch;
  if (argc != 3)
    return 2;
  check(anysl_library_open(argv[1], 0, &library));
  check(anysl_instance_create(library, NULL, NULL, NULL, &instance));
  check(anysl_batch_create(instance, COUNT, 0, &batch));
  check(anysl_batch_want_output(batch, "seen"));

  static uint16_t halves[COUNT], triples[COUNT][3];
  for (unsigned i = 0; i < COUNT; ++i) {
    halves[i] = (uint16_t)i;
    for (unsigned c = 0; c < 3; ++c)
      triples[i][c] = (uint16_t)(i * (2 * c + 1) + c);
  }
  check(anysl_batch_bind_half(batch, "value", 0, COUNT, halves, 1));
  check(anysl_batch_bind_half(batch, "tint", 0, COUNT, triples[0], 3));
  /* An output is written, too: it has the library's own format. */
  check(anysl_batch_bind_half(batch, "both", 0, COUNT, halves, 1));

  const AnyslShaderInfo *shader = anysl_instance_shader(instance);
  const AnyslShadeArgs *args = anysl_batch_args(batch);
  int failures = 0;
  if (!anysl_library_info(library)->reads_half == !strcmp(argv[2], "kept"))
    failures += fprintf(stderr, "reads_half is %u\n", anysl_library_info(library)->reads_half);
  for (unsigned e = 0; e < shader->entry_count; ++e) {
    shade(instance, batch, shader->entries[e].width);
    for (unsigned i = 0; i < COUNT && failures < 10; ++i) {
      if (!isSame(number(i), results[i]))
        failures += fprintf(stderr, "%#x gives %g at width %u\n", i, results[i],
                            shader->entries[e].width);
      for (unsigned c = 0; c < 3; ++c)
        if (!isSame(number(triples[i][c]), colors[i][c]))
          failures += fprintf(stderr, "component %u: %#x gives %g\n", c, triples[i][c], colors[i][c]);
    }
    double both;
    check(anysl_batch_read_output_double(batch, "both", 0x3c00, 1, &both, 1));
    if (both != 2)
      failures += fprintf(stderr, "an output that was bound gives %g\n", both);
    check(anysl_batch_bind_half(batch, "both", 0, COUNT, halves, 1));
  }

  /* One number that is no half, and the array is one of the library's reals; the others stay. */
  float third = 1.f / 3;
  check(anysl_batch_bind_float(batch, "value", 7, 1, &third, 1));
  shade(instance, batch, 0);
  for (unsigned i = 0; i < COUNT && failures < 10; ++i)
    if (!isSame(i == 7 ? third : number(i), results[i]))
      failures += fprintf(stderr, "%#x gives %g beside a float\n", i, results[i]);

  /* The same numbers for who reads the arrays of a batch. */
  AnyslQuery query = {ANYSL_QUERY_surface, ANYSL_COLOR, 0, 0, 0, 0, "tint", ""};
  AnyslCell cell[3];
  AnyslShadeArgs filled;
  anysl_instance_fill_args(instance, &filled);
  filled.param_data = args->param_data;
  filled.param_is_set = args->param_is_set;
  filled.data_stride = args->data_stride;
  if (!anysl_instance_answer(instance, &filled, 12345, &query, cell) ||
      cell[1].number != number(triples[12345][1]))
    failures += fprintf(stderr, "a question gives another number\n");

  anysl_batch_free(batch);
  anysl_instance_free(instance);
  anysl_library_close(library);
  return failures != 0;
}
