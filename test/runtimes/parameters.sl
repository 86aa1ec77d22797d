// Parameters of every type, uniform and given point by point; defaults that depend on earlier ones.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 9x4 --param k=3 --param tint=0.5,0.25,1 --set offset=0.125
// PRINT: Ci a
// EXPECT b: 6 12
surface parameters(float k = 2; float twice = 2 * k; color tint = 1; string name = "wood"; vector v = vector (1, 2, k);
                   float list[2] = {k, 4}; matrix m = 1; varying float offset = 0;
                   output varying color a = 0; output float b[2] = {0, 0};) {
  a = tint * (zcomp(v) + offset) + color (list[0], list[1], comp(m, 0, 0));
  b[0] = twice;
  b[1] = 2 * twice;
  Ci = name == "wood" ? a * s : color 0;
}
