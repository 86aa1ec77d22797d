/* Derivatives of derivatives are exact: where they are read, and only there, numbers carry derivatives of second order.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1,4,8,16 -o %t.so --report %t.json
RUN: FileCheck %s --check-prefix SECOND < %t.json
RUN: anysl-shade %t.so --grid 3x2 --print Ci --print bend --json | FileCheck %s
RUN: anysl-shade %t.so --grid 3x2 --width 8 --print Ci --print bend --json | FileCheck %s
RUN: anysl-link %t.stc.bc --runtime scalar --real double --width 1,4 -o %t.double.so --report %t.double.json
RUN: FileCheck %s --check-prefix DOUBLE < %t.double.json
RUN: anysl-shade %t.double.so --grid 3x2 --print Ci --print bend --json | FileCheck %s

SECOND: "real": "dual2"
DOUBLE: "real": "dual2double"

d2/du dv (s s t) = 2 s, and d2/du2 (s s s) = 6 s.
CHECK: "Ci":{{\[\[}}0,0,0],[1,3,0],[2,6,0],
CHECK-NEXT: [0,0,0],[1,3,0],[2,6,0]]
At the height s s, the unit normal has x = -2 s / (1 + 4 s s)^(1/2), which changes by -2 / (1 + 4 s s)^(3/2).
CHECK-NEXT: "bend":[-2,-0.70710{{[67][0-9]*}},-0.178885{{[0-9]*}},

A real that is asked for by name is taken as it is. What it lacks is 0, with a warning.
RUN: anysl-link %t.stc.bc --real dual --width 1 -o %t.dual.so 2>&1 | FileCheck %s --check-prefix WARN
RUN: anysl-shade %t.dual.so --grid 3x2 --print Ci --json | FileCheck %s --check-prefix ZERO
WARN: second-order.sl:[[#@LINE+13]]:{{[0-9]+}}: warning: the derivative of a derivative is read, which real 'dual' does not carry; it is 0; '--real dual2' has it
ZERO: "Ci":{{\[\[}}0,0,0],[0,0,0]

The width of a filter counts as constant, so filters need no second derivatives.
RUN: rslc -DFILTER %s -o %t.filter.stc.bc
RUN: anysl-link %t.filter.stc.bc --width 1 -o %t.filter.so --report %t.filter.json
RUN: FileCheck %s --check-prefix FIRST < %t.filter.json
FIRST: "real": "dual"
*/
surface curvature(output varying float bend = 0;) {
#ifdef FILTER
  bend = Du(filterstep(0.5, s * s));
#else
  Ci = color(Du(Dv(s * s * t)), Du(Du(s * s * s)), 0);
  point p = P + s * s * normalize(N);
  bend = Du(xcomp(calculatenormal(p)));
#endif
}
