// RUN: rslc -verify -fsyntax-only %s

#include                   // expected-error {{#include needs "FILE" or <FILE>}}
#defin X                   // expected-error {{unknown directive '#defin'; did you mean 'define'?}}
#define                    // expected-error {{a macro needs a name}}
#define F(a, b) a + b      // expected-note {{macro 'F' is defined here}}
#define G(a                // expected-error {{expected ',' or ')' between a macro's parameters}}
#define TWICE 1            // expected-note {{previously defined here}}
#define TWICE 2            // expected-warning {{macro 'TWICE' redefined}}
#define TWICE 2
#error stop here           // expected-error {{#error stop here}}
#warning careful           // expected-warning {{#warning careful}}
#else                      // expected-error {{'#else' without an #if}}
#endif                     // expected-error {{#endif without an #if}}
#line none                 // expected-error {{#line needs a line number}}
#if 1 +                    // expected-error {{a condition ends too early}}
#endif
#if 1 / 0                  // expected-error {{division by zero in a condition}}
#endif
#if (1                     // expected-error {{'(' without ')' in a condition}}
#endif
#if                        // expected-error {{#if without a condition}}
#endif

surface s() {
  Ci = F(1);               // expected-error {{macro 'F' takes 2 arguments, not 1}} expected-error {{expected an expression}}
}
#ifdef OPEN                // expected-error {{conditional without an #endif}}
