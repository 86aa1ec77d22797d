// Arrays whose length changes, from point to point where they are varying. s is 0, 0.5, 1.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 3x1 --width 1 --print a --print b --print c --print d --print e --print f --print g > %t.1
// RUN: anysl-shade %t.so --grid 3x1 --width 8 --print a --print b --print c --print d --print e --print f --print g > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8

float sum(float list[]) {
  float total = 0;
  uniform float i, n = arraylength(list);
  for (i = 0; i < n; i += 1)
    total += list[i];
  return total;
}
void twice(output float list[]; float x) { push(list, x); push(list, x); }
void outer(output float list[]; float x) { twice(list, x); list[0] += 1; }

struct Stack {
  varying float items[];
  void add(float x) { push(items, x); }
  float top() { return items[arraylength(items) - 1]; }
}

surface resizable(output varying float a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0) {
  float list[];
  a = arraylength(list);
  float i;
  for (i = 0; i < 4 * s; i += 1)
    push(list, i + 1);
  a += arraylength(list) * 10 + sum(list) * 100;            // 0, 1+2, 1+2+3+4
  b = pop(list);                                            // 0, 2, 4
  b = b * 10 + arraylength(list);                           // 0, 1, 3
  float copy[] = list, first[] = {7, 8, 9};
  resize(copy, 2.9);
  copy[1] = 5;
  c = arraylength(copy) * 100 + sum(copy);                  // 200 + the first element, if any, + 5
  list = first;
  d = arraylength(list) * 100 + sum(list);
  outer(list, 10);
  e = arraylength(list) * 1000 + sum(list);                 // 7+1 + 8 + 9 + 10 + 10
  // Beyond the capacity nothing happens; under 0 neither.
  float small[];
  resize(small, 3);
  small[2] = 4;
  f = capacity(small);
  resize(small, -1);
  f = f * 10 + arraylength(small);
  resize(small, 2 + s);                                     // 2, 2, 3
  f = f * 100 + arraylength(small) * 10 + (pop(first) == 9);
  float sized[1 + 2 * s];
  g = arraylength(sized);                                   // 1, 2, 3
  Stack stack;
  for (i = 0; i < 3 + s; i += 1)
    stack->add(i * 2);
  color colors[], more[] = {1, (1, 2, 3)};
  push(colors, more[1]);
  push(colors, 5);
  g = g * 1000 + stack->top() * 100 + arraylength(stack->items) * 10 + comp(colors[0], 2) + comp(colors[1], 0);
}

// CHECK:      0 0  a 0 b 0 c 205 d 324 e 5045 f 64021 g 1438
// CHECK-NEXT: 1 0  a 320 b 21 c 206 d 324 e 5045 f 64021 g 2648
// CHECK-NEXT: 2 0  a 1040 b 43 c 206 d 324 e 5045 f 64031 g 3648
