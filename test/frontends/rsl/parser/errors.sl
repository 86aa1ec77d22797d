// Several errors in one run: after each the parser goes on behind the statement.
// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

surfac wrong() { Ci = 1; }        // expected-error {{unknown kind of shader 'surfac'; did you mean 'surface'?}}

surface s(float a = 1 b = 2) {    // expected-error {{expected ';', ',' or ')' after a parameter, not a name}}
}

surface t() {
  Ci = 1 +;                       // expected-error {{expected an expression, not ';'}}
  Ci = (1, 2;                     // expected-error {{expected ')' after an expression}} expected-note {{to match this '('}}
  float x = 1                     // expected-error {{expected ';' after a declaration}}
  x++;                            // expected-error {{RSL has no '++'; write '+= 1'}}
  --x;                            // expected-error {{RSL has no '--'; write '-= 1'}}
  ++;                             // expected-error {{RSL has no '++'; write '+= 1'}} expected-error {{expected an expression, not ';'}}
  Ci = mix(Cs, (1, 1, 1), 0.5;    // expected-error {{expected ')' after arguments}} expected-note {{to match this '('}}
  x = x % 2;                      // expected-error {{RSL has no '%'; use mod(a, b)}}
  if x > 1) Ci = 1;               // expected-error {{expected '(' after 'if'}}
  while (x > 1 Ci = 1;            // expected-error {{expected ')' after a condition}} expected-note {{to match this '('}}
  for (x = 0; x < 1) Ci = 1;      // expected-error {{expected ';' after the condition of a 'for'}}
  break 1 2;                      // expected-error {{expected ';' after 'break'}}
  else Ci = 1;                    // expected-error {{'else' without an 'if'}}
  float float = 1;                // expected-error {{two types in one declaration}} expected-error {{expected a name in a declaration, not '='}}
  float while = 1;                // expected-error {{'while' is a reserved word and cannot be a name}}
  output float o;                 // expected-error {{only parameters can be 'output'}}
  void v;                         // expected-error {{a variable cannot be 'void'}}
  Ci = color(1, 2, 3) + return;   // expected-error {{expected an expression, not the reserved word 'return'}}
  Ci = a[1;                       // expected-error {{expected ']' after an index}} expected-note {{to match this '['}}
  Ci = x ? 1;                     // expected-error {{expected ':' in '?:'}}
  uniform = 2;                    // expected-error {{a declaration needs a type}}
}

float outside = 1;                // expected-error {{variables cannot be declared outside of shaders and functions}}

42;                               // expected-error {{expected a shader or a function, not a number}}

surface u() {                     // expected-note {{to match this '{'}}
  Ci = 1;                         // expected-error {{expected '}' at the end of a block}}
