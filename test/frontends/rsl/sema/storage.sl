// Uniform values become varying, not the other way round.
// RUN: rslc -verify -fsyntax-only %s

float mixed(float x) { return x * 2; }
float place() { extern point P; return xcomp(P); }
uniform float fixed(uniform float x) { return x; }

surface storage(float a = 1; varying float b = 2;
                float c = s;               // expected-error {{initialising 'c' of uniform type: the value is varying}}
                varying float d = s; float e = a * 2) {
  uniform float u1 = a;
  uniform float u2 = b;                    // expected-error {{initialising 'u2' of uniform type: the value is varying}}
  uniform float u3 = mixed(a);
  uniform float u4 = mixed(b);             // expected-error {{the value is varying}}
  uniform float u5 = place();              // expected-error {{the value is varying}}
  uniform float u6 = fixed(s);             // expected-error {{argument 1 of 'fixed' is uniform: the value is varying}}
  uniform float u7 = random();
  uniform float list[2];                   // expected-note {{declared here}}
  float v = u1 + s;
  u1 = v;                                  // expected-error {{a varying value cannot be assigned to uniform 'u1'}} expected-note@-9 {{declared here}}
  a = v;                                   // expected-error {{a varying value cannot be assigned to uniform 'a'}} expected-note@-13 {{parameters of shaders are uniform unless declared 'varying'}}
  u1 += s;                                 // expected-error {{a varying value cannot be assigned to uniform 'u1'}} expected-note@-11 {{declared here}}
  list[s] = 1;                             // expected-error {{a varying value cannot be assigned to uniform 'list'}}
  u1 = u2 + a;
  float kr, kt;
  uniform float ur;                        // expected-note {{declared here}}
  fresnel(I, N, 1.5, kr, kt);
  fresnel(I, N, 1.5, ur, kt);              // expected-error {{a varying value cannot be assigned to uniform 'ur'}}
}
