// A displacement shader that is linked so says how what it has moved changes: P rises by 1/2 with u, in a roundabout way, and falls by
// 1/4 with v.
// RUN: %shade_everywhere %s %t
// PARAM: --tangents
// ARGS: --grid 5x3
// PRINT: P
// EXPECT dPdu: 1 0 0.5
// EXPECT dPdv: 0 1 -0.25
displacement tangents() {
  P += (0.5 * exp(log(u + 1)) - 0.25 * v) * normalize(N);
}
