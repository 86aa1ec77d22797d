// Unknown names are reported once, with what was probably meant.
// RUN: rslc -verify -fsyntax-only %s
// RUN: not rslc %s -o %t.bc 2>&1 | FileCheck %s

surface names(float roughness = 0.1) {        // expected-note 2 {{'roughness' is declared here}}
  float x = rouhgness;                        // expected-error {{unknown variable 'rouhgness'; did you mean 'roughness'?}}
  x = rouhgness;
  x = Roughness;                              // expected-error {{did you mean 'roughness'?}}
  Ci = noramlize(N);                          // expected-error {{unknown function 'noramlize'; did you mean 'normalize'?}}
  Ci = later(1);                              // expected-error {{unknown function 'later'}}
  Ci = completely_unknown;                    // expected-error {{unknown variable 'completely_unknown'}}
  Ci = completly_unknown;                     // expected-error {{unknown variable 'completly_unknown'}}
  float x = 2;                                // expected-error {{redefinition of 'x'}} expected-note@-7 {{previously declared here}}
  { float x = 3; Ci = x; }
  extern float nowhere;                       // expected-error {{no 'nowhere' outside of this function}}
  Ci = nowhere;
  Ci = Cl;                                    // expected-error {{'Cl' exists only inside of 'illuminance'}}
}

float later(float x) { return x; }            // expected-note {{it is defined later; functions must stand before their use}}
float later(float y) { return y; }            // expected-warning {{redefinition of function 'later'; this one counts from here on}} expected-note@-1 {{previously defined here}}
color later(float y) { return y; }
surface names() {}                            // expected-error {{redefinition of shader 'names'}} expected-note@-18 {{previously defined here}}

// CHECK: names.sl:6:13: error: unknown variable 'rouhgness'; did you mean 'roughness'?
// CHECK-NEXT: {{^}}  float x = rouhgness;
// CHECK-NEXT: {{^}}            ^~~~~~~~~
// CHECK-NEXT: {{^}}            roughness
// CHECK: names.sl:5:21: note: 'roughness' is declared here
// CHECK-NEXT: {{^}}surface names(float roughness = 0.1)
// CHECK-NEXT: {{^}}                    ^~~~~~~~~
// CHECK: unknown variable 'completly_unknown'{{$}}
// CHECK: 10 errors and 1 warning generated.
