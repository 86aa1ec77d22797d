// TESTS: raylevel depth transform_matrix
// RUN: %shade_everywhere %s %t
// ARGS: --grid 9x2 --option Clipping=1,5 --query rayinfo:depth=2 --space camera=1,0,0,0,0,1,0,0,0,0,1,0,0,0,-3,1
// EXPECT level: 2
// EXPECT depths: 0 0.5 1
// EXPECT moved: 1 0 0 0 0 1 0 0 0 0 2 0 0 0 3 1
surface renderer(float one = 1; output varying float level = 9, depths[3] = {9, 9, 9}; output varying matrix moved = 0;) {
  level = raylevel();
  // Clipping planes at 1 and 5; z = 0 in camera space is z = -3 here.
  depths[0] = depth(point (s, t, -2));
  depths[1] = depth(point "camera" (s, t, 3 * one));
  depths[2] = depth((0, 0, 2));
  // z becomes 2 z, then 2 z - 3, then 2 z + 3.
  moved = mtransform("camera", "current", scale(matrix 1, vector (1, 1, 2)));
  moved = mtransform(translate(matrix 1, (0, 0, 6 * one)), moved);
}
