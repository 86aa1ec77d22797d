// Everything that lights do to a surface.
surface sums(output varying color a = 0, d = 0, g = 0, c = 0, o = 0; output varying vector l = 0; output varying float n = 0;) {
  normal tilted = normalize(N + normal (s - 0.5, t - 0.5, 0));
  a = ambient();
  d = diffuse(tilted);
  g = specular(tilted, normalize(vector (0.2, 0.1, 1)), 0.1 + s);
  illuminance (P, tilted, 1) {
    c += Cl;
    o += Ol;
    l += L;
    n += 1;
  }
  Ci = a + d + g + c + o + color(l) + n;
}
