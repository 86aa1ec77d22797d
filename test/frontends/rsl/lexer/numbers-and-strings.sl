// Spellings of numbers and strings, and what is no word at all.
// RUN: rslc -S -o - %s | FileCheck %s

surface words() {
  // CHECK-DAG: double 1.000000e+00
  // CHECK-DAG: double 5.000000e-01
  // CHECK-DAG: double 2.500000e+02
  // CHECK-DAG: double 1.250000e-02
  // CHECK-DAG: double 3.100000e+01
  float a = 1., b = .5, c = 2.5e2, d = 1.25E-2, e = 0x1f;
  /* a comment /* does not nest */
  // CHECK-DAG: c"a\0Ab\22c\\\00"
  // CHECK-DAG: c"joined\00"
  string s1 = "a\nb\"c\\", s2 = "join" "ed";
  // a line spl\
iced comment: this is no code!
  Ci = a + b + c + d + e;
  if (s1 == s2)
    Ci = 0;
}
