// Arguments by name, and gather.
// RUN: rslc -fsyntax-only -verify %s

surface named(string file = "a.tif"; float width = 1) {
  Ci = texture(file, s, t, "blur", 0.1, "uniform float swidth", width, "lerp", 1);
  Ci = texture(file[1], "wdth", 2); // expected-warning {{'texture' has no argument "wdth"; it is ignored; did you mean 'width'?}}
  Ci = texture(file, s, t, "blur"); // expected-error {{argument "blur" of 'texture' has no value}}
  Ci = texture(file, s, t, file, 1); // expected-error {{the name of an argument must be constant text}}
  Ci = texture(file, s, t, "blur", 1, 2, 3); // expected-error {{'texture' expects the name of an argument here}}
  Ci = texture(file, s, t, "blur", "wide"); // expected-error {{argument "blur" of 'texture'}}
  Ci = texture(file, s); // expected-error {{no function 'texture' takes (string, float)}} expected-note {{candidate}} expected-note {{candidate}} expected-note {{candidate}} expected-note {{candidate}} expected-note {{candidate}} expected-note {{candidate}}
  Ci = length(file, "blur", 1); // expected-error {{no function 'length' takes (string, string, float)}} expected-note {{candidate}}
  float f = texture(file) + shadow(file, P, "blur", s) + environment(file, I);
  vector v = vector(f);
  float missing = 0;
  string whole;
  float list[3], grown[];
  gather("illuminance", P, N, 1, 4, "surfce:Cj", missing, // expected-warning {{'gather' does not give "surfce:Cj"; the variable stays as it is}}
         "sampls", 3) // expected-warning {{'gather' has no argument "sampls"; it is ignored}}
    Ci += missing;
  gather("illuminance", P, N, 1, 4, "surface:Kd", missing, "amount", v, "primitive:st", list, "attribute:user:name", whole,
         "bias", 0.1, "hitsides", "front", "raytype", "diffuse", "excludesubset", "a", // expected-warning {{argument "excludesubset" of 'gather' changes nothing: give its sets to "subset", behind a -}}
         "hitmode", "primitive", // expected-warning {{argument "hitmode" of 'gather' changes nothing: surfaces are as opaque as their shaders say}}
         "subset", "a")
    Ci += missing;
  gather("illuminance", P, N, 1, 4, "distributio", missing) Ci += 1; // expected-warning {{'gather' has no argument "distributio"; it is ignored; did you mean 'distribution'?}}
  gather("illuminance", P, N, 1, 4, "surface:list", grown) Ci += 1; // expected-error {{cannot hold "surface:list"}}
  gather("illuminance", P, N, 1) Ci += 1; // expected-error {{'gather' takes a category, a point, a direction, an angle and a number of samples}}
  gather("illuminance", P, N, 1, 4, "surface:Ci", missing) // expected-error {{"surface:Ci" is a color, which a variable of type 'float' cannot hold}}
    Ci += 1;
  gather("illuminance", P, N, 1, 4, "ray:length", 3) Ci += 1; // expected-error {{output "ray:length" of 'gather'}}
  Ci += v[0];
  continue; // expected-error {{'continue' outside of a loop}}
}
