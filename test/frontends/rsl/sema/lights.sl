// The arguments of illuminance, illuminate and solar, and questions to lights.
// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

surface lit(string which = "key"; uniform float u = 0) {
  float x = 0, list[2] = {1, 2};
  float grown[];
  vector from = 0;
  lightsource("from", from);            // expected-warning {{outside of 'illuminance' there is no light to ask; it gives 0}}
  illuminance(which, P, N, PI / 2, "lightcache", "reuse", "light:from", from, "send:light:u", 2, "send:light:names", which)
    Ci += Cl * Ol;
  illuminance("-key", P, "light:x", x) {
    lightsource("u", u);
    lightsource("list", list);
    lightsource("list", grown);         // expected-error {{output argument 2 of 'lightsource' needs an array of constant length}}
    lightsource("one", 1);              // expected-error {{output argument 2 of 'lightsource' must be a variable}}
    x = lightsource("one");             // expected-error {{'lightsource' takes a name and a variable}}
  }
  illuminance(P, N);                    // expected-error {{'illuminance' takes a position and, optionally, an axis and an angle}}
  illuminance(P, N, 1, 2);              // expected-error {{'illuminance' takes no more arguments but with a name}}
  illuminance(P, N, 1, "light:x");      // expected-error {{'light:x' lacks its value}}
  illuminance(P, N, 1, "light:x", 2);   // expected-error {{'light:x' must be a variable}}
  illuminance(P, N, 1, which, x);       // expected-error {{the name of an argument must be constant text}}
  illuminance(P, N, 1, "lightcach", "reuse"); // expected-error {{'illuminance' has no argument 'lightcach'; did you mean 'lightcache'?}}
  illuminance(P, N, 1, "send:light:x", s > 0.5) Ci += 1; // expected-error {{cannot be sent to a light}}
  illuminance("key");                   // expected-error {{'illuminance' takes a position}}
  Oi = Ol;                              // expected-error {{'Ol' exists only inside of 'illuminance'}}
}

light lamp(point from = 0) {
  illuminate(from, vector (0, 0, 1));         // expected-error {{'illuminate' takes a position and, optionally, an axis and an angle}}
  illuminate(from, vector (0, 0, 1), 1, "x"); // expected-error {{'illuminate' takes no more arguments}}
  solar(vector (0, 0, 1));                    // expected-error {{'solar' takes an axis and an angle, or nothing}}
  illuminate(from)
    Cl = Ol;
}
