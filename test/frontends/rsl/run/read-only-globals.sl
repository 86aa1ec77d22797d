/* What only the renderer sets may be assigned: the shader then goes on with a copy of its own, which built-ins that look at
   the global see as well, and the renderer's value stays.

RUN: rslc -verify -fsyntax-only %s
RUN: rslc -w %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1,8 -o %t.so
RUN: anysl-info %t.so | FileCheck %s --check-prefix INFO
RUN: anysl-shade %t.so --grid 3x1 --width 1 --print Ci --print I | FileCheck %s
RUN: anysl-shade %t.so --grid 3x1 --width 8 --print Ci --print I | FileCheck %s

INFO: writes{{ *}}Ci
CHECK: 0 0  Ci 0.6{{[0-9]*}} 0 0.8{{[0-9]*}}  I 0 0 -1
CHECK: 1 0  Ci 0.6{{[0-9]*}} 0.5 0.8{{[0-9]*}}  I 0 0 -1
*/
surface copies() {
  I = normalize(vector(3, 0, -4)); // expected-warning {{'I' is read-only; the assignment changes the shader's own copy}}
  u *= 1;                          // expected-warning {{'u' is read-only}}
  vector R = reflect(I, N);
  Ci = color(R[0], u, R[2]);
}
