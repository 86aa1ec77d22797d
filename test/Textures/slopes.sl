// What is looked up changes as the picture does: pictures that are linear between all their texels' centres, read where
// the coordinates change at known rates, beside closed forms.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: printf 'surface flat() { Ci = color(s, t, s * t); }' > flat.sl
// RUN: rslc flat.sl && anysl-link flat.stc.bc --width 8 && anysl-shade flat.so --grid 64x32 --ramp s=0.0078125:0.9921875:x --ramp t=0.015625:0.984375:y -o flat.exr
// RUN: oiiotool flat.exr --ch R -o grey.exr
// RUN: printf 'surface cube() { float f = floor(6 * t); Ci = color(2 * s - 1, 1 - 2 * (6 * t - f), f); }' > cube.sl
// RUN: rslc cube.sl && anysl-link cube.stc.bc --width 8 && anysl-shade cube.so --grid 32x192 --ramp s=0.015625:0.984375:x --ramp t=0.0026041667:0.9973958333:y -o cube.exr
// RUN: %shade_everywhere %s %t/slopes
// ARGS: --grid 13x9 --ramp s=0.1:0.9:x --ramp t=0.2:0.7:y
// REALS: float

// EXPECT flat: 1
// EXPECT corners: 1
// EXPECT along: 0
// EXPECT globe: 1
// EXPECT cube: 1
// EXPECT bumped: 1
// EXPECT nowhere: 0
// EXPECT filtered: 1
// EXPECT grey: 1
// EXPECT closest: 0

// How far a texel's rounding may show in a slope.
float near(float a, b) { return abs(a - b) < 2e-4 ? 1 : 0; }

surface slopes(output varying float flat = 0, corners = 0, along = 1, globe = 0, cube = 0, bumped = 0, nowhere = 1, filtered = 0,
               grey = 0, closest = 1) {
  float a = 0.1 + 0.8 * s * s, b = t * (0.5 + 0.5 * s);
  color c = texture("flat.exr", a, b, "width", 0), byU = Du(c), byV = Dv(c);
  flat = near(comp(byU, 0), Du(a)) * near(comp(byV, 0), 0) * near(comp(byU, 1), Du(b)) * near(comp(byV, 1), Dv(b)) *
         near(comp(byU, 2), Du(a) * b + a * Du(b)) * near(comp(byV, 2), a * Dv(b));
  // Over the corners, the middle counts.
  float middle = texture("flat.exr"[2], a, b, a, b, a, b, a, b);
  corners = near(Du(middle), Du(a) * b + a * Du(b));
  along = Du(float texture("flat.exr", 0.3, 0.6, "width", 0));

  // The same picture, of all directions: its channels are turns about z, and half turns from it.
  float turn = 2 * PI * (0.1 + 0.7 * s), tilt = PI * (0.2 + 0.5 * t + 0.1 * s);
  vector d = vector(cos(turn) * sin(tilt), sin(turn) * sin(tilt), cos(tilt)) * (1 + 3 * s);
  color e = environment("flat.exr", d, "width", 0);
  globe = near(comp(Du(e), 0), Du(turn) / (2 * PI)) * near(comp(Dv(e), 0), 0) *
          near(comp(Du(e), 1), Du(tilt) / PI) * near(comp(Dv(e), 1), Dv(tilt) / PI);

  // On the cube's face towards -y, right is x and up is z, each divided by -y.
  vector toFace = vector(s - 0.5, -2 - s, 0.7 * t - 0.3) * 3;
  color f = environment("cube.exr", toFace, "width", 0);
  cube = near(comp(f, 2), 3) * near(comp(Du(f), 0), Du((s - 0.5) / (2 + s))) * near(comp(Du(f), 1), Du((0.7 * t - 0.3) / (2 + s))) *
         near(comp(Dv(f), 1), Dv((0.7 * t - 0.3) / (2 + s)));

  // A bump out of a picture: P is (u, v, 0).
  normal n = calculatenormal(P + 0.3 * float texture("flat.exr"[2], a, b, "width", 0) * normalize(N));
  bumped = length(n - normalize(vector(-0.3 * (Du(a) * b + a * Du(b)), -0.3 * a * Dv(b), 1))) < 2e-4 ? 1 : 0;

  // However wide the filter is, in whatever coarser picture it looks; but not beyond the edges.
  float inner = 0.4 + 0.2 * s;
  filtered = near(Du(float texture("flat.exr", inner, 0.5)), Du(inner)) *
             near(Du(float texture("flat.exr", inner, 0.5, "filter", "bicubic")), Du(inner));
  closest = Du(float texture("flat.exr", inner, 0.5, "filter", "closest"));
  // One channel is all three, or those that are not there are what is to fill them.
  color one = texture("grey.exr", a, b, "width", 0), filled = texture("grey.exr", a, b, "width", 0, "fill", 0.5);
  grey = near(comp(Du(one), 2), Du(a)) * near(comp(Du(filled), 0), Du(a)) * (comp(Du(filled), 2) == 0 ? 1 : 0);

  nowhere = Du(float environment("flat.exr", vector(s - s, 0, 0)));
}
