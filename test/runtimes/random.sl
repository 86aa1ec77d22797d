// Each point has its own sequence, however often its neighbours draw.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 21x5
// PRINT: Ci a
surface randoms(output varying float a = 0;) {
  float i;
  for (i = 0; i < 6 * s; i += 1)
    a += float random();
  if (t > 0.4)
    Ci = random();
  Ci += color (float random(), float random(), 0);
}
