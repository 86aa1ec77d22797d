// With -g the shared library has line tables that name the shader's lines, and not without.
// RUN: rm -rf %t && mkdir -p %t
// RUN: rslc -g %s -o %t/with.stc.bc && anysl-link %t/with.stc.bc -o %t/with.so --width 1,8
// RUN: llvm-dwarfdump --debug-line %t/with.so | FileCheck %s
// RUN: rslc %s -o %t/without.stc.bc && anysl-link %t/without.stc.bc -o %t/without.so --width 1,8
// RUN: llvm-dwarfdump --debug-line %t/without.so | FileCheck %s --check-prefix=NONE
// CHECK: name: {{.*}}line-tables.sl
// CHECK: {{^0x[0-9a-f]+ +}}[[@LINE+3]]
// NONE-NOT: name:
surface lines() {
  Ci = noise(P);
}
