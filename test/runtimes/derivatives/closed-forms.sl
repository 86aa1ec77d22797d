// Derivatives beside their closed forms, in every runtime, real and width; the values beside s are those of du and dv.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 9x7
// EXPECT polynomial: 0 0 0
// EXPECT functions: 0 0 0
// EXPECT triples: 0 0 0
// EXPECT flow: 0 0 0
// EXPECT noises: 0 0 0
// EXPECT areas: 0 0 0
// EXPECT eye: 0 0 0

float product(float a, b) { return a * b; }

surface derivatives(output varying color polynomial = 1; output varying color functions = 1;
                    output varying color triples = 1; output varying color flow = 1; output varying color noises = 1;
                    output varying color areas = 1; output varying color eye = 1; float k = 2;) {
  polynomial = color(Du(k * s * s * t) - 2 * k * s * t, Dv(k * s * s * t) - k * s * s, Du(u) + Dv(v) + Du(v) - 2);

  float x = 0.3 + s, y = 0.2 + t;
  functions = color(Du(pow(x, y)) - y * pow(x, y - 1) + Dv(pow(x, y)) - log(x) * pow(x, y),
                    Du(sin(x * y) / x) - y * cos(x * y) / x + sin(x * y) / (x * x), Deriv(x * x * y, x) - 2 * x * y);

  vector p = vector(s * t, s, t * t);
  color c = color(s, t, s + t);
  vector inSpace = Du(p) - vector(t, 1, 0);
  triples = color(length(inSpace) + length(Dv(p) - vector(s, 0, 2 * t)), comp(Du(c), 0) + comp(Dv(c), 2) - 2,
                  comp(Deriv(c, s), 1) + length(Deriv(p, s) - vector(t, 1, 0)));

  // Through loops, arrays, functions and branches; a comparison looks at values.
  float powers[4];
  float i, sum = 0;
  for (i = 0; i < 4; i += 1)
    powers[i] = pow(x, i);
  for (i = 0; i < 4; i += 1) {
    if (mod(i, 2) == 0)
      sum += product(powers[i], y);
    else
      sum -= powers[i];
  }
  float folded = x;
  while (folded < 2)
    folded *= 2;
  flow = color(Du(sum) - 2 * x * y + 1 + 3 * x * x, Dv(sum) - 1 - x * x, Du(folded) - folded / x);

  // Noise against differences of noise; they lose half of the digits.
  float h = 1 / 64;
  point q = point(3 * s + 0.1, 2 * t + 0.2, 0.4);
  float across = Du(float noise(q)), difference = (float noise(q + vector(h, 0, 0)) - float noise(q - vector(h, 0, 0))) / (2 * h);
  noises = color(abs(across - 3 * difference) < 0.02 ? 0 : across - 3 * difference, Du(float cellnoise(q)),
                 Dv(float noise(7 * s)));

  // P is (s, t, 0).
  areas = color(area(P) - du * dv, area(P + vector(0, 0, s)) - sqrt(2) * du * dv, filterwidth(P) - sqrt(du * dv));
  eye = color(Du(P) - vector(1, 0, 0)) + color(Du(I)) + color(Dv(N));
}
