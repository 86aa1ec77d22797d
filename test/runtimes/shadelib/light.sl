// TESTS: diffuse specular phong specularbrdf
// RUN: %shade_everywhere %s %t
// ARGS: --grid 5x2 --set P=0,0,0 --light point:from=0,0,2:color=4,8,12 --light distant:direction=0,0,-1:color=1,0,0:nonspecular
// ARGS: --light distant:direction=0,0,1:color=9,9,9 --light distant:direction=0,0,-1:color=0,1,0:nondiffuse
// The point light gives (1, 2, 3) from straight above; the last but one shines from below and counts nowhere.
// EXPECT straight: 2 2 3
// EXPECT oblique: 1.2 1.2 1.8
// EXPECT highlight: 0.81 2.43 2.43
// EXPECT sharpest: 0 0 0
// EXPECT mirrored: 0.256 0.384 0.384
// EXPECT one: 0.81 0.81 0.81
surface lit(float unit = 1; output varying color straight = 9; output varying color oblique = 9; output varying color highlight = 9;
            output varying color sharpest = 9; output varying color mirrored = 9; output varying color one = 9;) {
  normal up = normal (0, 0, unit), tilted = normal (0.8, 0, 0.6 * unit);
  straight = diffuse(up);
  oblique = diffuse(tilted);
  // V at twice the angle whose cosine is 0.9 from L: H is at that angle from N, and 0.9^2 = 0.81.
  vector V = vector (2 * 0.9 * sqrt(0.19 * unit), 0, 2 * 0.81 - 1);
  highlight = specular(up, V, 0.5);
  sharpest = specular(up, V, 0 * unit);
  // R.L = 0.8 for V at an angle whose cosine is 0.8 from N; 0.8^3 = 0.512, scaled down by the colour below.
  mirrored = 0.25 * phong(up, vector (1.2 * unit, 0, 1.6), 3);
  one = specularbrdf(vector (0, 0, unit), up, V, 0.5);
}
