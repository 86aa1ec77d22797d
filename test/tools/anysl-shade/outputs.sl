// Output parameters are printed as the shader leaves them: texts, arrays, and what it never assigns.
// RUN: rslc %s -o %t.bc
// RUN: anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-link %t.bc -o %t.scalar.so --width 4 --runtime scalar --real double
// DEFINE: %{print} = --grid 3x1 --param label=given --print kind --print label --print names --print kept --print before --print list --print uniformly
// RUN: anysl-shade %t.so --width 8 %{print} | FileCheck %s
// RUN: anysl-shade %t.so --width 1 %{print} | FileCheck %s
// RUN: anysl-shade %t.scalar.so %{print} | FileCheck %s
// RUN: anysl-shade %t.so %{print} --json | FileCheck %s --check-prefix JSON
// RUN: not anysl-shade %t.so --set kind=1 2>&1 | FileCheck %s --check-prefix SET

// CHECK: 0 0  kind "left"  label "given"  names "\"a\\" "c"  kept 5  before 0  list 1 2 0 0 1 1  uniformly 7
// CHECK: 1 0  kind "left"  label "given"  names "\"a\\" "c"  kept 5  before 0.5  list 1 2 0 0 1 1  uniformly 7
// CHECK: 2 0  kind "left"  label "given"  names "\"a\\" "c"  kept 9  before 1  list 1 2 0 0 1 1  uniformly 7
// JSON: "kind":["left","left","left"],
// JSON-NEXT: "label":["given","given","given"],
// JSON-NEXT: "names":{{\[\["\\"a\\\\","c"\],\["\\"a\\\\","c"\],\["\\"a\\\\","c"\]\]}},
// SET: --set: 'kind' is a uniform parameter
surface outputs(float where = 0; output string kind = "middle"; output string label = "none", names[2] = {"\"a\\", "b"};
                output varying float kept = 5, before = s; output vector list[2] = {(1, 2, 0), (0, 1, 1)};
                output float uniformly = 7;) {
  kind = where < 0.5 ? "left" : "right";
  names[1] = "c";
  if (s == 1)
    kept = 9;
}
