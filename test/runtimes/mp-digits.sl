// With the real mp, digits that double has not survive: in arithmetic, functions, the shading library and derivatives.
// What is left after all that a double holds has cancelled is scaled up again.
// RUN: %shade_everywhere %s %t
// REALS: mp
// ARGS: --grid 3x2
// EXPECT sums: 1 1 0
// EXPECT functions: 0.5 1 0.166666666666
// EXPECT library: 1 1 1
// EXPECT slope: 3
surface digits(output varying color sums = 0; output varying color functions = 0; output varying color library = 0;
               output varying float slope = 0;) {
  float tiny = 1e-20;
  // 3 (1/3) = 1 to 2^-199.
  sums = color(((1 + tiny) - 1) / tiny, ((3 + 3 * tiny) / 3 - 1) / tiny, 1e30 * (3 * (1 / 3) - 1));
  // 1 - cos x = x^2/2 - ..., log(1 + x) = x - ..., x - sin x = x^3/6 - ...
  functions = color((1 - cos(tiny)) / (tiny * tiny), log(1 + tiny) / tiny, (tiny - sin(tiny)) / (tiny * tiny * tiny));
  vector v = normalize(vector(1, tiny, 0));
  matrix m = scale(matrix 1, vector(1 + tiny, 1, 1));
  // The square of the length is one; the direction keeps what is small beside it.
  library = color(v . v, ycomp(v) / tiny, (xcomp(vtransform(m, vector(1, 0, 0))) - 1) / tiny);
  slope = (Du(s + 3 * tiny * s) - 1) / tiny;
}
