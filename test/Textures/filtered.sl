// Stripes one texel wide, seen from points fifteen texels apart: where numbers carry derivatives, the filter covers what
// lies between the points, and shows their mean.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: printf 'surface make() { Ci = mod(floor(63 * u + 0.5), 2); }' > make.sl && rslc make.sl && anysl-link make.stc.bc --width 4
// RUN: anysl-shade make.so --grid 64x64 -o stripes.exr
// RUN: %shade_everywhere %s %t/filtered
// ARGS: --grid 5x5 --ramp s=0.0234375:0.9609375:x
// REALS: float

// EXPECT near: 1
// EXPECT narrow: 0
// EXPECT sharp: 0.5

surface filtered(output varying float near = 0, narrow = 1, sharp = 0) {
  near = abs(float texture("stripes.exr", s, 0.5, "wrap", "periodic") - 0.5) < 0.02 ? 1 : 0;
  // A hundredth of the distance between the points is less than a texel, and shows its value.
  narrow = float texture("stripes.exr", s, 0.5, "width", 0.01) - float texture("stripes.exr", s, 0.5, "width", 0);
  sharp = abs(float texture("stripes.exr", s, 0.5, "width", 0) - 0.5);
}
