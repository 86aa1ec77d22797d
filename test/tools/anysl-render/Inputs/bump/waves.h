// A sphere of radius 2 about the object's origin, with waves in longitude a and latitude b, in current space.
#define WAVES                                                                                                             \
  float a = 2 * PI * u, b = PI * (v - 0.5);                                                                               \
  vector x = vector "object" (1, 0, 0), y = vector "object" (0, 1, 0), z = vector "object" (0, 0, 1);                     \
  vector out = cos(b) * (cos(a) * x + sin(a) * y) + sin(b) * z;                                                           \
  vector outA = cos(b) * (cos(a) * y - sin(a) * x), outB = cos(b) * z - sin(b) * (cos(a) * x + sin(a) * y);               \
  float r = 2 + 0.1 * sin(4 * a) * cos(3 * b), rA = 0.4 * cos(4 * a) * cos(3 * b), rB = -0.3 * sin(4 * a) * sin(3 * b);   \
  vector byU = 2 * PI * (rA * out + r * outA), byV = PI * (rB * out + r * outB), exact = normalize(byU ^ byV);
