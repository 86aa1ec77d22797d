/* A variable is 0 before anything is assigned to it. It gets that where it is first used, not at the shader's start, and as a store that
gives all of it: else each of the thousands of intermediate results in a large shader would be alive in all of it, and in every round of
its loops, and linking would take minutes.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc -o %t.so --width 1,8 --dump-after lower > %t.ll && FileCheck %s < %t.ll
RUN: not grep memset %t.ll
RUN: anysl-link %t.stc.bc -o %t.so --width 1,8
RUN: anysl-shade %t.so --grid 9x1 --width 1 --print sum --json | FileCheck %s --check-prefix VALUES
RUN: anysl-shade %t.so --grid 9x1 --width 8 --print sum --json | FileCheck %s --check-prefix VALUES
RUN: anysl-link %t.stc.bc --runtime scalar --real double -o %t.double.so --width 1
RUN: anysl-shade %t.double.so --grid 9x1 --print sum --json | FileCheck %s --check-prefix VALUES

CHECK-LABEL: @first.body(
CHECK: [[LAST:%last]] = alloca
CHECK: [[TEMPORARY:%[0-9]+]] = alloca
CHECK-NOT: store {{.*}} [[LAST]],
CHECK: loaded:
What an earlier round leaves is read in the next one, so this is set in front of the loop:
CHECK: store {{.*}} zeroinitializer, ptr [[LAST]],
CHECK: loop:
CHECK: then:
An operator's result is set just before it:
CHECK: store {{.*}} zeroinitializer, ptr [[SUM:%[0-9]+]],
CHECK-NEXT: call void @anysl_add_color(ptr [[SUM]],

In a loop, what is read is what the last round has left: 0 + 1 + 2 + 3, plus as often 0 for what no round has set.
VALUES: "sum":{{\[\[}}6,6,6],[6,6,6],[6,6,6],[6,6,6],[6,6,6],[6,6,6],[6,6,6],[6,6,6],[6,6,6]]
*/
surface first(output varying color sum = 0;) {
  float i;
  color last;
  for (i = 0; i < 4; i += 1) {
    if (i >= 0) {
      color never;
      sum += last + never;
      last = color(i + 1);
      if (i > 4)
        never = 1;
    }
  }
}
