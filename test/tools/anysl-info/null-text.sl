// Text that nobody set is the empty text, also where a default gives no elements.
// RUN: rslc %s -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --width 1 -o %t.so
// RUN: anysl-info %t.so | FileCheck %s
// RUN: anysl-info %t.so --json | FileCheck %s --check-prefix JSON
// CHECK: uniform string layers[64] = {"", "",
// CHECK: uniform string one = ""
// JSON: "name": "layers"
// JSON: "default": [
// JSON-NEXT: ""
surface shaders(shader layers[] = null; shader one = null) { Ci = one == null ? 1 : 0; }
