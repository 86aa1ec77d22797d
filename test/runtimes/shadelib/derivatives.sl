// The operators over derivatives, on a grid with du = 1/8 and dv = 1/4.
// RUN: %shade_everywhere %s %t
// TESTS: Deriv_float Deriv_color Deriv_vector area calculatenormal filterwidth_float filterwidth_vector
// TESTS: filterstep_at filterstep_at_by filterstep_by
// ARGS: --grid 9x5
// EXPECT derivs: 6 0 0
// EXPECT areas: 1 0.1875 0.5
// EXPECT normals: 0 0 0
// EXPECT widths: 0.5 0 0
// EXPECT steps: 0 0 0
// EXPECT filters: 0 0 0
// EXPECT edges: 0.5 0.5 0.5

surface operators(output varying color derivs = 0; output varying color areas = 0; output varying color normals = 1;
                  output varying color widths = 0; output varying color steps = 1; output varying color filters = 1;
                  output varying color edges = 0;) {
  // A quotient by what does not change is 0.
  derivs = color(Deriv(3 * s + 6 * t, s + 2 * t), Deriv(s, 1), 0);
  color c = Deriv(color(s, 2 * t, s * 0), s + t);
  vector w = Deriv(vector(s, 2 * t, 0), s + t);
  derivs += color(0, c[0] + c[1] - 3 + w[0] + w[1] - 3, c[2] + w[2]);

  point q = point(2 * s, 3 * t, 0);
  areas = color(area(q) * 16 / 3, area(q, "shading"), area(q) / (du * dv) / 12);

  // A plane leaning away, a plane seen from behind, and no surface at all.
  vector n = calculatenormal(P + vector(0, 0, s + 2 * t)), back = calculatenormal(point(-s, t, 0));
  normals = color(n - normalize(vector(-1, -2, 1))) + color(back - vector(0, 0, -1)) +
            color(calculatenormal(point(s, s, s)) - N);

  widths = color(filterwidth(4 * s), filterwidth(point(s, t, 0)) - sqrt(du * dv), filterwidth(2));

  float x = 4 * s, width = 0.5;
  steps = color(filterstep(1.1, x) - clamp((x - 1.1) / width + 0.5, 0, 1), filterstep(0.5, 0.2), filterstep(1, 2) - 1);

  float t = (x - 1.1) / (2 * width);
  float bell = abs(t) >= 1 ? step(0, t) : 0.5 + 0.5 * t * (2 - abs(t));
  filters = color(filterstep(1.1, x, "width", 2) - clamp(t + 0.5, 0, 1),
                  filterstep(1.1, x, "width", 2, "filter", "triangle") - bell,
                  filterstep(1.1, x - 0.25, x + 0.25, "filter", "box") - filterstep(1.1, x));
  edges = color(filterstep(x, x, "filter", "gaussian"), filterstep(x, x, "filter", "catmull-rom"),
                filterstep(x, x - 1, x + 1, "filter", "triangle"));
}
