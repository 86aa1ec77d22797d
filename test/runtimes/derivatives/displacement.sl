// A displacement shader moves P and computes N anew: P is (u, v, u u - v / 2), whose normal is (-2 u, 1/2, 1).
// RUN: %shade_everywhere %s %t
// ARGS: --grid 5x3
// PRINT: N P
// EXPECT difference: 0 0 0
displacement displaced(output varying vector difference = 1;) {
  P += (u * u - 0.5 * v) * normalize(N);
  N = calculatenormal(P);
  difference = N - normalize(vector(-2 * u, 0.5, 1));
}
