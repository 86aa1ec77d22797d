/* A runtime without an operator that the shader reaches: one message names the operator, the runtime and the
   shader's line. The runtime here is packet with trace taken out, found by its name in the folder.

RUN: rm -rf %t && mkdir -p %t/bin %t/lib
RUN: cp %tools_dir/anysl-link %t/bin && cp -r %lib_dir/anysl %t/lib
RUN: llvm-extract --delete --func=anysl_trace_color --func=anysl_transmission %t/lib/anysl/runtime/packet.float.bc -o %t/lib/anysl/runtime/blind.float.bc
RUN: rslc %s -o %t/looking.stc.bc
RUN: not %t/bin/anysl-link %t/looking.stc.bc --runtime blind -o %t/looking.so 2>&1 | FileCheck %s
RUN: not ls %t/looking.so

What the shader does not reach may be missing.
RUN: echo 'surface plain() { Ci = Cs; }' > %t/plain.sl
RUN: rslc %t/plain.sl -o %t/plain.stc.bc
RUN: %t/bin/anysl-link %t/plain.stc.bc --runtime blind -o %t/plain.so

CHECK: missing-op.sl:[[#@LINE+7]]:[[#]]: error: operator 'anysl_trace_color' is not defined by runtime 'blind' with real 'float' nor by the shading library (shader 'looking')
CHECK-NEXT: Ci = trace(P, I)
CHECK: missing-op.sl:[[#@LINE+6]]:[[#]]: error: operator 'anysl_transmission' is not defined by runtime 'blind' {{.*}}; 'anysl_light_shadow' needs it (shader 'looking')
*/

surface looking() {
  float a = 1;
  Ci = trace(P, I) * a;
  Ci += diffuse(normalize(N));
}
