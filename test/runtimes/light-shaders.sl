// illuminance and ambient() run light shaders, also of other libraries, layouts and number formats than the surface's.
// RUN: rslc -Wno-missing-default %S/Inputs/lamps.sl -o %t.lamps.bc
// RUN: anysl-link %t.lamps.bc -o %t.packet.lamps.so --width 1,4,8,16
// RUN: anysl-link %t.lamps.bc -o %t.narrow.lamps.so --width 4
// RUN: anysl-link %t.lamps.bc -o %t.scalar.lamps.so --width 1,4 --runtime scalar --real double
// DEFINE: %{lamps} = --light %t.a.so:key --light %t.b.so:cone --light %t.a.so:branch --light %t.b.so:outside \
// DEFINE:   --light %t.a.so:sky --light %t.b.so:facing --light %t.b.so:surroundings --light %t.a.so:glow \
// DEFINE:   --light %t.a.so:direct --light %t.b.so:here:space=0,0,1,0,1,0,0,0,0,1,0,0,0,0,5,1 \
// DEFINE:   --light %t.b.so:classic --light %t.a.so:triples --light pointlight:from=0,0,2:category=standard --light %t.packet.lamps.so:noisy
// RUN: cp %t.packet.lamps.so %t.a.so && cp %t.scalar.lamps.so %t.b.so
// RUN: %shade_everywhere %s %t %{lamps}
// RUN: cp %t.scalar.lamps.so %t.a.so && cp %t.narrow.lamps.so %t.b.so
// RUN: %shade_everywhere --linked %s %t %{lamps}
// ARGS: --grid 19x2 --ramp P=0,0,0:1,0,0:x --ramp N=0,0,1:0,0.5,0.5:y --set time=0.25 --light ambient:intensity=0.25
// PRINT: random
// EXPECT wrong: 0
// EXPECT lights: 11
float same(color a, b) {
  color d = a - b;
  return max(abs(comp(d, 0)), abs(comp(d, 1)), abs(comp(d, 2))) < 2e-6 ? 1 : 0;
}
float same(vector a, b) { return same(color(a), color(b)); }

// How many lights of a category reach P, and one's L, Cl and Ol.
float ask(string category; vector axis; output vector l; output color c, o;) {
  float count = 0;
  l = 0; c = 0; o = 0;
  illuminance (category, P, axis, PI) {
    count += 1;
    l = L; c = Cl; o = Ol;
  }
  return count;
}

surface asking(output varying float wrong = 0, lights = 0; output varying color random = 0;) {
  float x = xcomp(P), n, seen = -1, found = 0;
  vector l, way = 0, none = 5;
  color c, o, d;
  string category = "";

  wrong += 1 - same(ambient(), color(0.25 + x + 0.5 + 0.125));

  n = ask("key", N, l, c, o);
  wrong += n != 1 || !same(l, vector (-x, 0, 2)) || !same(c, 4 * color(1, 2, 3) / (x * x + 4)) || !same(o, color(1)) ? 10 : 0;
  illuminance ("key", P, "lightcache", "refresh", "light:way", none)
    found = lightsource("seen", seen) + 10 * lightsource("way", way) + 100 * lightsource("intensity", c) +
            1000 * lightsource("__category", category) + 10000 * lightsource("missing", n);
  wrong += found != 1111 || !same(c, color(4)) || abs(seen - x - 1) > 1e-6 || !same(way, vector (x, 0, -2)) || !same(none, way) ||
                   category != "warm,key" ? 100 : 0;   // a float goes into a color

  n = ask("cone", N, l, c, o);
  wrong += n != (abs(x - 0.5) < tan(0.4) ? 1 : 0) ? 1000 : 0;
  n = ask("branch", N, l, c, o);
  wrong += !same(c, color(x > 0.5 ? 1 : x < 0.25 ? 2 : 0)) || n != (x > 0.5 || x < 0.25 ? 1 : 0) ||
                   !same(l, x > 0.5 ? vector (-x, 0, 3) : vector (0, 0, n)) ? 10000 : 0;
  n = ask("outside", N, l, c, o);
  wrong += n != (x < 1 ? 1 : n) || !same(c, color(6 * n)) ? 100000 : 0;

  // solar() lights along the axis, or along N where there is none. Asking again with another axis asks the light again.
  n = ask("sky", vector (1, 0, 0), l, c, o);
  wrong += n != 1 || !same(l, vector (1, 0, 0)) ? 1e6 : 0;
  illuminance ("sky", P)
    wrong += !same(L, N) ? 1e6 : 0;
  n = ask("facing", N, l, c, o);
  wrong += n != 1 || !same(c, color(N)) ? 1e6 : 0;
  n = ask("facing", vector (3, 2, 1), l, c, o);
  wrong += n != 1 || !same(c, color(3, 2, 1)) ? 1e6 : 0;

  n = ask("surroundings", N, l, c, o);
  wrong += n != 1 || !same(c, color(u, v, 0.25)) || !same(o, color(s, t, 0.5)) ? 1e7 : 0;
  n = ask("direct", N, l, c, o);
  wrong += n != 1 || !same(l, vector (0, 0, 2)) ? 1e7 : 0;
  // P is the origin of the light's own space, N its z axis.
  n = ask("here", N, l, c, o);
  wrong += n != 1 || !same(l, vector (-x, 0, 5)) || !same(c, color(0, 1, 0)) ? 1e7 : 0;

  // The same answer as often as it is asked, and another for another position.
  n = ask("noisy", N, l, random, o);
  n = ask("noisy", vector (1, 0, 0), l, c, o);
  wrong += random != c || comp(c, 0) == comp(c, 2) ? 1e8 : 0;
  illuminance ("noisy", P + vector (0.1, 0, 0))
    d = Cl;
  wrong += d == c || comp(c, 0) != comp(d, 0) ? 1e8 : 0;

  // "" is every light, ambient ones left out; the cone and the branch do not light every point.
  illuminance (P)
    lights += 1;
  n = ask("", N, l, c, o);
  wrong += n != lights ? 1e9 : 0;
  n = ask("-warm,cone", N, l, c, o);
  illuminance ("key,cone", P)
    n += 1;
  wrong += n != lights ? 1e9 : 0;
  n = ask("cone,branch,outside", N, l, c, o);
  lights += 3 - n;
  // Lights are asked where a branch is taken, and only by the points that take it.
  d = 0;
  if (mod(floor(18 * x + 0.5), 2) == 0) {
    illuminance ("noisy", P)
      d = Cl;
    illuminance ("key", P)
      d += Cl;
  }
  wrong += d != 0 && !same(d, random + 4 * color(1, 2, 3) / (x * x + 4)) ? 1e10 : 0;
  n = ask("nothing", N, l, c, o);
  wrong += n;
}
