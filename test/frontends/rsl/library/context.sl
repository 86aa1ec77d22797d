// An operator without a context cannot ask the renderer for anything.
// RUN: rslc --library -verify -o %t.bc %s

float abs(float x) { return x * xcomp(P); }  // expected-error {{'P' is no operand of operator 'abs'}}
float sqrt(float x) { return comp(transmission(point (0, 0, 0), point (0, 0, 1)), 0); }     // expected-error {{this needs the shading context, which operator 'sqrt' does not have}}
