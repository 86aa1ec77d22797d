// Numbers at the edges of every operator that has some, in some points of a packet and not in their neighbours.
// From finite operands comes a finite number, the same at every width.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 16x3 --param huge=1e30 --param tiny=1e-40
// REALS: float
// PRINT: a b c d
// EXPECT finite: 1
surface extremes(float huge = 1, tiny = 1;
                 output varying color a = 0; output varying color b = 0; output varying color c = 0;
                 output varying color d = 0; output varying float finite = 0;) {
  // 0, then small and large of both signs, by column.
  float column = round(15 * s);
  float x = mod(column, 8);
  if (x == 1) x = tiny;
  else if (x == 2) x = -tiny;
  else if (x == 3) x = huge;
  else if (x == 4) x = -huge;
  else if (x == 5) x = 1.0000001;
  else if (x == 6) x = -1.0000001;
  float y = column < 8 ? 0 : 1 / (t + 0.001);
  a = color (1 / x, sqrt(x), inversesqrt(x)) + color (log(x), acos(x), asin(x));
  b = color (pow(x, y) / 4, mod(x, y), mod(y, x)) + color (exp(x) / 4, atan(y, x), smoothstep(x, y, 0.5));
  vector v = vector (x, y, x);
  float Kr, Kt;
  fresnel(normalize(v), normal (0, 0, 1), x, Kr, Kt);
  c = color (normalize(v)) + color (length(v) == 0 ? 0 : 1, Kr, Kt);
  d = noise(point v) + cellnoise(point v) + pnoise(point v, point (y, x, 3)) + color (float noise(x), float cellnoise(x), 0);
  float table[3] = {1, 2, 3};
  c += table[x] + comp(v, x) / huge;
  // NaN is equal to nothing, and an infinity less infinity is NaN.
  color rest = (a - a) + (b - b) + (c - c) + (d - d);
  finite = rest == color 0 ? 1 : 0;
}
