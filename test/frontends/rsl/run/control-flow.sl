// What the language's control flow computes, alone and eight points at once. s is 0, 0.25, 0.5, 0.75, 1.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 5x1 --width 1 --print loops --print nested --print chosen --print early --print effects > %t.1
// RUN: anysl-shade %t.so --grid 5x1 --width 8 --print loops --print nested --print chosen --print early --print effects > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8

float firstAbove(float limit) {
  float x = 1;
  while (x < 100) {
    if (x > limit)
      return x;
    x *= 2;
  }
  return -1;
}

surface controlflow(output varying float loops = 0, nested = 0, chosen = 0, early = 0, effects = 0) {
  // The sum of 1 … n without 3, n = 4 s + 1.
  float i;
  for (i = 1; i <= 4 * s + 1; i += 1) {
    if (i == 3)
      continue;
    loops += i;
  }
  // Leaves both loops where i j = 4 s.
  float a, b;
  for (a = 0; a < 3; a += 1) {
    for (b = 0; b < 3; b += 1) {
      nested += 1;
      if (a * b == 4 * s && a > 0)
        break 2;
      if (b == 1)
        continue 2;
    }
  }
  chosen = s < 0.5 ? (s == 0 ? 10 : 20) : s > 0.5 && s < 1 || s == 2 ? 30 : 40;
  early = firstAbove(10 * s);
  // An assignment is a value; the left operand is the old one.
  float x = s;
  effects = x + (x = 2) * x;
}

// CHECK:      0 0  loops 1 nested 3 chosen 10 early 1 effects 4
// CHECK-NEXT: 1 0  loops 3 nested 4 chosen 20 early 4 effects 4.25
// CHECK-NEXT: 2 0  loops 3 nested 6 chosen 40 early 8 effects 4.5
// CHECK-NEXT: 3 0  loops 7 nested 6 chosen 30 early 8 effects 4.75
// CHECK-NEXT: 4 0  loops 12 nested 6 chosen 40 early 16 effects 5
