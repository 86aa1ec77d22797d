// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

class good(float Kd = 1; uniform string names[2] = {"a", "b"}) {
  float m = Kd;
  color twice(color c) { return 2 * c; }
  public void surface(output color Ci, Oi) { Ci = twice(Cs) * m; }
  public void volume(output color Ci; output color Oi) { Oi = 1; }
}

class wrong(float s1 = s) {      // expected-note {{declared here}} expected-error {{initialising 's1' of uniform type: the value is varying}}
  uniform float u;               // expected-note {{declared here}}
  float v                        // expected-error {{expected ';' after a member}}
  public void surface(output color Ci, Oi, Al) { Ci = 1; }         // expected-error {{method 'surface' must be void surface(output color Ci, output color Oi)}}
  public float displacement(output point P) { return 1; }          // expected-error {{method 'displacement' must be void displacement(output point P, output normal N)}}
  public void light(vector L; output color Cl) { Cl = 1; }         // expected-error {{method 'light' must be void light(output vector L, output color Cl)}}
  public void begin(float x) { u = s; }                            // expected-error {{method 'begin' must be void begin()}} expected-error {{a varying value cannot be assigned to uniform 'u'}}
  void other() { Ng = N; this->missing = 1; this->gone(); }        // expected-warning {{'Ng' is read-only; the assignment changes the shader's own copy}} expected-error {{'wrong' has no member 'missing'}} expected-error {{'wrong' has no method 'gone'}}
  float again(float x) { return this->again(x); }                  // expected-error {{function 'again' calls itself}} expected-note {{declared here}}
}

class nothing() {                // expected-warning {{class 'nothing' has no method that a renderer or another shader can call}}
  void helper() { }
}

surface good() { Ci = 1; }       // expected-error {{redefinition of shader 'good'}} expected-note@-22 {{previously defined here}}
class plain {                    // expected-error {{expected '(' and a class's parameters; there is no inheritance}}
  float x = 1;
}
clas misspelt() { }              // expected-error {{unknown kind of shader 'clas'; did you mean 'class'?}}
class lit() {
  public void surface(output color Ci, Oi) {
    color d = 0;
    Ci = directlighting(this, getlights(), "diffuseresult", d);
    shader s = this;             // expected-error {{unknown variable 'this'}}
  }
}
