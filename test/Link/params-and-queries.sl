/* Questions have numbers, as the cells of parameters do; making a parameter a constant leaves them alone.

RUN: rslc %s -o %t.stc.bc && anysl-link %t.stc.bc --width 1,4 -o %t.so && anysl-shade %t.so --width 1 | FileCheck %s
RUN: anysl-link %t.stc.bc --width 1,4 --param values=1,2,3,4,5,6,7,8,9,10,11,12 --param a=1 --param b=1 --param c=1 -o %t.fixed.so && anysl-shade %t.fixed.so --width 1 | FileCheck %s && anysl-shade %t.fixed.so --width 4 | FileCheck %s
RUN: echo '{"complete": true, "shaders": {"asks": {"complete": true}}}' > %t.json
RUN: anysl-link %t.stc.bc --width 1,4 --scene %t.json -o %t.scene.so && anysl-shade %t.scene.so --width 1 | FileCheck %s && anysl-shade %t.scene.so --width 4 | FileCheck %s

Nothing answers here, so that every question leaves its variable alone. 1 + 2 + ... + 12 is 78; four colors add 4, and four times the scale 8.
CHECK: Ci 90 7 12
*/

surface asks(float scale = 2; color a = 1, b = 1, c = 1, d = 1; float values[12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};) {
  float sum = 0, i, found = 0, left = 7;
  for (i = 0; i < 12; i += 1) sum += values[i];
  found += surface("none", left) + displacement("none", left) + atmosphere("none", left) + incident("none", left)
           + opposite("none", left) + attribute("none", left) + option("none", left) + rendererinfo("none", left)
           + rayinfo("none", left) + textureinfo("none.tex", "none", left);
  Ci = color(sum + comp(a + b + c + d, 1) + 4 * scale + found, left, values[11]);
  Oi = 1;
}
