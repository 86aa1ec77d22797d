// Structures: members, defaults, whole assignments, nesting, arrays, parameters, results, methods. s is 0 and 1.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 2x1 --width 1 --print a --print b --print c --print d --print e --print f --print g > %t.1
// RUN: anysl-shade %t.so --grid 2x1 --width 8 --print a --print b --print c --print d --print e --print f --print g > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8

struct Pair {
  varying float x = 3, y = 4;
};

struct Surf {
  varying color tint = (1, 2, 3);
  float list[3] = {7, 8, 9};
  string name = "plain";
  varying vector dir = vector(0, 0, 1);
  Pair pair;
}

float total(Pair p) { return p->x + p->y; }
void turn(output Pair p; float by) { float keep = p->x; p->x = by * p->y; p->y = keep; }
Pair swapped(Pair p) { Pair q = Pair(p->y, p->x); return q; }

// Methods see the members, and call each other in any order.
struct Counter {
  varying float n = 0;
  float step = 1;
  void add(float times) { n += scaled(times); }
  float scaled(float x) { return x * this->step; }
  void twice() { this->add(1); add(1); }
  float get() { return n; }
}

surface structs(output varying float a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0) {
  Surf one;
  a = one->tint[2] * 1000 + one->list[1] * 100 + one->pair->x * 10 + one.pair.y + (one->name == "plain") * 5000;
  // A whole structure is a value of its own.
  Surf two = one;
  two->pair->x = s;
  two.list[2] = 1;
  two.dir = (1, 2, 3);
  b = one->pair->x * 1000 + two->pair->x * 100 + one->list[2] * 10 + two->list[2];
  // The point is the dot product as well, of members too.
  c = two.dir.two.dir + -two.dir.one.dir * 100;
  Pair p = Pair(1, 2), q = Pair("y", 5);
  turn(p, 10 + s);                          // (20 + 2 s, 1)
  d = total(p) * 100 + total(swapped(q)) + swapped(q)->x;
  p = swapped(swapped(p));
  e = p->x;
  Pair many[3] = {Pair(10, 20), p};
  many[2]->x = 6;
  many[s] = many[2];
  uniform float i;
  for (i = 0; i < 3; i += 1)
    f = f * 100 + many[i]->x + (many[i]).y;
  turn(many[1], 2);
  f = f * 100 + many[1]->x;
  Counter up, other;
  up->step = 3;
  up->add(1 + s);
  up->twice();
  other->add(1);
  g = up->get() * 10 + other->n;
}

// a = 3000 + 800 + 30 + 4 + 5000
// b = 3000 + 100 s + 90 + 1
// c = 14 - 3 * 100
// d = (21 + 2 s) * 100 + 8 + 5
// f: many is {(10,20), (20+2s,1), (6,4)}, and element s is (6,4); then many[1].x = 2 many[1].y
// CHECK:      0 0  a 8834 b 3091 c -286 d 2113 e 20 f 10211002 g 91
// CHECK-NEXT: 1 0  a 8834 b 3191 c -286 d 2313 e 22 f 30101008 g 121
