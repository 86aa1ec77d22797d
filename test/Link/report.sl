/* --report says what was done, as JSON.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1,8 -o %t.so --report %t.json
RUN: python3 -m json.tool %t.json | FileCheck %s
RUN: anysl-link %t.stc.bc --width 8 --runtime scalar -o %t.so --report %t.scalar.json
RUN: FileCheck %s --check-prefix SCALAR < %t.scalar.json
RUN: rm -rf %t.only && mkdir %t.only && cd %t.only && anysl-link %t.stc.bc --report-only --report only.json
RUN: ls %t.only | FileCheck %s --check-prefix FILES --match-full-lines
RUN: FileCheck %s --check-prefix ONLY < only.json
RUN: not anysl-link %t.stc.bc --report-only 2>&1 | FileCheck %s --check-prefix NEEDS
RUN: not anysl-link %t.stc.bc --report-only --report only.json -o %t.so 2>&1 | FileCheck %s --check-prefix NEEDS
RUN: not anysl-link %t.stc.bc --width 1 -o %t.so --report %t.none/x.json 2>&1 | FileCheck %s --check-prefix ERROR

CHECK: "math": "u10"
CHECK: "output": "{{.*}}.so"
CHECK-NEXT: "outputBytes": {{[1-9][0-9]+}},
CHECK: "runtime": "packet"
CHECK: "callsLeft": [
CHECK-NEXT: "packet_trace"
CHECK: "effects": [
CHECK: "Trace"
CHECK: "fallbacks": []
CHECK: "globalsRead": [
CHECK-NEXT: "P",
CHECK-NEXT: "N",
CHECK-NEXT: "I"
CHECK: "globalsWritten": [
CHECK-NEXT: "Ci"
CHECK: "name": "mirror"
CHECK: "ops": [
CHECK: "reflect"
CHECK: "trace_color"
CHECK: "services": [
CHECK-NEXT: "Trace"
CHECK: "widths": [
CHECK-NEXT: 1,
CHECK-NEXT: 8
CHECK: "stage": "optimize"

Alone it is made without code, and knows what is known by then.
FILES: only.json
FILES-NOT: {{.}}
ONLY: "carriesDerivatives": false
ONLY: "output": ""
ONLY: "effects": [
ONLY: "Trace"
ONLY: "expandedInstructions": {{[1-9]}}
ONLY: "scalarInstructions": 0
NEEDS: error: --report-only goes with --report, and without -o

The scalar runtime has no wide form of trace, so each lane asks by itself; its points are structures, so
inputs are gathered, where the shader names them.
SCALAR: "fallbacks": [
SCALAR: "line": [[#@LINE+7]],
SCALAR-NEXT: "message": "loads from an unrelated address in each lane"
SCALAR: "function": "(anonymous namespace)::scalarTrace(
SCALAR: "kind": "lane by lane"
ERROR: x.json: error: cannot write the file
*/

surface mirror() {
  vector dir = reflect(I, N);

  Ci = trace(P, dir);
}
