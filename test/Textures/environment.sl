// Environment maps that show each direction as a colour, (d + 1) / 2, as a latitude-longitude map with z up and as a
// column of the six faces of a cube. The shader that makes them goes from places to directions by tables of its own.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: printf 'surface latlong() { float a = 2*PI*s, b = PI*t; Ci = 0.5 + 0.5*color(cos(a)*sin(b), sin(a)*sin(b), cos(b)); }' > latlong.sl
// RUN: printf 'surface cube() { float f = floor(6*t), x = 2*s-1, y = 1-2*(6*t-f); vector d = (1,y,-x); if (f == 1) d = (-1,y,x); if (f == 2) d = (x,1,-y); if (f == 3) d = (x,-1,y); if (f == 4) d = (x,y,1); if (f == 5) d = (-x,y,-1); Ci = 0.5 + 0.5*color(normalize(d)); }' > cube.sl
// RUN: rslc latlong.sl && anysl-link latlong.stc.bc --width 8 && anysl-shade latlong.so --grid 128x64 --ramp s=0.00390625:0.99609375:x --ramp t=0.0078125:0.9921875:y -o latlong.exr
// RUN: rslc cube.sl && anysl-link cube.stc.bc --width 8 && anysl-shade cube.so --grid 32x192 --ramp s=0.015625:0.984375:x --ramp t=0.0026041667:0.9973958333:y -o cube.exr
// RUN: %shade_everywhere %s %t/environment
// ARGS: --grid 23x11
// REALS: float

// EXPECT near: 1 1
// EXPECT single: 1
// EXPECT nowhere: 0 0 0
// EXPECT wide: 1
// EXPECT corners: 0
// EXPECT filtered: 1

surface environments(output varying float near[2] = {0, 0}; output varying float single = 0, wide = 0, corners = 0, filtered = 0;
                     output varying color nowhere = 1) {
  // Every direction, of some length; not the poles' own texels, where a map's rows are thin.
  float a = 2 * PI * u, b = 0.05 + (PI - 0.1) * v;
  vector d = (cos(a) * sin(b), sin(a) * sin(b), cos(b));
  color wanted = 0.5 + 0.5 * color(d);
  color off = color environment("latlong.exr", 7 * d, "width", 0) - wanted;
  near[0] = max(abs(comp(off, 0)), abs(comp(off, 1)), abs(comp(off, 2))) < 0.01 ? 1 : 0;
  off = color environment("cube.exr", 0.1 * d, "width", 0) - wanted;
  near[1] = max(abs(comp(off, 0)), abs(comp(off, 1)), abs(comp(off, 2))) < 0.04 ? 1 : 0;
  single = abs(float environment("latlong.exr"[2], d, "width", 0) - comp(wanted, 2)) < 0.01 ? 1 : 0;
  nowhere = environment("latlong.exr", vector(0));
  // A filter as wide as the directions' distance, away from the poles, is not far off.
  off = color environment("latlong.exr", d) - wanted;
  filtered = abs(d[2]) > 0.9 || max(abs(comp(off, 0)), abs(comp(off, 1)), abs(comp(off, 2))) < 0.1 ? 1 : 0;
  // Blurred widely, all is grey.
  wide = abs(float environment("latlong.exr", d, "blur", 1) - 0.5) <= abs(comp(wanted, 0) - 0.5) + 0.01 ? 1 : 0;
  corners = float environment("latlong.exr", d, d, d, d) - float environment("latlong.exr", d, "width", 0);
}
