// --plain-operators: the formulas of textbooks, which are right where nothing is hard, and nowhere else.
// RUN: rslc %s -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --width 1,8 -o %t.guarded.so && anysl-link %t.stc.bc --width 1,8 --plain-operators -o %t.plain.so
// RUN: anysl-shade %t.guarded.so --grid 2x1 --print easy --print zero --print domain --print quotient | FileCheck %s --check-prefixes=EASY,GUARDED
// RUN: anysl-shade %t.plain.so --grid 2x1 --print easy --print zero --print domain --print quotient | FileCheck %s --check-prefixes=EASY,PLAIN
// RUN: anysl-shade %t.plain.so --width 1 --grid 2x1 --print easy --print zero --print domain --print quotient | FileCheck %s --check-prefixes=EASY,PLAIN
// EASY: 0 0 {{ *}}easy 0.6000{{[0-9]*}} 0 0.8000{{[0-9]*}}
// GUARDED-SAME: {{ *}}zero 0 0 0 {{ *}}domain 0 {{ *}}quotient 0
// PLAIN-SAME: {{ *}}zero NaN NaN NaN {{ *}}domain NaN {{ *}}quotient Infinity
//
// Derivatives are guarded only.
// RUN: rslc -DDERIVATIVE=1 %s -o %t.dual.stc.bc && not anysl-link %t.dual.stc.bc --plain-operators -o %t.dual.so 2>&1 | FileCheck %s --check-prefix=DUAL
// DUAL: error: there are no plain operators for real 'dual'

surface plain(output varying vector easy = 0; output varying vector zero = 0; output varying float domain = 0;
              output varying float quotient = 0;) {
  easy = normalize(vector(3, 0, 4) * (1 + s));
  zero = normalize(vector(s, 0, 0) * 0);
  domain = sqrt(-1 - s);
  quotient = (1 + s) / (0 * s);
#ifdef DERIVATIVE
  easy = Du(P);
#endif
  Ci = 1;
}
