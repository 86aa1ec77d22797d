// Rays by the names that BMRT gave them, over a plane, z = -1, that is all there is. World space is the current one
// moved by (5, 6, 7) and doubled.
// RUN: %shade_everywhere %s %t
// ARGS: --grid 11x3 --space world=0.5,0,0,0,0,0.5,0,0,0,0,0.5,0,5,6,7,1

// EXPECT hit: 1 2 0 0 -2
// EXPECT missed: 1e30 1e30 0 0 1e30 1
// EXPECT lights: 0.3 0 0.3
// EXPECT passing: 1 0
// EXPECT places: 0 0 0 0 0 1
// EXPECT normals: 1 1
// EXPECT around: 1

float fulltrace(float x) { return 2 * x; } // one's own goes before the built-in

surface rays(output varying float hit[5] = {0, 0, 0, 0, 0}, missed[6] = {0, 0, 0, 0, 0, 0}, lights[3] = {0, 0, 0};
             output varying float passing[2] = {0, 0}, places[6] = {1, 1, 1, 1, 1, 1}, normals[2] = {0, 0}, around = 0) {
  vector down = (0, 0, -3), up = (0, 0, 3);
  point at = 0, start = 0;
  normal n = 0;
  vector way = 0;
  color light = 1;

  hit[0] = rayhittest(P, down, at, n);
  places[0] = length(at - P - vector(0, 0, -1));
  normals[0] = zcomp(n);
  missed[0] = rayhittest(P, up, at, n);

  // In world space
  point from = transform("world", P);
  vector fall = vtransform("world", down), rise = vtransform("world", up);
  hit[1] = rayserver(from, fall, at, n);
  places[1] = length(at - from - vector(0, 0, -2));
  normals[1] = zcomp(normalize(n));
  missed[1] = rayserver(from, rise, at, n);

  hit[2] = rayserver(from, fall, light, hit[4], at, n, start, way);
  hit[4] = -hit[4];
  lights[0] = light[0];
  places[2] = length(at - from - vector(0, 0, -2));
  places[3] = length(start) + length(way);
  missed[5] = rayserver(from, rise, light, missed[4], at, n, start, way);
  lights[1] = light[0];
  places[4] = length(start - from);
  places[5] = way . rise / (rise . rise);

  light = rayserver(from, fall);
  lights[2] = light[0];
  passing[0] = comp(rayserver(from, transform("world", P + up)), 0);
  passing[1] = comp(rayserver(from, transform("world", P + down)), 0);
  hit[3] = fulltrace(0);
  light = rayserver_indirect(from, ntransform("world", normal(0, 0, -1)));
  color off = light - color(0.3, 0.25, 0.2);
  around = max(abs(off[0]), abs(off[1]), abs(off[2])) < 1e-6 ? 1 : 0;
}
