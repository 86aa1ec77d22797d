// Parameters of shaders whose length the host decides: given when instancing, or fixed when linking.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 1x1 --print a --print b --print c | FileCheck %s --check-prefix=NONE
// RUN: anysl-shade %t.so --grid 1x1 --param list=1,2,3 --param names=x,y --param tints=1,2,3,4,5,6 --width 1 --print a --print b --print c | FileCheck %s --check-prefix=GIVEN
// RUN: anysl-shade %t.so --grid 1x1 --param list=1,2,3 --param names=x,y --param tints=1,2,3,4,5,6 --width 8 --print a --print b --print c | FileCheck %s --check-prefix=GIVEN
// RUN: anysl-link %t.bc -o %t.fixed.so --width 8 --param list=1,2,3 --param names=x,y --param tints=1,2,3,4,5,6
// RUN: anysl-shade %t.fixed.so --grid 1x1 --print a --print b --print c | FileCheck %s --check-prefix=GIVEN
// RUN: not anysl-shade %t.so --grid 1x1 --param tints=1,2 2>&1 | FileCheck %s --check-prefix=PART

float sum(float list[]) {
  float total = 0;
  uniform float i;
  for (i = 0; i < arraylength(list); i += 1)
    total += list[i];
  return total;
}
surface arrayparameters(uniform float list[] = {}; string names[] = {}; color tints[] = {}; float fixed[] = {5, 6};
                        output varying float a = 0, b = 0, c = 0) {
  a = arraylength(list) * 100 + sum(list);
  b = arraylength(names) * 10 + (names[1] == "y");
  color last = 0;
  if (arraylength(tints) > 0)
    last = pop(tints);
  c = comp(last, 0) * 100 + arraylength(tints) * 10 + arraylength(fixed);
}

// NONE: a 0 b 0 c 2
// GIVEN: a 306 b 21 c 412
// PART: parameter 'tints' is a color[64] and takes 192 values, not 2
