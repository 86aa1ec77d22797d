// The renderer's answers, of every type, arrays and elements included: a variable is set where there is one that it
// can take, and left alone otherwise, at every width and in branches that only some points take.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 9x2 --attribute user:id=3 --attribute user:tint=0.25,0.5,1 --attribute user:weights=1,2,3,4
// ARGS: --attribute user:place=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16 --attribute user:name=oak --attribute user:names=ash,elm
// ARGS: --option user:quality=0.5 --query surface:Kd=0.75 --query textureinfo:wood.tex:resolution=64,32 --query surface:shadername=matte
// EXPECT numbers: 3 1 3 3 9 0 9 0 0.75
// EXPECT colors: 0.25 0.5 1 3 3 3 9 9 9
// EXPECT vectors: 0.25 0.5 1 8 0.5 1
// EXPECT weights: 1 2 3 4 9 9 9 9 64 32
// EXPECT place: 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16
// EXPECT texts: 1 1 1 1 1 1
// EXPECT branches: 1 1
float attributeNamed(string name) {
  float value = 0;
  attribute(name, value);
  return value;
}

surface queries(string file = "wood.tex"; float early = attributeNamed("user:id") * 2;
                output varying float numbers[9] = {9, 9, 9, 9, 9, 9, 9, 9, 9}, branches[2] = {0, 0}, texts[6] = {0, 0, 0, 0, 0, 0};
                output varying color colors[3] = {9, 9, 9}; output varying vector vectors[2] = {8, 8};
                output varying float weights[10] = {9, 9, 9, 9, 9, 9, 9, 9, 9, 9}; output varying matrix place = 0;) {
  numbers[4] = 9;
  numbers[6] = 9;
  colors[2] = 9;
  numbers[1] = attribute("user:id", numbers[0]);
  uniform float id = 0;
  attribute("user:id", id);
  numbers[2] = id;
  numbers[3] = id;
  numbers[5] = attribute("user:nothing", numbers[4]);
  numbers[7] = attribute("user:tint", numbers[6]);
  surface("Kd", numbers[8]);

  attribute("user:tint", colors[0]);
  attribute("user:id", colors[1]);
  attribute("user:weights", colors[2]);
  attribute("user:tint", vectors[0]);
  vector v = 8;
  attribute("user:tint", v);
  v[0] = 8;
  attribute("user:absent", v[0]);
  vectors[1] = v;

  float four[4], size[2], two[2] = {9, 9}, i;
  float n = attribute("user:weights", four);
  for (i = 0; i < 4; i += 1)
    weights[i] = four[i];
  n += attribute("user:weights", two);
  weights[4] = two[0];
  weights[5] = two[1];
  attribute("user:id", two);
  weights[6] = two[0];
  weights[7] = two[1];
  textureinfo(file, "resolution", size);
  weights[8] = size[0];
  weights[9] = size[1];
  attribute("user:place", place);

  string name = "none", names[2], kind = "user:name";
  texts[0] = attribute("user:name", name) == 1 && name == "oak";
  attribute("user:names", names);
  texts[1] = names[0] == "ash" && names[1] == "elm";
  texts[2] = attribute("user:tint", name) == 0 || name == "0.25";
  attribute(kind, kind);
  texts[3] = kind == "oak";
  texts[4] = shadername("surface") == "matte" && shadername("atmosphere") == "";
  texts[5] = rendererinfo("renderer", name) == 1 && name == "anysl-shade" && early == 6;

  // Different from point to point.
  float column = floor(s * 8 + 0.5), got = 5;
  string asked = column > 4 ? "user:id" : "user:none";
  float known = attribute(asked, got);
  branches[0] = column > 4 ? known == 1 && got == 3 : known == 0 && got == 5;
  got = 5;
  if (column == 2 || column == 6)
    surface("Kd", got);
  else if (column == 3)
    attribute("user:id", got);
  branches[1] = got == (column == 2 || column == 6 ? 0.75 : column == 3 ? 3 : 5);
}
