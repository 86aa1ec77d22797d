// RUN: rslc -S -o - %s -DFROM_LINE=7 -D FLAG | FileCheck %s

#define PLAIN 11
#define ADD(a, b) ((a) + (b))
#define NEST(x) ADD(x, PLAIN)
#define STRING(x) #x
#define GLUE(a, b) a##b
#define EMPTY
#define SELF SELF
#define MANY(first, ...) first + ADD(__VA_ARGS__)
#define SPLICED 2 \
                * 3
#define NOT_CALLED(x) x

surface macros() {
  float SELF = 1;
  float ab = 5;
  // CHECK: double 1.300000e+01
  // CHECK: double 1.100000e+01
  // CHECK: anysl_add_float
  Ci = NEST(13) EMPTY;
  // CHECK: copy_color(ptr %Ci
  // CHECK: splat_color(ptr %{{.*}}, ptr %ab)
  Ci = GLUE(a, b);
  // CHECK: double 2.000000e+00
  // CHECK: double 3.000000e+00
  // CHECK: mul_float
  Oi = SPLICED;
  // CHECK: double 7.000000e+00
  // CHECK: double 1.000000e+00
  Oi = FROM_LINE + FLAG + MANY(SELF, 4, 5);
  // A name without arguments is no use of the macro.
  float NOT_CALLED = 1;
  Oi = NOT_CALLED;
  // CHECK: call void @anysl_const_string(ptr %{{.*}}, ptr @text)
  string s = STRING(a "b" + 'c');
  if (s == "")
    Oi = __LINE__;
  // CHECK: double 3.800000e+01
}
