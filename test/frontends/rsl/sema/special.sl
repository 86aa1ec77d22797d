// Built-ins with arguments of their own.
// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

surface special(uniform float u = 1) {
  float x = spline("cubic", s, 0, 1, 2, 3);    // expected-error {{unknown basis 'cubic'}}
  x = spline("hermit", s, 0, 1, 2, 3);         // expected-error {{did you mean 'hermite'?}}
  string name = "linear";
  x = spline(name, s, 0, 1, 2, 3);
  u = spline(s > 0.5 ? "linear" : name, 0.5, 0, 1, 2, 3); // expected-error {{a varying value cannot be assigned to uniform 'u'}}
  x = spline(s, 0, 1, 2);                      // expected-error {{'spline' takes a value and at least four knots}}
  x = spline(s, "a", "b", "c", "d");           // expected-error {{the knots of a spline cannot be of type 'string'}}
  float three[3] = {1, 2, 3};
  x = spline(s, three);                        // expected-error {{a spline needs at least four knots}}
  Ci = spline(s, Cs, Os, 1, 0);
  u = spline(s, 0, 1, 2, 3);                   // expected-error {{a varying value cannot be assigned to uniform 'u'}}

  Ci = sqrt("a");                              // expected-error {{no function 'sqrt' takes (string)}}
  x = sqrt(Cs);                                // expected-error {{a value of type 'color' is no 'float'}}
  Ci = pow(Cs, N);                             // expected-error {{no function 'pow' takes (color, normal)}}
  emit(Cs, "raytraceshadows", 1);              // expected-error {{built-in 'emit' is not supported: it needs a renderer that samples area lights by their shaders; set Cl in method light()}}
}

// Names of built-ins that are the shader's own.
float attribute(string a; float b) { return b; }
float printf(float x) { return x; }
surface own(float option = 1) { Ci = attribute("x", printf(option)); }
