// Built-ins that are written in RSL are suggested, explain themselves, and give way to a file's own functions.
// RUN: rslc -verify -fsyntax-only %s
// RUN: not rslc %s -o %t.bc 2>&1 | FileCheck %s
float fulltrace(point a, b) { return distance(a, b); }
surface rays() {
  Ci = fulltrace(P, P + I);
  Oi = rayhitest(P, I);          // expected-error {{unknown function 'rayhitest'; did you mean 'rayhittest'?}}
  Oi = rayhittest(P, I, P, 1);   // expected-error {{no function 'rayhittest' takes (point, vector, point, float)}}
  // CHECK: <built-in>:{{.*}}: note: candidate: float rayhittest(point, vector, output point, output normal), whose argument 4 is no float
}
