// Arrays as output parameters, with and without a length; an element and a component as output arguments.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 2x1 --width 1 --print a --print b --print c > %t.1
// RUN: anysl-shade %t.so --grid 2x1 --width 8 --print a --print b --print c > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8

float fill(output float list[]; float by) {
  uniform float i;
  for (i = 0; i < arraylength(list); i += 1)
    list[i] += by * i;
  return arraylength(list);
}
void move(output point places[2]) { places[1] = places[0] + vector(1, 2, 3); }
float bump(output float x) { x += 1; return x; }

surface arrayarguments(output varying float a = 0, b = 0, c = 0) {
  float four[4] = {1, 1, 1, 1}, two[2];
  a = fill(four, s + 1) * 100 + fill(two, 5) * 10 + four[3] + two[1];   // 4, 2, 1 + 3 (s + 1), 5
  point places[2];
  places[0] = (s, 0, 0);
  move(places);
  b = places[1][0] * 100 + places[1][1] * 10 + zcomp(places[1]);
  c = bump(four[2]) * 10 + four[2] + bump(places[0][1]) * 1000 + ycomp(places[0]) * 10000;  // four[2] was 1 + 2 (s + 1)
}

// CHECK:      0 0  a 429 b 123 c 11044
// CHECK-NEXT: 1 0  a 432 b 223 c 11066
