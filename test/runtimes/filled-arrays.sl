// Questions fill arrays of any length: as many elements as there are, or as there is room for; without an answer they stay.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 9x2 --attribute user:weights=1,2,3,4 --attribute user:tints=1,2,3,4,5,6 --attribute user:names=ash,elm,oak
// ARGS: --attribute user:places=1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16 --query surface:list=5,6,7 --query textureinfo:wood.tex:resolution=64,32
// EXPECT lengths: 4 2 3 1 3 2 2 4 0
// EXPECT values: 10 21 16 18 96 2 1 4
// EXPECT known: 7 2
float sum(float list[]) {
  float total = 0;
  uniform float i;
  for (i = 0; i < arraylength(list); i += 1)
    total += list[i];
  return total;
}

float weightsOf(output float list[]) { return attribute("user:weights", list); }

surface filled(string file = "wood.tex"; output varying float lengths[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0}, known[2] = {0, 0};
               output varying float values[8] = {0, 0, 0, 0, 0, 0, 0, 0};) {
  float weights[], list[], resolution[], kept[] = {1, 1}, few[2], again[];
  color tints[];
  string names[];
  matrix places[];
  known[0] = attribute("user:weights", weights) + attribute("user:tints", tints) + attribute("user:names", names) +
             attribute("user:places", places) + surface("list", list) + textureinfo(file, "resolution", resolution) +
             weightsOf(again);
  known[1] = 2 + attribute("user:missing", kept) + attribute("user:weights", few) + attribute("user:names", kept);
  lengths[0] = arraylength(weights);
  lengths[1] = arraylength(tints);
  lengths[2] = arraylength(names);
  lengths[3] = arraylength(places);
  lengths[4] = arraylength(list);
  lengths[5] = arraylength(resolution);
  lengths[6] = arraylength(kept);
  lengths[7] = arraylength(again);
  color all = tints[0] + tints[1];
  values[0] = sum(weights);
  values[1] = comp(all, 0) + comp(all, 1) + comp(all, 2);
  values[2] = comp(places[0], 3, 3);
  values[3] = sum(list);
  values[4] = sum(resolution);
  values[5] = sum(kept);
  values[6] = names[0] == "ash" && names[2] == "oak" ? 1 : 0;
  values[7] = again[3];
}
