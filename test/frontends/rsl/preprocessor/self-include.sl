// A file that includes itself, twice, is stopped at once.
// RUN: not rslc %s -o %t.bc 2>&1 | FileCheck %s

// CHECK: in file included from
// CHECK: error: files include each other more than 100 deep
// CHECK: 1 error generated.
#include "self-include.sl"
#include "self-include.sl"
surface s() { Ci = 1; }
