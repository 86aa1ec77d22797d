// illuminance sees the lights of the cone, with L towards the light; ambient lights only through ambient().
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 2x1 --width 1 --light ambient:color=0.25,0.25,0.25 --light distant:color=1,0,0:direction=0,0,-1 --light point:color=0,2,0:from=0,0,2 --light distant:color=0,0,4:direction=0,0,1 --print all --print front --print count --print dot --print Ci > %t.1
// RUN: anysl-shade %t.so --grid 2x1 --width 8 --light ambient:color=0.25,0.25,0.25 --light distant:color=1,0,0:direction=0,0,-1 --light point:color=0,2,0:from=0,0,2 --light distant:color=0,0,4:direction=0,0,1 --print all --print front --print count --print dot --print Ci > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8

color lambert(normal n) {
  extern vector L;
  extern color Cl;
  return Cl * max(0, normalize(L) . n);
}

surface lights(output varying color all = 0, front = 0; output varying float count = 0, dot = 0) {
  normal n = normalize(N);
  illuminance(P) {
    all += Cl;
    dot += normalize(L) . n;
  }
  illuminance(P, n, PI / 2) {
    front += lambert(n);
    count += 1;
    if (count == 2)
      break;
    continue;
  }
  Ci = ambient();
}

// P = (0, 0, 0): the point light is straight above, its intensity falls with the square of the distance.
// CHECK: 0 0  all 1 0.5 4  front 1 0.5 0  count 2  dot 1  Ci 0.25 0.25 0.25
// P = (1, 0, 0): at distance sqrt 5, its cosine is 2 / sqrt 5.
// CHECK: 1 0  all 1 0.4{{[0-9]*}} 4  front 1 0.3577{{[0-9]*}} 0  count 2  dot 0.8944{{[0-9]*}}  Ci 0.25 0.25 0.25
