// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

struct Pair { float x = 1; }

surface coshaders(shader layer = null; shader layers[] = {}; uniform string names[2] = {"a", "b"}) {
  shader s1 = "layer";              // expected-error {{initialising 's1': a value of type 'string' is no 'shader'}}
  shader s2 = 1;                    // expected-error {{initialising 's2': a value of type 'float' is no 'shader'}}
  string text = layer;              // expected-error {{initialising 'text': a value of type 'shader' is no 'string'}}
  shader s3 = getshader(1);         // expected-error {{argument 1 of 'getshader': a value of type 'float' is no 'string'}}
  shader s4 = getshader();          // expected-error {{'getshader' takes the name of a shader}}
  shader s5 = getshaders();         // expected-error {{initialising 's5': a value of type 'shader[]' is no 'shader'}}
  shader all[] = getshaders("category");    // expected-error {{'getshaders' takes nothing, or "category" and its name}}
  shader lights[] = getlights(), keys[] = getlights("category", "key");
  lights = getlights("key");        // expected-error {{'getlights' takes nothing, or "category" and its name}}
  if (layer == "a") Ci = 1;         // expected-error {{'==' does not compare 'shader' and 'string'}}
  if (layer < null) Ci = 1;         // expected-error {{'<' does not compare 'shader' and 'shader'}}
  if (layer) Ci = 1;                // expected-error {{a condition must be a comparison or a float, not 'shader'}}
  Ci = layer + 1;                   // expected-error {{'+' does not take 'shader' and 'float'}}
  layer->gain = 2;                  // expected-error {{'=' needs a variable to its left}}
  matrix m;
  Ci = layer->tint(unknown);        // expected-error {{unknown variable 'unknown'}}
  float f = getvar(layer, "gain");  // expected-error {{'getvar' takes a shader, a name and a variable}}
  f = getvar(layer, "gain", 1);     // expected-error {{output argument 3 of 'getvar' must be a variable}}
  f = getvar("layer", "gain", f);   // expected-error {{argument 1 of 'getvar': a value of type 'string' is no 'shader'}}
  // What is allowed.
  shader next = f > 0 ? layer : null;
  shader some[2];
  some[1] = layers[0];
  if (next != some[1] && layers[0] == null) Ci = color layer->tint(f, P, m) * layer->gain;
  layer->initialise();
  Ci = layer->tint(names[0]) + layer->tint(names, m, m, some);
  f = getvar(layer, "name", text) + getvar(layer, text, names) + getvar(layer, "all", layers);
  if (layer->kind == "a") Ci = 1;
  text = layer->named(1);
}
shader lost(float Kd = 1) { float x = Kd; } // expected-warning {{function 'lost' may end without returning a value; it is then 0}} expected-note {{declared here}} expected-note {{this is a function that gives a handle; a shader is declared by its kind: surface, displacement, light, volume or imager}}
