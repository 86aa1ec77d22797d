// printf prints once for each point that reaches it, a whole line each time, whatever the width.
// RUN: rslc %s -o %t.bc
// RUN: anysl-link %t.bc --runtime packet --width 1,4,8,16 -o %t.packet.so
// RUN: anysl-link %t.bc --runtime scalar --real double --width 1,4,8,16 -o %t.scalar.so
// RUN: anysl-shade %t.packet.so --grid 5x2 --width 1 --print Ci > %t.1
// RUN: FileCheck %s --match-full-lines < %t.1
// RUN: sort %t.1 > %t.sorted
// RUN: for w in 4 8 16; do anysl-shade %t.packet.so --grid 5x2 --width $w --print Ci | sort | cmp - %t.sorted || exit 1; done
// RUN: for w in 1 8; do anysl-shade %t.scalar.so --grid 5x2 --width $w --print Ci | sort | cmp - %t.sorted || exit 1; done
// What is printed does not disturb JSON.
// RUN: anysl-shade %t.packet.so --grid 5x2 --json --print Ci 2> %t.messages | python3 -m json.tool > %t.json
// RUN: grep -c uniform %t.messages | grep -x 10
void report(string what; float x) { printf("%s %.2f\n", what, x); }

surface print(float Kd = 0.5) {
  float column = floor(s * 4 + 0.5);
  if (column == 1)
    printf("point %p, %d%%\n", P, column * 25);
  else if (column > 2)
    report(column > 3 ? "last" : "fourth", t);
  float i;
  for (i = 0; i < column; i += 2)
    printf("row %d column %d step %g\n", t, column, i);
  printf("uniform %g\n", Kd);
  Ci = column;
}
// CHECK:      uniform 0.5
// CHECK-NEXT: point 0.250000 0.000000 0.000000, 25%
// CHECK-NEXT: row 0 column 1 step 0
// CHECK-NEXT: uniform 0.5
// CHECK-NEXT: row 0 column 2 step 0
// CHECK-NEXT: uniform 0.5
// CHECK-NEXT: fourth 0.00
// CHECK-NEXT: row 0 column 3 step 0
// CHECK-NEXT: row 0 column 3 step 2
// CHECK-NEXT: uniform 0.5
// CHECK-NEXT: last 0.00
// CHECK-NEXT: row 0 column 4 step 0
// CHECK-NEXT: row 0 column 4 step 2
// CHECK-NEXT: uniform 0.5
// CHECK-NEXT: uniform 0.5
// CHECK-NEXT: point 0.250000 1.000000 0.000000, 25%
// CHECK-NEXT: row 1 column 1 step 0
// CHECK-NEXT: uniform 0.5
// CHECK-COUNT-3: uniform 0.5
// CHECK-NEXT: 0 0  Ci 0 0 0
