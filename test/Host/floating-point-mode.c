// A shader library that was linked with start-up code of -ffast-math does not change how its host computes.
//
// UNSUPPORTED: sanitizer
// (it links a program without the sanitizer's runtime)
// RUN: clang -shared -fPIC %anysl_include %S/Inputs/library.c %S/Inputs/flush-denormals.c -o %t.so
// RUN: clang -std=c99 -O1 %anysl_include %s -L%lib_dir -Wl,-rpath,%lib_dir -lanysl -ldl -o %t
// RUN: %t %t.so

#include <anysl/anysl.h>
#include <dlfcn.h>
#include <stdio.h>
#include <xmmintrin.h>

int main(int argc, char **argv) {
  AnyslLibrary *library;
  unsigned before = _mm_getcsr();
  if (anysl_library_open(argv[argc - 1], 0, &library)) {
    fprintf(stderr, "%s\n", anysl_last_error());
    return 1;
  }
  if (_mm_getcsr() != before)
    return 2;
  anysl_library_close(library);
  if (_mm_getcsr() != before)
    return 3;
  // The library would have changed it: otherwise this test proves nothing.
  dlopen(argv[argc - 1], RTLD_NOW | RTLD_LOCAL);
  return _mm_getcsr() == before ? 4 : 0;
}
