// A lookup covers what its coordinates change from point to point: 4 x 4 texels, black and white in turn along s, seen
// from points that lie a whole picture apart, are grey; seen nearby they are what they are.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: oiiotool --pattern constant:color=0 1x4 1 --pattern constant:color=1 1x4 1 --pattern constant:color=0 1x4 1 --pattern constant:color=1 1x4 1 --mosaic 4x1 -d float -o stripes.exr
// RUN: %shade_everywhere %s %t/footprint
// ARGS: --grid 3x3 --set s=0.375 --set t=0.5 --set du=1 --set dv=1
// REALS: float
// EXPECT sharp: 1
// EXPECT wide: 1
// EXPECT along: 1
surface footprint(output varying float sharp = 0, wide = 0, along = 0) {
  sharp = abs(float texture("stripes.exr", s, t, "width", 0) - 1) < 0.01 ? 1 : 0;
  wide = abs(float texture("stripes.exr", s, t, "wrap", "periodic") - 0.5) < 0.2 ? 1 : 0;
  // Along t nothing changes, however wide the filter is.
  along = abs(float texture("stripes.exr", 0.375, t, "wrap", "periodic") - 1) < 0.01 ? 1 : 0;
}
