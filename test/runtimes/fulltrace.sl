// fulltrace, by BMRT's name, over a plane, z = -1, that is all there is.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 11x3
// EXPECT results: 0 1 1 1e30
// EXPECT light: 0.3 0.25 0.2
// EXPECT none: 0 0 0
// EXPECT places: 0 0 0

surface full(output varying float results[4] = {2, 2, 2, 2}; output varying color light = 1, none = 1;
             output varying float places[3] = {1, 1, 1};) {
  vector down = (0, 0, -3), up = (0, 3, 4), way = 0;
  point at = 0, start = 0;
  normal n = 0;
  results[0] = fulltrace(P, down, light, results[2], at, n, start, way);
  places[0] = length(at - P - vector(0, 0, -1)) + length(n - vector(0, 0, 1)) + length(start) + length(way);
  results[1] = fulltrace(P, up, none, results[3], at, n, start, way);
  places[1] = length(start - P);
  places[2] = length(way - up);
}
