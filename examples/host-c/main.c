/* A whole renderer in 60 lines: opens a shader library, shades a row of points, prints their colours.
   docs/host-guide.md goes through it. */
#include <anysl/anysl.h>
#include <stdio.h>
#include <stdlib.h>

#define POINTS 13

/* Every call that can fail says why through anysl_last_error(). */
static void check(AnyslStatus status) {
  if (status != ANYSL_OK) {
    fprintf(stderr, "error: %s\n", anysl_last_error());
    exit(1);
  }
}

int main(int argc, char **argv) {
  const double bright[3] = {1, 0.5, 0.25};
  float s[POINTS], colors[POINTS][3];
  AnyslLibrary *library;
  AnyslInstance *instance;
  AnyslBatch *batch;
  const AnyslShaderInfo *shader;
  uint32_t i;

  if (argc != 2) {
    fprintf(stderr, "usage: %s SHADERS.so\n", argv[0]);
    return 1;
  }

  /* One library serves all threads; the second argument may ask to look at it only. */
  check(anysl_library_open(argv[1], 0, &library));

  /* A shader with its parameters: given by name, or left at their defaults. No services here: this
     renderer traces no rays. */
  check(anysl_instance_create(library, NULL, NULL, NULL, &instance));
  check(anysl_instance_set_numbers(instance, "bright", bright, 3));
  shader = anysl_instance_shader(instance);
  printf("%s %s, %u points at once\n", anysl_kind_name(shader->kind), shader->name,
         (unsigned)anysl_shader_widest(shader));

  /* What the shader reads, point by point. The batch has exactly the arrays that it needs. */
  for (i = 0; i < POINTS; ++i)
    s[i] = (float)i / (POINTS - 1);
  check(anysl_batch_create(instance, POINTS, 0, &batch));
  check(anysl_batch_write_float(batch, ANYSL_s, 0, POINTS, s, 1));

  check(anysl_shade(instance, batch, 0, POINTS, 0));
  check(anysl_batch_read_float(batch, ANYSL_Ci, 0, POINTS, colors[0], 3));
  for (i = 0; i < POINTS; ++i)
    printf("s = %.3f: %.3f %.3f %.3f\n", s[i], colors[i][0], colors[i][1], colors[i][2]);

  anysl_batch_free(batch);
  anysl_instance_free(instance);
  anysl_library_close(library);
  return 0;
}
