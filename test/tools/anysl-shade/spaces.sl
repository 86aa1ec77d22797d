// --space names coordinate systems. "room" is twice as large and stands at (1, 2, 3); "hall" is turned by a right
// angle about z and stands at (5, 0, 0). Which one `a` is seen in differs from point to point.
//
// RUN: rslc %s -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --runtime packet --width 1,4,8,16 -o %t.packet.so
// RUN: anysl-link %t.stc.bc --runtime scalar --real double --width 1,4,8 -o %t.scalar.so
// RUN: python3 %S/Inputs/at-every-width.py %t.packet.so %t.scalar.so -- --grid 5x2 --set N=1,2,3 \
// RUN:   --space room=2,0,0,0,0,1,0,0,0,0,1,0,1,2,3,1 --space hall=0,1,0,0,-1,0,0,0,0,0,1,0,5,0,0,1 \
// RUN:   --print a --print b --print c --print d | FileCheck %s
//
// From the current space a point loses the origin, then is turned back and made smaller: (x, y, z) is
// ((x - 1) / 2, y - 2, z - 3) in the room and (y, 5 - x, z) in the hall. A normal goes the other way round.
// CHECK:      0 0 a -0.5 -2 -3 b 0 0 0 c 2 -0.5 3 d 3 4 6
// CHECK-NEXT: 1 0 a -0.375 -2 -3 b 0.125 0 0 c 2 -0.5 3 d 3 4 6
// CHECK-NEXT: 2 0 a 0 4.5 0 b 0.25 0 0 c 2 -0.5 3 d 3 4 6
// CHECK:      4 0 a 0 4 0 b 0.5 0 0 c 2 -0.5 3 d 3 4 6
// CHECK:      0 1 a -0.5 -1 -3 b 0 1 0 c 2 -0.5 3 d 3 4 6
// CHECK:      4 1 a 1 4 0 b 0.5 1 0 c 2 -0.5 3 d 3 4 6

surface spaces(output varying point a = 0; output varying vector b = 0; output varying normal c = 0;
               output varying point d = 0;) {
  string name = "room";
  if (s > 0.4)
    name = "hall";
  a = transform(name, P);
  b = vtransform("room", vector(P));
  c = ntransform("room", "hall", N);
  d = point "room" (1, 2, 3);
  Ci = Cs;
}
