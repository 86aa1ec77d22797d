// Parameters as the host sets them: a later default uses what was set, varying ones come point by point.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 3x1 --width 8 --print out | FileCheck %s
// RUN: anysl-shade %t.so --grid 3x1 --width 8 --param a=5 --print out | FileCheck %s --check-prefix=SET
// RUN: anysl-shade %t.so --grid 3x1 --width 1 --param a=5 --param list=1,2 --param c=1,2,3 --param name=other --print out | FileCheck %s --check-prefix=ALL

float twice(float x) { return 2 * x; }

surface parameters(float a = 1; float b = twice(a) + 0.5; color c = a; float list[2] = {10, 20};
                   string name = "name"; varying float v = 3; varying float w = s + v;
                   output varying float out = 0) {
  out = a + b + c[1] + list[0] + list[1] + w;
  if (name == "other")
    out += 1000;
}

// 1 + 2.5 + 1 + 30 + s + 3
// CHECK: 0 0  out 37.5
// CHECK: 1 0  out 38
// CHECK: 2 0  out 38.5
// 5 + 10.5 + 5 + 30 + s + 3
// SET: 0 0  out 53.5
// SET: 2 0  out 54.5
// 5 + 10.5 + 2 + 3 + s + 3 + 1000
// ALL: 0 0  out 1023.5
// ALL: 2 0  out 1024.5
