// A misspelt type is one error: the variables are there for what follows.
// RUN: rslc -verify -fsyntax-only %s

surface unknown() {
  colour c = Cs, d;           // expected-error {{unknown type 'colour'; did you mean 'color'?}}
  int i = 3;                  // expected-error {{unknown type 'int'; did you mean 'float'?}}
  banana b[2];                // expected-error {{unknown type 'banana'}}
  vec3 v = N;                 // expected-error {{unknown type 'vec3'; did you mean 'vector'?}}
  bool good = true;           // expected-error {{unknown type 'bool'; did you mean 'float'?}} expected-error {{RSL has no 'true'; write 1}}
  d = c + i;
  Ci = c * d * b[1];
  if (i = 1) Ci = 1;          // expected-warning {{an assignment as a condition; did you mean '=='?}}
  if (s = 1) Ci = 1;          // expected-warning {{an assignment as a condition}}
  E = P;                      // expected-warning {{'E' is read-only}} expected-error {{a varying value cannot be assigned to uniform 'E'}}
}
