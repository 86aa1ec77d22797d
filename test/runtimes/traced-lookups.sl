// environment() and shadow() in "raytrace" are rays, also where the name is a parameter: the same as trace() and transmission().
// The world has a plane at z = -1, which hides what lies below.
// RUN: rslc %S/Inputs/shadowed.sl -o %t.lights.bc && anysl-link %t.lights.bc -o %t.lights.so --width 1,4,8,16
// DEFINE: %{lamps} = --light %t.lights.so:above:shadowname=raytrace --light %t.lights.so:below:shadowname=raytrace \
// DEFINE:   --light %t.lights.so:sun:shadowname=raytrace --light %t.lights.so:moon --light %t.lights.so:reflected
// RUN: %shade_everywhere %s %t %{lamps}
// ARGS: --grid 19x2 --ramp P=0,0,0:1,0,0:x --set N=0,0,1
// EXPECT wrong: 0
float differ(color a, b) {
  color d = a - b;
  return max(abs(comp(d, 0)), abs(comp(d, 1)), abs(comp(d, 2))) < 1e-5 ? 0 : 1;
}

color from(string category) {
  color sum = 0;
  illuminance (category, P, N, PI)
    sum += Cl;
  return sum;
}

surface looking(string name = "raytrace"; output varying float wrong = 0;) {
  float x = xcomp(P);
  vector R = vector (x, 1, x - 0.5);
  color here = trace(P, R);
  wrong += differ(environment("raytrace", R), here) + 10 * differ(environment(name, R), here);
  wrong += 100 * differ(float environment(name, R), comp(here, 0));
  wrong += 100 * differ(float environment(name[1], R), comp(here, 1)) + 100 * differ(float environment(name, R, "channel", 2), comp(here, 2));
  // Over four directions the mean of them; with "maxdist" the plane is too far off.
  wrong += 1000 * differ(environment(name, R + vector (1, 0, 0), R, R, R - vector (1, 0, 0)), here);
  wrong += 1e4 * differ(environment(name, vector (0, 0, -1), "maxdist", 0.5, "samples", 4), trace(P, vector (0, 0, -1), "maxdist", 0.5));
  wrong += 1e5 * differ(environment(x > 0.5 ? name : "", R), x > 0.5 ? here : environment("", R));
  // Lights: the plane hides those below.
  wrong += 1e6 * (differ(from("above"), 1) + differ(from("below"), 0) + differ(from("sun"), 1) + differ(from("moon"), 0));
  wrong += 1e7 * differ(from("reflected"), trace(P, vector (1, 0, 1)));
}
