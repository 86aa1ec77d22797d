// Shaders that call each other's methods, each a library of its own. s is 0, 0.5, 1.
// RUN: rslc %S/Inputs/layer.sl -o %t.layer.bc && anysl-link %t.layer.bc -o %t.layer.so --width 1
// RUN: rslc %s -o %t.bc -Werror && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 3x1 --param layers=one,two --coshader one=%t.layer.so --coshader two=%t.layer.so:gain=3:__category=other --width 1 --print Ci --print Oi --print a --print b --print c --print d --print e > %t.1
// RUN: anysl-shade %t.so --grid 3x1 --param layers=one,two --coshader one=%t.layer.so --coshader two=%t.layer.so:gain=3:__category=other --width 8 --print Ci --print Oi --print a --print b --print c --print d --print e > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8
// RUN: anysl-shade %t.so --grid 3x1 --print Ci --print Oi --print a --print b --print c --print d --print e | FileCheck %s --check-prefix=NONE
// RUN: anysl-info %t.layer.bc | FileCheck %s --check-prefix=INFO
// RUN: not anysl-shade %t.so --coshader one=%t.so --coshader one=%t.so 2>&1 | FileCheck %s --check-prefix=TWICE

struct Geometry { varying point where = 0; varying normal dir = 0; float kd = 1; }

class coshaders(shader layers[] = {}, more[] = null; shader absent = null;
                output varying float a = 0, b = 0, c = 0, d = 0, e = 0) {
  shader first;
  public void begin() { first = getshader("one"); }
  public void surface(output color Ci, Oi) {
    Ci = 0;
    uniform float i;
    for (i = 0; i < arraylength(layers); i += 1)
      Ci += layers[i]->shade((1, 1, 1), s);
    // Which shaders there are.
    shader paints[] = getshaders("category", "paint"), all[] = getshaders();
    a = arraylength(paints) * 1000 + arraylength(all) * 100 + (first != null) * 10 +
        (getshader("nobody") == null) + (absent == null) * 2;
    if (first != null && s > 0) {
      // The second argument is converted to what the method takes; output arguments come back.
      b = first->bump(P, N) + 1000;
      point p = (1, 2, 3);
      float n = 7;
      first->move(p, 0.5, n);
      c = p[0] * 1000 + p[2] * 10 + n + first->gain * 10000;
      float gain = 0;
      d = getvar(first, "gain", gain) * 100 + gain * 10 + getvar(first, "nothing", gain);
      matrix m = first->turned(matrix 1);
      d += comp(m, 3, 3) * 1000;
      // A structure is its members, whatever its name.
      Geometry geo = Geometry((1, 2, 3), N, 5), back;
      e = first->lit(geo, back) * 100 + back->kd + xcomp(back->where) * 1000 + arraylength(more);
      first->surface(Ci, Oi);
    }
    // A method that there is not changes nothing and gives 0.
    d += first->missing(P, d) + absent->shade(1, 1) ;
  }
}

// one: shade = (1,2,3) s 2, two: (1,2,3) s 3; where s > 0 the surface of `one` has the last word.
// CHECK:      0 0  Ci 0 0 0 Oi 1 1 1 a 1213 b 0 c 0 d 0 e 0
// CHECK-NEXT: 1 0  Ci 1 2 3 Oi 0.5 0.5 0.5 a 1213 b 1105 c 21543 d 2120 e 1120
// CHECK-NEXT: 2 0  Ci 2 4 6 Oi 0.5 0.5 0.5 a 1213 b 1110 c 21543 d 2120 e 1120
// NONE:      0 0  Ci 0 0 0 Oi 1 1 1 a 3 b 0 c 0 d 0 e 0
// INFO: surface layer
// INFO: method layer.shade(tf)t
// INFO: method layer.move(tff)v
// INFO: method layer.name()s
// TWICE: --coshader: 'one' is given twice
