// Shaders can be part of the program: an object file of the linker's, adopted under a name for messages.
//
// UNSUPPORTED: sanitizer
// (it links a program without the sanitizer's runtime)
// RUN: echo 'surface half(float a = 0.5;) { Ci = a * Cs; } surface twice() { Ci = 2 * Cs; }' > %t.sl
// RUN: rslc %t.sl -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --emit obj -o %t.o
// RUN: clang -std=c99 -Wall -Werror %anysl_include %s %t.o -L%lib_dir -Wl,-rpath,%lib_dir -lanysl -o %t
// RUN: %t | FileCheck %s
// CHECK: half: 0.5 1 2
// CHECK: twice: 2 4 8
// CHECK: built-in shaders: no shader 'third'; it has half, twice

#include <anysl/anysl.h>
#include <stdio.h>

extern const AnyslLibraryInfo anysl_library;

static void shade(AnyslLibrary *library, const char *name) {
  const float Cs[3] = {1, 2, 4};
  float Ci[3] = {0, 0, 0};
  AnyslInstance *instance = NULL;
  AnyslBatch *batch = NULL;
  if (anysl_instance_create(library, name, NULL, NULL, &instance) || anysl_batch_create(instance, 5, 0, &batch) ||
      anysl_batch_write_float(batch, ANYSL_Cs, 0, 5, Cs, 0) || anysl_shade(instance, batch, 0, 5, 0) ||
      anysl_batch_read_float(batch, ANYSL_Ci, 4, 1, Ci, 3))
    printf("%s\n", anysl_last_error());
  else
    printf("%s: %g %g %g\n", name, Ci[0], Ci[1], Ci[2]);
  anysl_batch_free(batch);
  anysl_instance_free(instance);
}

int main(void) {
  AnyslLibrary *library;
  if (anysl_library_adopt(&anysl_library, "built-in shaders", 0, &library))
    return 1;
  shade(library, "half");
  shade(library, "twice");
  shade(library, "third");
  anysl_library_close(library);
  return 0;
}
