// The normal of a sphere with waves on it beside its closed form, and that of a surface bumped through N and noise.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 17x9
// EXPECT sphere: 0 0 0
// EXPECT plane: 0 0 0
// EXPECT turned: 0 0 0

surface bump(output varying vector sphere = 1; output varying vector plane = 1; output varying vector turned = 1;) {
  // In longitude a and latitude b; waves of a tenth of the radius.
  float a = 2 * PI * u, b = 0.9 * PI * (v - 0.5);
  point unit = point(cos(b) * cos(a), cos(b) * sin(a), sin(b));
  vector unitA = vector(-cos(b) * sin(a), cos(b) * cos(a), 0), unitB = vector(-sin(b) * cos(a), -sin(b) * sin(a), cos(b));
  float r = 1 + 0.1 * sin(4 * a) * cos(3 * b), rA = 0.4 * cos(4 * a) * cos(3 * b), rB = -0.3 * sin(4 * a) * sin(3 * b);
  vector exact = normalize((rA * unit + r * unitA) ^ (rB * unit + r * unitB));
  sphere = calculatenormal(unit * r) - exact;

  // As displacement shaders write it: P is (u, v, 0), and N is (0, 0, 1).
  float height = 0.2 * sin(5 * s) * t * t;
  point bumped = P + height * normalize(N);
  plane = calculatenormal(bumped) - normalize(vector(-cos(5 * s) * t * t, -0.4 * sin(5 * s) * t, 1));

  // The same, turned over: the normal stays on the side on which the surface has its own.
  turned = calculatenormal(rotate(bumped, PI, point(0, 0, 0), point(1, 0, 0))) -
           normalize(vector(-cos(5 * s) * t * t, 0.4 * sin(5 * s) * t, -1));
}
