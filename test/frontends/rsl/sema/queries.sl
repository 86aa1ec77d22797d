// Questions to the renderer, and their messages.
// RUN: rslc -verify -fsyntax-only -ferror-limit=0 %s

surface queries(uniform float u = 1; uniform string file = "wood.tex"; float fixed[2] = {0, 0};) {
  uniform float flag = 0;
  float x = 0, list[3];
  uniform string type;
  matrix m;
  x = attribute("user:id", x) + option("Format", list) + rendererinfo("renderer", type);
  x = surface("Kd", u) + displacement("amount", x) + incident("a", m) + opposite("a", Ci) + atmosphere("a", N);
  u = rayinfo("type", type);
  rayinfo("origin", P[1]);
  attribute("user:id", list[2]);
  textureinfo(file, "resolution", fixed);
  float growing[];
  attribute("user:list", growing);
  textureinfo("resolution", fixed);            // expected-error {{'textureinfo' takes a file, a name and a variable}}
  x = option("Format");                        // expected-error {{'option' takes a name and a variable}}
  x = option("Format", 1);                     // expected-error {{output argument 2 of 'option' must be a variable}}
  x = option(1, x);                            // expected-error {{argument 1 of 'option': a value of type 'float' is no 'string'}}
  attribute("user:id", du);                    // expected-warning {{'du' is read-only}}
  string varied = s > 0.5 ? "a" : "b";
  attribute(varied, flag);                     // expected-error {{a varying value cannot be assigned to uniform 'flag'}} expected-note@5 {{declared here}}
  type = shadername("surface");
  illuminance(P)
    type = shadername("lightsource");
  type = shadername("lightsource");            // expected-warning {{outside of 'illuminance' no light answers 'shadername'}}
  type = shadername("imager");                 // expected-error {{'shadername' takes no argument, or one of "surface", "displacement"}}
  type = shadername(type);                     // expected-error {{'shadername' takes no argument, or one of}}
  x = raylevel() + depth(P);
  m = mtransform("shader", m);
  m = mtransform("shader", "world", 1);
  m = mtransform(m, m);
  m = mtransform(P, m);                        // expected-error {{no function 'mtransform' takes (point, matrix)}} expected-note 2 {{candidate: matrix mtransform}}
}

// Names of built-ins that are the shader's own.
float attribute(string a; float b) { return b; }
surface own(float option = 1) { Ci = attribute("x", option); }

// Texts that come through a function are commonly the same everywhere.
float widthOf(string file) { uniform float size[2] = {0, 0}; textureinfo(file, "resolution", size); return size[0]; }
surface wide(string file = "") { Ci = widthOf(file); }
