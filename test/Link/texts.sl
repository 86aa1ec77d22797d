/* What compares texts that are constants is decided when linking: a library function that is told by text what to do is a copy for that
text, without the rest.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc -o %t.so --width 8 --dump-after texts | FileCheck %s
RUN: anysl-link %t.stc.bc -o %t.so --width 8 --param asked.space=xyY --dump-after texts | FileCheck %s --check-prefix PARAM
RUN: anysl-link %t.stc.bc -o %t.so --width 1,8
RUN: anysl-shade %t.so --grid 2x1 --shader asked --width 1 --print known --print same --print Ci --json | FileCheck %s --check-prefix VALUES
RUN: anysl-shade %t.so --grid 2x1 --shader asked --width 8 --print known --print same --print Ci --json | FileCheck %s --check-prefix VALUES

CHECK-LABEL: define internal void @asked.body(
CHECK: call void @"anysl_ctransform.1=rgb.2=hsv"(
The same texts, the same copy:
CHECK: call void @"anysl_ctransform.1=rgb.2=hsv"(
Of one text that is known, too:
CHECK: call void @"anysl_ctransform.1=rgb"(
CHECK-NOT: @anysl_eq_string
CHECK: call i1 @anysl_ne_string(
CHECK-NOT: @anysl_eq_string
CHECK: ret void
CHECK: define internal void @"anysl_ctransform.1=rgb.2=hsv"(
CHECK-NOT: @anysl_eq_string
CHECK: ret void

PARAM: call void @"anysl_ctransform.1=rgb.2=xyY"(

Of (0.5, 0.25, 0), the hue is 30 degrees, the saturation 1 and the value 0.5.
VALUES: "known":{{\[\[0.083333[0-9]*}},1,0.5],
VALUES: "same":[3,3]
VALUES: "Ci":{{\[\[0.083333[0-9]*}},1,0.5]
*/
surface asked(uniform string space = "hsv"; output varying color known = 0; output varying float same = 0;) {
  string wanted = "hsv";
  color orange = color(0.5, 0.25, 0);
  known = ctransform("rgb", "hsv", orange);
  known = 0.5 * (known + ctransform("rgb", wanted, orange));
  Ci = ctransform("rgb", space, orange);
  if (wanted == "hsv" && "a" != "b")
    same = 1;
  if (wanted == "xyz")
    same = 10;
  if (space != "hsv")
    same += 20;
  else
    same += 2;
}
