// A library for another processor is refused by name before anything of it runs; it can still be looked at.
//
// RUN: rslc %s -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --mcpu bdver4 -o %t.so
// RUN: not anysl-shade %t.so 2>&1 | FileCheck %s
// CHECK: anysl-shade: error: {{.*}}.so: compiled for bdver4, whose fma4, xop, tbm this processor lacks; link the shaders with a smaller --mcpu
// RUN: anysl-info %t.so | FileCheck %s --check-prefix=INFO
// INFO: target bdver4
// INFO: runs here no: compiled for bdver4, whose fma4, xop, tbm this processor lacks
// INFO: surface refused
// INFO: uniform float a{{$}}
//
// Code for the oldest processors runs everywhere.
// RUN: anysl-link %t.stc.bc --mcpu x86-64 --width 1,4,8,16 -o %t.old.so
// RUN: anysl-info %t.old.so | FileCheck %s --check-prefix=OLD
// OLD: runs here yes
// RUN: anysl-shade %t.old.so --width 16 --grid 2x1 --param a=3 | FileCheck %s --check-prefix=SHADED
// SHADED: 1 0 Ci 3 3 3

surface refused(float a = 1) { Ci = a * s; }
