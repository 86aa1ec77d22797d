// Formats and their values, and other built-ins that make text.
// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

surface text(uniform string base = "wood"; uniform string u = "") { // expected-note {{declared here}} expected-note {{declared here}}
  float list[2] = {1, 2};
  string a = format("%f %p %c %m %s %d%%", s, N, Cs, matrix 1, base, 2);
  a = format("%f %c %p", s > 0.5, 1, (1, 2, 3));
  a = format("%p %c", Cs, N);
  printf("%f\n", Cs);          // expected-warning {{'%f' is for a float, not for a color}}
  printf("%5.2s", s);          // expected-warning {{'%5.2s' is for a string, not for a float}}
  printf("%c", base);          // expected-warning {{'%c' is for a color, not for a string}}
  printf("%m", P);             // expected-warning {{'%m' is for a matrix, not for a point}}
  printf("%f %f", s);          // expected-warning {{the format has 2 directives, but there are 1 values}}
  printf("%f", s, t);          // expected-warning {{the format has 1 directives, but there are 2 values}}
  printf("%q%");               // expected-warning {{'%q' is no directive and stays as it is}} expected-warning {{'%' is no directive}}
  printf(base, s);
  printf();                    // expected-error {{'printf' takes a format and values}}
  printf(1);                   // expected-error {{the format of 'printf': a value of type 'float' is no 'string'}}
  printf("%f", list);          // expected-error {{a value of type 'float[2]' cannot be shown}}
  printf("%f", missing);       // expected-error {{unknown variable 'missing'}}
  u = format("%f", s);         // expected-error {{a varying value cannot be assigned to uniform 'u'}}
  u = format("%s.%f", base, list[0] > 2 ? 1 : 2);  // expected-error {{a varying value cannot be assigned to uniform 'u'}}
  u = concat(base, ".tex");
  u = concat("%", 1);          // expected-error {{argument 2 of 'concat': a value of type 'float' is no 'string'}}
  u = concat();                // expected-error {{'concat' takes texts to join}}
  u = shadername();
  float m = match("a*", a);
  m = match("a*");             // expected-error {{no function 'match' takes (string)}} expected-note {{candidate: float match(string, string)}}
  if (format("%f", m) == base) Ci = m;
}

// Names of built-ins that are the shader's own.
float format(float x) { return x; }
surface own() { float concat = 1; Ci = format(concat); }
