// Constants, components, arrays, conditions and arithmetic, with operands that change from point to point.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 17x5
// PRINT: Ci a b c
surface values(output varying float a = 0; output varying color b = 0; output varying vector c = 0;) {
  float table[3] = {0.25, 0.5, 0.75};
  matrix m = matrix (2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, s, t, 1, 1);
  a = table[3 * s] + comp(m, 3, t) + mod(7 * s - 3, 2);
  if (s > 0.3 && t < 0.7 || s == 0)
    b = color (a, s * t, 1) / color (s + 1, t, 0);
  else
    b = -Cs;
  c = transform(m, point (s, t, a)) ^ vector (t, s, 2);
  setcomp(b, 2 * s, a);
  Ci = color (s, t, c . c);
}
