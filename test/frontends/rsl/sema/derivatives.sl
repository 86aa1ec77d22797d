// Built-ins that ask for derivatives, and what they cannot take.
// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

surface derivatives(uniform float k = 1; string strategy = "shading"; uniform string kernel = "box";) { // expected-note {{declared here}}
  uniform float still = Du(k);
  vector across = Du(P) ^ Dv(N);
  color c = Du(Cs);
  float a = area(P) + area(P, strategy) + area(P, "dicing");
  normal n = calculatenormal(P);
  float w = filterwidth(s) + filterwidth(P) + Deriv(s, t);
  vector d = Deriv(P, t);
  float f = filterstep(0.5, s) + filterstep(0.5, s, t) + filterstep(0.5, s, "width", 2 * k) +
            filterstep(0.5, s, s + du, "filter", "catmull-rom", "width", 2);
  Ci = c * a * w * f + color(n + d + across);

  k = Du(s);                                     // expected-error {{a varying value cannot be assigned to uniform 'k'}}
  a = area(P, 1);                                // expected-error {{no function 'area' takes (point, float)}} expected-note {{candidate: float area(point)}}
  w = Du("s");                                   // expected-error {{no function 'Du' takes (string)}} expected-note 3 {{candidate}}
  f = filterstep(0.5, s, "blur", 1);             // expected-error {{'filterstep' has no argument "blur"}}
  f = filterstep(0.5, s, "widt", 1);             // expected-error {{did you mean 'width'?}}
  f = filterstep(0.5, s, "width");               // expected-error {{argument "width" of 'filterstep' has no value}}
  f = filterstep(0.5, s, "filter", "gausian");   // expected-error {{unknown filter 'gausian'; did you mean 'gaussian'?}}
  f = filterstep(0.5, s, "filter", kernel);      // expected-error {{the filter of 'filterstep' must be constant text}}
  f = filterstep(0.5, s, "width", 1, t, 1);      // expected-error {{here must stand the name of an argument of 'filterstep'}}
  f = filterstep(0.5, Cs, "width", 1);           // expected-error {{'filterstep' takes floats, not a color}}
  f = dsdu;                                      // expected-error {{unknown variable 'dsdu'}}
}

// A function of the user's own goes before.
float filterwidth(string text) { return 1; }
surface own() { Ci = filterwidth("a") + filterwidth(s); }
