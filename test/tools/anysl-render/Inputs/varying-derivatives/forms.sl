// How variables change beside closed forms: those given at corners are bilinear in u and v, and the normals of a sphere
// of radius 2 about the object's origin are half of the way from there. All is 0.5 where all is right.
float off(color a, b) { color d = abs(a - b); return max(comp(d, 0), max(comp(d, 1), comp(d, 2))); }
color acrossU(color a, b, c, d) { return mix(b, d, v) - mix(a, c, v); }
color acrossV(color a, b, c, d) { return mix(c, d, u) - mix(a, b, u); }
float offBilinear(color x, a, b, c, d) { return max(off(Du(x), acrossU(a, b, c, d)), off(Dv(x), acrossV(a, b, c, d))); }

surface forms(varying float own = 9; varying vector way = 9; varying color pair[2] = {9, 9};) {
  color a = color(0, 0, 1), b = color(0.5, 1, 0), c = color(1, 0.25, 0), d = color(1, 0, 1);
  float colors = max(offBilinear(Cs, a, b, c, d), offBilinear(pair[1], a, b, c, d));
  float opacities = offBilinear(Os, color(1), color(0.5, 1, 1), color(1, 0.25, 1), color(1, 0.25, 1));
  float numbers = offBilinear(color(own), color(1), color(3), color(0), color(4));
  vector x = vector "object" (1, 0, 0), y = vector "object" (0, 1, 0), z = vector "object" (0, 0, 1);
  float ways = length(Du(way) - (mix(y, y + z, v) - mix(x, z, v))) + length(Dv(way) - (mix(z, y + z, u) - mix(x, y, u)));
  float side = 0.5 * sign(N . (P - point "object" (0, 0, 0)));
  float normals = length(Du(N) - side * dPdu) + length(Dv(N) - side * dPdv) + length(Du(Ng) - side * dPdu) + length(Dv(Ng) - side * dPdv);
  Ci = 0.5 + color(max(colors, opacities), max(numbers, ways), normals);
  Oi = 1;
}
