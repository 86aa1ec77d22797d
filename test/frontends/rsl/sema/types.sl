// Conversions that there are not.
// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

surface types(string name = "x"; float f = Cs) {  // expected-error {{initialising 'f': a value of type 'color' is no 'float'}} expected-note {{comp(…, 0) takes one component}}
  float x = name;                     // expected-error {{a value of type 'string' is no 'float'}}
  float y = Cs;                       // expected-error {{a value of type 'color' is no 'float'}} expected-note {{comp}}
  string s = 1;                       // expected-error {{a value of type 'float' is no 'string'}}
  matrix m = Cs;                      // expected-error {{a value of type 'color' is no 'matrix'}}
  Ci = name + 1;                      // expected-error {{'+' does not take 'string' and 'float'}}
  Ci = m * Cs;                        // expected-error {{'*' does not take 'matrix' and 'color'}}
  if (Cs) Ci = 1;                     // expected-error {{a condition must be a comparison or a float, not 'color'}}
  if (Cs < 1) Ci = 1;                 // expected-error {{'<' does not compare 'color' and 'float'}}
  if (name == 1) Ci = 1;              // expected-error {{'==' does not compare 'string' and 'float'}}
  float two[2], three[3];
  if (two == three) Ci = 1;           // expected-error {{'==' does not compare 'float[2]' and 'float[3]'}}
  if (two < two) Ci = 1;              // expected-error {{'<' does not compare 'float[2]' and 'float[2]'}}
  Ci = -name;                         // expected-error {{a value of type 'string' cannot be negated}}
  Ci = f > 0 ? name : 1;              // expected-error {{the two values of '?:' are of types 'string' and 'float'}}
  Ci = (1, 2);                        // expected-error {{a triple has 3 values and a matrix 16, not 2}}
  Ci = f[0];                          // expected-error {{a value of type 'float' has no elements}}
  Ci = float Cs;                      // expected-error {{a value of type 'color' cannot be converted to 'float'}}
  f = float "shader" 1;               // expected-error {{a 'float' is in no coordinate system}}
  f = f . P;                          // expected-error {{the operand of '.' must be a vector, not 'float'}}
  Ci = N . Ng ^ N;                    // expected-error {{the operand of '^' must be a vector, not 'float'}}
  Cs.g = P.z;                         // expected-error {{RSL has no '.g'; write [1]}} expected-error {{RSL has no '.z'; write [2]}}
  P[3] = Cs[-1];                      // expected-error {{a 'point' has the components 0, 1 and 2}} expected-error {{a 'color' has the components 0, 1 and 2}}
  N = (normal) P;                     // expected-error {{a conversion is written 'normal x', without brackets around the type}}
  Ci = color "HSV" (0, 0, 1);         // expected-warning {{unknown colour space "HSV"; it counts as "rgb"; did you mean 'hsv'?}}
  Ci = ctransform("rgb", "wide", Cs); // expected-warning {{unknown colour space "wide"; it counts as "rgb"}}
  Ci = ctransform("xyY", Cs) + color "hsl" P + ctransform(name, Cs);
  fresnel(P, N, 1.5, x, 1);           // expected-error {{output argument 5 of 'fresnel' must be a variable}}
  1 = 2;                              // expected-error {{'=' needs a variable to its left}}
  PI = 3;                             // expected-error {{'=' needs a variable to its left}}
  Ng = N;                             // expected-warning {{'Ng' is read-only; the assignment changes the shader's own copy}}
  // What is allowed.
  Ci = 1; Ci = P; N = Cs; P = N; x = (Cs == Os); m = 2; m = m * 2 / m; Ci = 2 / Cs; Ci /= 2; N += 1;
}

float twice(float x) { return 2 * x; }          // expected-note 2 {{candidate: float twice(float)}}
void nothing() { return 1; }                    // expected-error {{function 'nothing' returns no value}} expected-note {{declared here}}
float something() { return; }                   // expected-error {{function 'something' must return a value of type 'float'}} expected-note {{declared here}}
float some(float x) { if (x > 0) return 1; }    // expected-warning {{function 'some' may end without returning a value}} expected-note {{declared here}}
float assigns(float x) { x = 1; return x; }     // expected-warning {{parameter 'x' is not 'output'}} expected-note {{declared here}}
float recursive(float x) { return recursive(x - 1); } // expected-error {{function 'recursive' calls itself}} expected-note {{declared here}}
float defaulted(float x = 1, y) { return x; }   // expected-error {{parameter 'x' cannot have a default: one behind it has none}}
float[3] listed(float x) { float a[3]; return a; }
float[2] shorter() { return listed(1); } // expected-error {{returning from 'shorter': a value of type 'float[3]' is no 'float[2]'}}
float[] single() { return 1; }           // expected-error {{returning from 'single': a value of type 'float' is no 'float[]'}}
float[2] many() { return {1, 2, 3}; }    // expected-error {{3 values for an array of 2}}
float[0.5] half() { float a[]; return a; } // expected-error {{the length of an array must be an integer from 1 to}}
uniform float[] same(varying float x) { return {1, x}; } // expected-error {{returning from uniform function 'same': the value is varying}}
void[] none() { return 1; }               // expected-error {{there are no arrays of 'void'}}

surface calls() {
  Ci = twice("a");                    // expected-error {{no function 'twice' takes (string)}}
  Ci = twice(1, 2);                   // expected-error {{no function 'twice' takes (float, float)}}
  Ci = nothing() + 1;                 // expected-error {{'+' does not take 'void' and 'float'}}
  Ci = smoothstep(0, 1);              // expected-error {{no function 'smoothstep' takes (float, float)}} expected-note@* {{candidate: float smoothstep(float, float, float)}}
  Ci = smoothstep(0, undefined, 1);   // expected-error {{unknown variable 'undefined'}}
  break;                              // expected-error {{'break' outside of a loop}}
  while (1) { while (1) { break 2; continue 3; } } // expected-error {{'continue 3' inside of only 2 loops}}
  return 1;                           // expected-error {{a shader returns no value}}
  illuminate(P) { Ci = 1; }           // expected-error {{'illuminate' belongs in a light shader, not in a surface}}
  illuminance(P, N) { Ci = Cl; }      // expected-error {{'illuminance' takes a position and, optionally, an axis and an angle}}
}

light l() {
  Ci = 1;                             // expected-error {{a light shader has no 'Ci'}}
}
displacement lit() {
  illuminance (P) Oi = 1;             // expected-error {{a displacement shader has no 'Oi'}}
}
