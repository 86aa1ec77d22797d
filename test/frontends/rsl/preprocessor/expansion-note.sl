// An error inside of a macro's expansion points at the macro's use, and a note at its definition.
// RUN: not rslc %s -o %t.bc 2>&1 | FileCheck %s

#define BLEND(a, b) mix(a, b, unknown)
#define OUTER(x) BLEND(x, x)

surface s() {
  Ci = OUTER(Cs);
  // An argument is where it was written.
  Ci = OUTER(wrong);
}

// CHECK: expansion-note.sl:8:8: error: unknown variable 'unknown'
// CHECK-NEXT: Ci = OUTER(Cs);
// CHECK-NEXT: ^~~~~
// CHECK: expansion-note.sl:5:9: note: in the expansion of macro 'OUTER', defined here
// CHECK: expansion-note.sl:10:14: error: unknown variable 'wrong'
// CHECK-NOT: note
