/* transform("space", matrix, p) takes a point of the space to "current", then by the matrix. The space "moved" is 10 to the
   right and twice as large; the matrix turns x into y.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1,8 -o %t.so
RUN: anysl-shade %t.so --grid 1x1 --width 1 --space moved=2,0,0,0,0,2,0,0,0,0,2,0,10,0,0,1 | FileCheck %s
RUN: anysl-shade %t.so --grid 1x1 --width 8 --space moved=2,0,0,0,0,2,0,0,0,0,2,0,10,0,0,1 | FileCheck %s

CHECK: Ci 12 0 6  Oi 2 0 6
*/
surface transforms() {
  matrix m = (0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  point p = transform("moved", m, point(0, 1, 3));
  Ci = color(p[1] + p[0], 0, p[2]);
  Ci = Ci * (ptransform("moved", m, point(0, 1, 3)) == p ? 1 : 0); // by an older name
  vector v = vtransform("moved", m, vector(1, 0, 3));
  Oi = color(v[1], v[0], v[2]);
}
