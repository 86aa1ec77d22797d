// A renderer is asked for the matrix of a coordinate system once for all points, at every width, also by a shader
// that looks at lights in between; a matrix whose name differs from point to point is asked for as needed. So it is
// with text, attributes and options; what can differ from point to point is asked for at each.
//
// UNSUPPORTED: sanitizer
// (it links a program without the sanitizer's runtime)
// RUN: printf 'surface once() { point Q = transform("room", P); Ci = diffuse(N) + float noise(Q * 3); }' > %t.sl
// RUN: printf 'surface names() { string n = "hall"; if (s > 0.5) n = "room"; Ci = xcomp(transform(n, P)); }' >> %t.sl
// RUN: printf 'surface text(float k = 3) { Ci = diffuse(N); Ci = format("%%%%g+%%%%g", k, k) == "3+3" ? 1 : 2; }' >> %t.sl
// RUN: printf 'surface texts() { Ci = format("%%%%g", s) == "1" ? 1 : 2; }' >> %t.sl
// RUN: printf 'surface attributes() { float x = 0, y[2]; option("o", y); Ci = diffuse(N); if (attribute("a", x) == 1) Ci = x + y[1]; }' >> %t.sl
// RUN: printf 'surface rays() { float x = 0; rayinfo("r", x); Ci = 2 - x; }' >> %t.sl
// RUN: rslc %t.sl -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --runtime packet --width 1,4,8,16 -o %t.packet.so
// RUN: anysl-link %t.stc.bc --runtime scalar --width 1,4,8,16 -o %t.scalar.so
// RUN: clang -std=c99 -Wall -Werror %anysl_include %s -L%lib_dir -Wl,-rpath,%lib_dir -lanysl -o %t
// RUN: %t %t.packet.so | FileCheck %s
// RUN: %t %t.scalar.so | FileCheck %s
// CHECK-COUNT-4: once: asked seldom, right
// CHECK-COUNT-4: names: asked often, right
// CHECK-COUNT-4: text: asked seldom, right
// CHECK-COUNT-4: texts: asked often, right
// CHECK-COUNT-4: attributes: asked seldom, right
// CHECK-COUNT-4: rays: asked often, right

#include <anysl/anysl.h>
#include <stdio.h>
#include <string.h>

#define POINTS 256

/* "room" is moved by 1 along x, "hall" by 2. */
static int spaceMatrix(void *renderer, const AnyslShadeArgs *args, const char *from, const char *to,
                       double matrix[16]) {
  int i;
  for (i = 0; i < 16; ++i)
    matrix[i] = i % 5 == 0;
  matrix[12] = !strcmp(to, "room") ? 1 : 2;
  ++*(int *)renderer;
  return !strcmp(to, "room") || !strcmp(to, "hall");
}

/* "3", then "3+3"; or "0" and "1" */
static const char *append(void *renderer, const char *text, const char *format, uint32_t index, uint32_t type,
                          const AnyslCell *value) {
  ++*(int *)renderer;
  if (type != ANYSL_FLOAT || strlen(format) > 5)
    return "?";
  return index ? (!strcmp(text, "3") ? "3+3" : "?") : value->number == 3 ? "3" : value->number == 1 ? "1" : "0";
}

/* The attribute is 3, elements of the option are 4; the ray's answer is the point's number, modulo 2. */
static int query(void *renderer, const AnyslShadeArgs *args, uint32_t point, const AnyslQuery *query,
                 AnyslCell *value) {
  ++*(int *)renderer;
  value->number = query->kind == ANYSL_QUERY_attribute ? 3 : query->kind == ANYSL_QUERY_option ? 4 : point % 2;
  return 1;
}

static void run(AnyslLibrary *library, const char *name, uint32_t width) {
  static float s[POINTS], Ci[POINTS][3];
  const float zero[3] = {0, 0, 0};
  AnyslServices services = {0};
  AnyslInstance *instance = NULL;
  AnyslBatch *batch = NULL;
  int i, calls = 0, right = 1, varying = !strcmp(name, "names") || !strcmp(name, "texts") || !strcmp(name, "rays");
  services.struct_size = sizeof services;
  services.space_matrix = spaceMatrix;
  services.append = append;
  services.query = query;
  for (i = 0; i < POINTS; ++i)
    s[i] = (float)(i % 2);
  if (anysl_instance_create(library, name, &services, &calls, &instance) ||
      anysl_batch_create(instance, POINTS, 0, &batch) ||
      anysl_batch_write_float(batch, ANYSL_P, 0, POINTS, zero, 0) ||
      anysl_batch_write_float(batch, ANYSL_s, 0, POINTS, s, 1) || anysl_shade(instance, batch, 0, POINTS, width) ||
      anysl_batch_read_float(batch, ANYSL_Ci, 0, POINTS, Ci[0], 3))
    printf("%s\n", anysl_last_error());
  for (i = 0; i < POINTS; ++i)
    right &= varying ? Ci[i][0] == (s[i] > 0.5f ? 1 : 2) : Ci[i][0] == Ci[0][0];
  printf("%s: asked %s, %s\n", name, calls <= 8 ? "seldom" : "often", right ? "right" : "wrong");
  anysl_batch_free(batch);
  anysl_instance_free(instance);
}

int main(int argc, char **argv) {
  const uint32_t widths[] = {1, 4, 8, 16};
  AnyslLibrary *library;
  int i;
  if (anysl_library_open(argv[argc - 1], 0, &library)) {
    printf("%s\n", anysl_last_error());
    return 1;
  }
  for (i = 0; i < 4; ++i)
    run(library, "once", widths[i]);
  for (i = 0; i < 4; ++i)
    run(library, "names", widths[i]);
  for (i = 0; i < 4; ++i)
    run(library, "text", widths[i]);
  for (i = 0; i < 4; ++i)
    run(library, "texts", widths[i]);
  for (i = 0; i < 4; ++i)
    run(library, "attributes", widths[i]);
  for (i = 0; i < 4; ++i)
    run(library, "rays", widths[i]);
  anysl_library_close(library);
  return 0;
}
