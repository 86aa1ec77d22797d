// #line changes what messages and debug locations name.
// RUN: not rslc %s -o %t.bc -DBAD 2>&1 | FileCheck %s
// RUN: rslc -S -o - %s | FileCheck %s --check-prefix=STC

// CHECK: original.sl:102:8: error: unknown variable 'x'
// CHECK-NEXT: Ci = x;
// CHECK-NEXT: ^
// STC: DIFile(filename: "original.sl"
// STC: DILocation(line: 104, column: 6
#line 100 "original.sl"
surface line() {
#ifdef BAD
  Ci = x;
#endif
  Ci = 1;
}
