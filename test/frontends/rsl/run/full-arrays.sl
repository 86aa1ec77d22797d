// What an array has no room for is left out, and the renderer is told once for each place; rslc may be asked for more room.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 100x1 --width 8 --print a --print b > %t.8 2> %t.warnings
// RUN: anysl-shade %t.so --grid 100x1 --width 1 --print a --print b 2> %t.warnings.1 | diff %t.8 -
// RUN: FileCheck %s < %t.8
// RUN: FileCheck %s --check-prefix=WARNED --implicit-check-not=warning < %t.warnings
// RUN: diff %t.warnings %t.warnings.1
// RUN: rslc --array-capacity=100 %s -o %t.bc && anysl-link %t.bc -o %t.so --width 8
// RUN: anysl-shade %t.so --grid 100x1 --print a --print b 2>&1 | FileCheck %s --check-prefix=ROOM --implicit-check-not=warning
// RUN: not rslc --array-capacity=0 %s -o %t.bc 2>&1 | FileCheck %s --check-prefix=ABSURD
// RUN: not rslc --array-capacity=100000 %s -o %t.bc 2>&1 | FileCheck %s --check-prefix=ABSURD
// ABSURD: error: --array-capacity must be from 1 to 65536

surface full(output varying float a = 0, b = 0) {
  float list[], sized[];
  float i, n = floor(99 * s + 0.5);
  for (i = 0; i < n; i += 1)
// WARNED-DAG: full-arrays.sl:[[@LINE+1]]: warning: array 'list' has no room for more than 64 elements; rslc --array-capacity gives it more
    push(list, i);
// WARNED-DAG: full-arrays.sl:[[@LINE+1]]: warning: array 'sized' has no room for more than 64 elements; rslc --array-capacity gives it more
  resize(sized, n);
  a = arraylength(list);
  b = arraylength(sized);
}

// CHECK: 50 0 a 50 b 50
// CHECK: 99 0 a 64 b 64
// ROOM: 50 0 a 50 b 50
// ROOM: 99 0 a 99 b 99
