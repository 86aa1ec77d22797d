// A point's random numbers depend on nothing but its place in the grid: not on the width, nor on how the grid is
// cut into batches (300 x 20 points take two), nor on what other points do.
//
// RUN: rslc %s -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --width 1,4,16 -o %t.so
// RUN: python3 %S/Inputs/at-every-width.py %t.so -- --grid 300x20 --print Ci --print taken > %t.txt
// RUN: python3 %S/Inputs/check-random.py %t.txt

surface random_numbers(output varying float taken = 0;) {
  float i;
  float sum = 0;
  // A different number of draws in neighbouring points.
  for (i = 0; i <= mod(floor(s * 299 + 0.5), 3); i += 1) {
    sum += float random();
    taken += 1;
  }
  Ci = color(sum / taken, float random(), 0);
}
