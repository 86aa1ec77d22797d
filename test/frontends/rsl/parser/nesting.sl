// What is nested too deeply is refused, not a crash.
// RUN: not rslc %s -o %t.bc 2>&1 | FileCheck %s
#define P10(x) ((((((((((x))))))))))
#define P100(x) P10(P10(P10(P10(P10(P10(P10(P10(P10(P10(x))))))))))
// CHECK: error: nested more than 256 levels deep
surface nesting() { Ci = P100(P100(P100(1))); }
