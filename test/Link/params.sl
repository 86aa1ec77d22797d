/* --param makes a parameter a constant: no code reads its cell any more, branches on it are decided, the
   descriptor says so, and the defaults store it.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1 --param tinted.amount=0.25 --param tint=1,0.5,0 -o %t.so --report %t.json
RUN: anysl-shade %t.so --print Ci --set Cs=1,1,1 | FileCheck %s --check-prefix VALUE
RUN: anysl-info %t.so | FileCheck %s --check-prefix INFO
RUN: FileCheck %s --check-prefix REPORT < %t.json

Not given, it is a parameter as before; one number stands for three equal ones.
RUN: anysl-link %t.stc.bc --width 1 -o %t.so
RUN: anysl-shade %t.so --print Ci --set Cs=1,1,1 | FileCheck %s --check-prefix DEFAULT
RUN: anysl-link %t.stc.bc --width 1 --param tint=0.5 -o %t.so
RUN: anysl-shade %t.so --print Ci --set Cs=1,1,1 --param amount=1 | FileCheck %s --check-prefix SPLAT

A decided branch leaves nothing of its other side.
RUN: anysl-link %t.stc.bc --width 1 --param tinted.reflection=0 -o %t.ll
RUN: not grep packet_trace %t.ll
RUN: anysl-link %t.stc.bc --width 1 -o %t.ll
RUN: grep -q packet_trace %t.ll

0.25 of the way from white to (1, 0.5, 0):
VALUE: 1 0.875 0.75
INFO: amount = 0.25
INFO: tint = (1, 0.5, 0)
REPORT: "fixedParams": [
REPORT-NEXT: "amount",
REPORT-NEXT: "tint"
DEFAULT: 0.5 0.5 1
SPLAT: 0.5 0.5 0.5
*/

surface tinted(float amount = 0.5, reflection = 0; color tint = color(0, 0, 1); string space = "rgb") {
  Ci = mix(Cs, tint, amount);
  if (reflection > 0)
    Ci += reflection * trace(P, reflect(I, N));
  Oi = 1;
}
