// A displacement out of a picture that rises evenly says how steep the surface has become, and turns the normal.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: printf 'surface flat() { Ci = s; }' > flat.sl && rslc flat.sl && anysl-link flat.stc.bc --width 4
// RUN: anysl-shade flat.so --grid 16x16 --ramp s=0.03125:0.96875:x -o flat.exr
// RUN: %shade_everywhere %s %t/displaced
// PARAM: --tangents
// ARGS: --grid 7x3 --ramp s=0.25:0.75:x --ramp t=0.25:0.75:y
// REALS: float
// EXPECT dPdu: 1 0 1
// EXPECT dPdv: 0 1 0
// EXPECT turned: 0 0 0
displacement displaced(output varying vector turned = 1) {
  P += 2 * float texture("flat.exr", s, t) * normalize(N);
  N = calculatenormal(P);
  turned = normalize(vector(-1, 0, 1)) - N;
}
