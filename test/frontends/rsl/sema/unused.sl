// -Wall, and one warning at a time.
// RUN: rslc -verify -Wall -fsyntax-only %s
// RUN: rslc -fsyntax-only %s 2>&1 | FileCheck %s --allow-empty --check-prefix=NONE
// RUN: not rslc -Wunused-variable -Werror -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: rslc -Wall -w -fsyntax-only %s 2>&1 | FileCheck %s --allow-empty --check-prefix=NONE

// NONE-NOT: warning
// CHECK: error: unused variable 'a' [-Werror,-Wunused-variable]
// CHECK-NOT: set but never read
float unused(float x) { return x; }      // expected-warning {{unused function 'unused' [-Wunused-function]}}

surface warnings() {
  float a = 1;                           // expected-warning {{unused variable 'a' [-Wunused-variable]}}
  float b;                               // expected-warning {{variable 'b' is set but never read [-Wunused-but-set-variable]}}
  float c = 1;                           // expected-note {{the hidden variable}}
  b = c;
  c + 1;                                 // expected-warning {{the value of this expression is not used [-Wunused-value]}}
  { float c = 2; Ci = c; }               // expected-warning {{'c' hides another variable of this name [-Wshadow]}}
  uniform float n = 0;
  if (s > 0.5) {                         // expected-note {{the condition}}
    uniform float inside = 1;
    inside += 1;
    n = inside;                          // expected-warning {{uniform 'n' is assigned where a varying condition decides [-Wvarying-branch]}}
  }
  Ci += n;
  float helper(float x) { return x; }    // expected-warning {{unused function 'helper' [-Wunused-function]}}
  float called(float x) { return x; }
  Ci *= called(s);
  float kr, kt;                          // expected-warning {{variable 'kr' is set but never read}} expected-warning {{variable 'kt' is set but never read}}
  fresnel(I, N, 1, kr, kt);
}
