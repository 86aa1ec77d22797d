// Texts and arrays go to other shaders' methods and come back, and getvar fills arrays of any length. s is 0, 0.5, 1.
// RUN: rslc %S/Inputs/writer.sl -o %t.writer.bc && anysl-link %t.writer.bc -o %t.writer.so --width 1
// RUN: rslc %s -o %t.bc -Werror && anysl-link %t.bc -o %t.so --width 1,8
// DEFINE: %{shade} = anysl-shade %t.so --grid 3x1 --coshader w=%t.writer.so:name=pen:tags=one,two,three \
// DEFINE:   --print a --print b --print c --print d --print e
// RUN: %{shade} --width 1 > %t.1
// RUN: %{shade} --width 8 > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8
// RUN: anysl-info %t.writer.bc | FileCheck %s --check-prefix=INFO

surface texts(output varying float a = 0, b = 0, d = 0, e = 0; output varying color c = 0;) {
  shader w = getshader("w");
  string text = w->greet(s > 0 ? "you" : "all", 2 * s);
  float here[3] = {1, 2, 3}, there[3];
  there[0] = s;
  there[2] = 10;
  a = w->dot(here, there);                              // s + 30
  float list[];
  resize(list, 1 + 2 * s);
  list[0] = 5;
  b = w->total(list);                                   // 5
  string words[2] = {"x", "y"};
  words[0] = format("%g", s);
  w->grow(list, words);                                 // 1, 2 or 3 elements, and one that is ten times that
  b += 100 * arraylength(list) + 10 * list[2 * s + 1];
  text = concat(text, " ", words[1]);
  color tints[] = {(1, 0, 0), (0, 1, 0)};
  if (s > 0)
    push(tints, color(s));
  c = w->mean(tints);
  // Parameters: text, arrays, and arrays whose length is what there is.
  string name = "", tags[], tag[2] = {"-", "-"};
  color both[2];
  float weights[3], some[], missing[];
  d = getvar(w, "name", name) + 10 * getvar(w, "weights", weights) + 100 * getvar(w, "tints", both) +
      1000 * getvar(w, "weights", some) + 10000 * getvar(w, "tags", tags) + getvar(w, "missing", missing) +
      getvar(w, "tags", tag) + getvar(w, name, weights);
  e = weights[2] + 10 * comp(both[1], 2) + 100 * arraylength(some) + 1000 * arraylength(tags) + arraylength(missing) +
      10000 * some[1];
  if (tags[2] == "three" && name == "pen" && tag[0] == "-" && w->name == "pen")
    e += 0.5;
  if (text == (s == 0 ? "pen to all 0 0+" : s == 0.5 ? "pen to you 1 0.5+" : "pen to you 2 1+"))
    e += 0.25;
}

// CHECK:      0 0  a 30 b 305 c 0.5 0.5 0 d 11111 e 23334.75
// CHECK-NEXT: 1 0  a 30.5 b 505 c 0.5 0.5 0.16666{{[0-9]*}} d 11111 e 23334.75
// CHECK-NEXT: 2 0  a 31 b 705 c 0.66666{{[0-9]*}} 0.66666{{[0-9]*}} 0.33333{{[0-9]*}} d 11111 e 23334.75
// INFO: method writer.greet(sf)s
// INFO: method writer.dot(f3f3)f
// INFO: method writer.grow(f*64s2)v
// INFO: method writer.mean(t*64)t
