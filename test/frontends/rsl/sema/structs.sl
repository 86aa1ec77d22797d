// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

struct Pair {               // expected-note 5 {{declared here}}
  float x = 3;              // expected-note {{declared here}}
  varying float y = 4;
  float get() { return x + z; }                   // expected-error {{unknown variable 'z'}}
  void set(float v) { x = v; }                    // expected-error {{a varying value cannot be assigned to uniform 'x'}}
  void loop() { back(); }
  void back() { loop(); }                         // expected-error {{function 'loop' calls itself}} expected-note@-1 {{declared here}}
  float own() { return this->w + this->none(); }  // expected-error {{'Pair' has no member 'w'}} expected-error {{'Pair' has no method 'none'}}
}
struct Outer {
  Pair inner = Pair(1, 2);                        // expected-error {{the default of a structure stands in its own definition}}
  float list[2] = {1, 2};
  banana b;                                       // expected-error {{unknown type 'banana'}}
  float c                                         // expected-error {{expected ';' after a member}}
}
struct Other { float x = 1; }

float first(Pair p) { return p->x; }              // expected-note {{candidate: float first(Pair)}}

surface structs(float f = 1) {
  Pair p, q;
  Other o;
  Ci = p->z;                // expected-error {{'Pair' has no member 'z'}}
  Ci = p.z;                 // expected-error {{'Pair' has no member 'z'}}
  Ci = f->x;                // expected-error {{a value of type 'float' has no members}}
  Ci = f->get();            // expected-error {{a value of type 'float' has no methods}}
  Ci = p->gett();            // expected-error {{'Pair' has no method 'gett'; did you mean 'get'?}}
  Ci = this->x;             // expected-error {{'this' exists only in methods}}
  p = o;                    // expected-error {{assigning to 'p': a value of type 'Other' is no 'Pair'}}
  p = 1;                    // expected-error {{assigning to 'p': a value of type 'float' is no 'Pair'}}
  p->x = s;                 // expected-error {{a varying value cannot be assigned to uniform 'p.x'}} expected-note@-10 {{declared here}}
  p = Pair(1, 2, 3);        // expected-error {{'Pair' has only 2 members}}
  p = Pair(s);              // expected-error {{member 'x' of 'Pair', which is uniform: the value is varying}}
  p = Pair("x", 1, "z", 2); // expected-error {{expected the name of a member of 'Pair'}}
  p = Pair("a");            // expected-error {{member 'x' of 'Pair': a value of type 'string' is no 'float'}}
  p = f > 0 ? p : o;        // expected-error {{the two values of '?:' are of types 'Pair' and 'Other'}}
  Ci = first(o);            // expected-error {{no function 'first' takes (Other)}}
  Ci = p + q;               // expected-error {{'+' does not take 'Pair' and 'Pair'}}
  if (p == q) Ci = 1;       // expected-error {{'==' does not compare 'Pair' and 'Pair'}}
  Outer list[2];            // expected-error {{an array of 'Outer', whose member 'list' is an array itself, is not supported}}
  p-> = 1;                  // expected-error {{expected the name of a member after '->'}}
  uniform Pair u;           // expected-note {{declared here}}
  u->y = s;                 // expected-error {{a varying value cannot be assigned to uniform 'u.y'}}
}
struct Twice { float x = 1; }                     // expected-note {{previously defined here}}
struct Twice { float x = 1; }                     // expected-error {{redefinition of 'Twice'}}
surface bad(Pair p) {       // expected-error {{a shader's parameter cannot be a structure}}
}
