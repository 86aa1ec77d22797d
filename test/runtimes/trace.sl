// Rays from some points of a packet only: nested conditions, loops whose length differs from point to point.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 19x6 --ramp I=0,0,-1:0.7,0.3,-1:y
// PRINT: Ci a b c
surface traces(output varying color a = 0; output varying float b = 0; output varying color c = 0;) {
  vector R = reflect(normalize(I), normalize(N));
  if (s > 0.2) {
    a = trace(P, R);
    if (t < 0.5)
      b = trace(P, I);
    c = transmission(P, P + R);
  }
  float i;
  for (i = 0; i < 5 * s; i += 1)
    Ci += trace(P, R + vector (0.1 * i, 0, 0)) / (i + 1);
}
