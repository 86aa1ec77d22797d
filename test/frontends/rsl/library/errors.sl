// RUN: rslc --library -verify -o %t.bc %s

float length(color c) { return 1; }   // expected-error {{no built-in 'length' has this signature}}
float abs(float x) { return x; }      // expected-note {{first defined here}}
float abs(float y) { return y; }      // expected-warning {{redefinition of function 'abs'; this one counts from here on}} expected-error {{operator 'abs' is defined twice}} expected-note@-1 {{previously defined here}}
surface s() { Ci = 1; }               // expected-error {{a library contains functions only}}
// expected-note@* {{candidate: float length(vector)}}
