// Varying parameters of every shape, arrays among them, come from --set and --ramp in the library's own layout,
// and output parameters go back.
//
// RUN: rslc %s -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --runtime packet --width 1,4,8,16 -o %t.packet.so
// RUN: anysl-link %t.stc.bc --runtime scalar --width 1,8 -o %t.float.so
// RUN: anysl-link %t.stc.bc --runtime scalar --real double --width 1,8 -o %t.double.so
// RUN: python3 %S/Inputs/at-every-width.py %t.packet.so %t.float.so %t.double.so -- --grid 3x3 \
// RUN:   --ramp weight=1,2,3:5,2,-1:x --ramp tint=1,0,0:0,1,0:y --set shift=10 --set spots=1,2,3,4,5,6 \
// RUN:   --print Ci --print sums --print spot | FileCheck %s
// CHECK:      0 0 Ci 11 0 0 sums 6 16 spot 5 7 9
// CHECK-NEXT: 1 0 Ci 13 0 0 sums 6 16 spot 5 7 9
// CHECK-NEXT: 2 0 Ci 15 0 0 sums 6 16 spot 5 7 9
// CHECK-NEXT: 0 1 Ci 5.5 5.5 0 sums 6 16 spot 5 7 9
// CHECK:      2 2 Ci 0 15 0 sums 6 16 spot 5 7 9
//
// Unbound, they have the instance's value, or the default.
// RUN: python3 %S/Inputs/at-every-width.py %t.packet.so %t.float.so %t.double.so -- --grid 3x3 --param tint=0.5,1,2 \
// RUN:   --print Ci --print sums | FileCheck %s --check-prefix=DEFAULT
// DEFAULT: 2 1 Ci 0.625 1.25 2.5 sums 3 3.25

surface varying_parameters(varying float weight[3] = {1, 1, 1}; varying color tint = 1; varying float shift = 0.25;
                           varying point spots[2] = {0, 0};
                           output varying float sums[2] = {0, 0}; output varying point spot = 0;) {
  sums[0] = weight[0] + weight[1] + weight[2];
  sums[1] = sums[0] + shift;
  spot = spots[0] + spots[1];
  Ci = tint * (weight[0] + shift);
}
