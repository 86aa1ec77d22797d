// Noise in every form; the cells of float and double are the same.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 23x7 --ramp P=-3.1,-2.7,0.3:4.3,5.1,9.6:x
// PRINT: Ci a b c
surface noises(output varying color a = 0; output varying color b = 0; output varying color c = 0;) {
  a = color (float noise(7.3 * s + 0.01), float noise(5.1 * s, 3.7 * t), float noise(P)) + noise(P, 2.3 * t);
  b = color (float cellnoise(7.3 * s + 0.01), float cellnoise(5.1 * s + 0.01, 3.7 * t), float cellnoise(P)) + cellnoise(P, 2.3 * t);
  c = color (float pnoise(7.3 * s, 3), float pnoise(5.1 * s, 3.7 * t, 2, 4), 0) + pnoise(P, point (2, 3, 4));
  point q = noise(P);
  Ci = color q;
}
