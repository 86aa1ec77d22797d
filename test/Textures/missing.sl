/* A file that cannot be read: one warning, however many points ask, and something to see.
RUN: rm -rf %t && mkdir %t && cd %t && rslc %s -o a.stc.bc && anysl-link a.stc.bc --width 1,8 -o a.so
RUN: echo nonsense > broken.exr
RUN: anysl-shade a.so --grid 16x16 --width 8 --print Ci --print filled > out 2> warnings
RUN: FileCheck %s --check-prefix=WARN < warnings
WARN-DAG: anysl-shade: warning: cannot read texture 'nowhere.exr': {{.*}}
WARN-DAG: anysl-shade: warning: cannot read texture 'broken.exr': {{.*}}
WARN-DAG: anysl-shade: warning: a texture has no name
WARN-DAG: anysl-shade: warning: cannot read texture 'nomap.exr'
RUN: grep -c warning warnings | FileCheck %s --check-prefix=COUNT
COUNT: {{^}}4{{$}}
Squares of magenta and black, an eighth of the picture wide.
RUN: FileCheck %s < out
CHECK: 0 0  Ci 1 0 1  filled 0.5 0.5 0.5
CHECK: 2 0  Ci 0 0 0  filled 0.5 0.5 0.5
CHECK: 2 2  Ci 1 0 1  filled 0.5 0.5 0.5
RUN: anysl-shade a.so --grid 16x16 --width 1 --print Ci --print filled 2> /dev/null | diff - out
*/
surface missing(output varying color filled = 0) {
  Ci = texture("nowhere.exr", s, t);
  filled = texture("broken.exr", s, t, "fill", 0.5);
  filled += float texture("", s, t, "fill", 0) + shadow("nomap.exr", P) + color environment("nowhere.exr", N, "fill", 0);
}
