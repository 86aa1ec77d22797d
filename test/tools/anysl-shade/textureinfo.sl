// What a texture's file says of itself, and what the command line says instead.
// RUN: oiiotool --pattern constant:color=0.5,0.25,1 64x32 3 -o %t.tif
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 3x1 --width 8 --param file=%t.tif --print size --print found --print other | FileCheck %s
// RUN: anysl-shade %t.so --grid 3x1 --width 1 --param file=%t.tif --print size --print found --print other | FileCheck %s
// CHECK-COUNT-3: size 64 32 found 1 1 1 0 other 9 9 9
// RUN: anysl-shade %t.so --grid 1x1 --param file=%t.tif --query textureinfo:%t.tif:resolution=5,6 --print size | FileCheck %s --check-prefix=GIVEN
// GIVEN: size 5 6
surface facts(uniform string file = ""; output varying float size[2] = {0, 0}, found[4] = {9, 9, 9, 9}, other[3] = {9, 9, 9};) {
  float resolution[2], channels = 0, three[3] = {9, 9, 9}, i;
  string kind = "none";
  found[0] = textureinfo(file, "resolution", resolution);
  found[1] = textureinfo(file, "channels", channels) == 1 && channels == 3;
  found[2] = textureinfo(file, "type", kind) == 1 && kind == "texture";
  // Nobody has three of these.
  found[3] = textureinfo(file, "resolution", three) + textureinfo(file, "moons", channels);
  for (i = 0; i < 3; i += 1)
    other[i] = three[i];
  size[0] = resolution[0];
  size[1] = resolution[1];
}
