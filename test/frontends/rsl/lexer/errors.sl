// RUN: rslc -verify -fsyntax-only %s

surface bad() {
  Ci = 1 @ 2;      // expected-error {{unexpected character '@'}} expected-error {{expected ';'}}
  // expected-error@+1 {{on its line}}
  string s = "open;
  ;
  Ci = µ + 1;      // expected-error {{unexpected character 'µ'}}
}
/* expected-error {{comment without an end}}
