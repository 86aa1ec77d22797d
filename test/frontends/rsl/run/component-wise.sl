// Functions of floats on triples, and what a light says about itself.
// RUN: rslc -Wno-unanswered %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 1x1 --width 1 --set Cs=4,0.25,9 --light point:from=0,0,1 --light point:from=0,0,1:nondiffuse --light point:from=0,0,1:nonspecular --print a --print b --print c --print flags > %t.1
// RUN: anysl-shade %t.so --grid 1x1 --width 8 --set Cs=4,0.25,9 --light point:from=0,0,1 --light point:from=0,0,1:nondiffuse --light point:from=0,0,1:nonspecular --print a --print b --print c --print flags > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8

surface componentwise(output varying color a = 0, b = 0; output varying vector c = 0; output varying float flags = 0) {
  a = sqrt(Cs);
  b = pow(Cs, 2);
  c = mod(vector(-1.5, 5, 7), 3);
  float digit = 1;
  illuminance(P) {
    uniform float nondiffuse = 0, nonspecular = 0, other = 5;
    float known = lightsource("__nondiffuse", nondiffuse) + lightsource("__nonspecular", nonspecular) +
                  lightsource("other", other);
    flags += digit * (nondiffuse + 2 * nonspecular + (known == 2 && other == 5 ? 0 : 100));
    digit *= 10;
  }
}

// CHECK: a 2 0.5 3  b 16 0.0625 81  c 1.5 2 1  flags 210
