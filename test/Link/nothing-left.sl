/* Beyond optimisation nothing of the threaded code is left: no operator, no call of one, and no stack
   slot in the shader. What remains of mirror is arithmetic and one call of the renderer.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1 -o %t.ll
RUN: not grep "@anysl_[a-z]*_*[a-z]*(" %t.ll
RUN: FileCheck %s < %t.ll
RUN: anysl-link %t.stc.bc --width 1 --runtime scalar --real double -o %t.double.ll
RUN: not grep "@anysl_[a-z]*_*[a-z]*(" %t.double.ll
RUN: FileCheck %s --check-prefix DOUBLE < %t.double.ll

Without a renderer's service there is no slot in the whole module.
RUN: echo 'surface reflectonly() { vector dir = reflect(I, N); Ci = color(xcomp(dir), ycomp(dir), 0); }' > %t.only.sl
RUN: rslc %t.only.sl -o %t.only.stc.bc
RUN: anysl-link %t.only.stc.bc --width 1 -o %t.only.ll
RUN: not grep -E " (alloca|call) " %t.only.ll

CHECK-LABEL: define internal void @mirror.w1(
CHECK-NOT: alloca
CHECK: fmul float
CHECK-NOT: alloca
CHECK: call { float, float, float } @packet_trace(
CHECK-NOT: {{call|alloca}}
CHECK: ret void

CHECK-LABEL: define internal void @plastic.w1(
CHECK-NOT: alloca
CHECK: ret void

CHECK-LABEL: define internal void @reflectonly.w1(
CHECK-NOT: {{call|alloca}}
CHECK: ret void

DOUBLE-LABEL: define internal void @mirror.w1(
DOUBLE-NOT: alloca
DOUBLE: fmul double
DOUBLE: ret void
DOUBLE-LABEL: define internal void @plastic.w1(
DOUBLE-NOT: alloca
DOUBLE: ret void

*/

surface mirror() {
  vector dir = reflect(I, N);
  Ci = trace(P, dir);
}

surface plastic(float Ka = 1, Kd = 0.5, Ks = 0.5, roughness = 0.1; color specularcolor = 1) {
  normal Nf = faceforward(normalize(N), I);
  Oi = Os;
  Ci = Os * (Cs * (Ka * ambient() + Kd * diffuse(Nf)) +
             specularcolor * Ks * specular(Nf, -normalize(I), roughness));
}

surface reflectonly() {
  vector dir = reflect(I, N);
  Ci = color(xcomp(dir), ycomp(dir), zcomp(dir));
}
