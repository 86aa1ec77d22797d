/* With the real interval, a shader's numbers have bounds; conditions that they do not decide are noted with their line.

RUN: rslc %s -o %t.stc.bc
RUN: not anysl-link %t.stc.bc --runtime scalar --real interval --width 4 -o %t.so 2>&1 | FileCheck %s --check-prefix WIDTH
WIDTH: error: real 'interval' shades one point at a time: there is no width 4 (link it with --width 1)
RUN: anysl-link %t.stc.bc --runtime scalar --real interval -o %t.so
RUN: anysl-shade %t.so --grid 11x1 --print Ci > %t.txt 2> %t.notes
RUN: FileCheck %s < %t.notes

The first sum is 1 in exact arithmetic, and its bounds are on both sides of 1; the second is far from 2.
CHECK: interval.sl:[[@LINE+11]]:{{[0-9]+}}: lt_float({{(1|0.99999.*|1.00000.*)}}, 1) is not decided, and taken as {{[01]}}, in shader 'undecided' at point 0, and 10 more
CHECK-NOT: {{.}}

Middles are what float gives, or next to it.
RUN: anysl-link %t.stc.bc --runtime scalar --width 1 -o %t.float.so && anysl-shade %t.float.so --grid 11x1 --print Ci > %t.float.txt
RUN: python3 -c "import sys; a, b = ([float(x) for x in open(f).read().split() if x[0] in '-.0123456789'] for f in sys.argv[1:]); sys.exit(not a or len(a) != len(b) or any(abs(x - y) > 1e-5 for x, y in zip(a, b)))" %t.txt %t.float.txt
*/

surface undecided() {
  float tenth = (s + 1) / ((s + 1) * 10), sum = tenth * 3 + tenth * 7;
  Ci = sum;
  if (sum < 1)
    Ci += 0;
  if (sum < 2)
    Ci += color(noise(s), sin(s), 0);
}
