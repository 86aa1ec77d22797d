// Where lanes leave a loop with its counter, it is counted in each of
// them, if there are no mask registers.
//
// RUN: clang -O1 -fno-math-errno -fopenmp-simd -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<verify>' %t.bc -o %t.wide.bc
// RUN: llvm-dis %t.wide.bc -o - | FileCheck %s
// RUN: clang -O2 %t.wide.bc -o %t.run
// RUN: %if avx512 %{ %t.run %}
// RUN: clang -O3 -fno-math-errno -fopenmp-simd -fno-vectorize -emit-llvm -c %s -o %t.3.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<verify>' %t.3.bc -o %t.wide3.bc
// RUN: clang -O2 %t.wide3.bc -o %t.run
// RUN: %if avx512 %{ %t.run %}
//
// CHECK-LABEL: define {{.*}}@_ZGVdN8uul_escape(
// CHECK: [[KEPT:%.*]] = phi <8 x i32> [ {{.*}} ], [ [[NEXT:%.*]], %{{.*}} ]
// CHECK: [[NEXT]] = sub <8 x i32> [[KEPT]], {{%.*}}
// CHECK-NOT: select <8 x i1> {{.*}} <8 x i32>
// CHECK: ret void
#include <stdio.h>

#define WIDE(isa, width, name)                                                                     \
  void name##isa(const float *in, float *out, int i) __asm__("_ZGV" #isa "N" #width "uul_" #name);
#define ALL(name) WIDE(b, 4, name) WIDE(d, 8, name) WIDE(e, 16, name)
ALL(escape)
ALL(unrolled) ALL(twos) ALL(from) ALL(conditional)

/// The end of the loop, and the place at which data leaves it.
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
    void escape(const float *in, float *out, int i) {
  float x = in[i];
  int k = 0;
  while (x < 100) {
    x = x * 1.5f + 1;
    ++k;
  }
  out[i] = (float)k;
}
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void unrolled(const float *in, float *out, int i) {
  float x = in[i];
  int k = 0;
#pragma clang loop unroll_count(4)
  for (; k < 32; ++k) {
    if (x > 100)
      break;
    x = x * 1.125f + 0.5f;
  }
  out[i] = (float)k;
}
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void twos(const float *in, float *out, int i) {
  float x = in[i];
  unsigned k = 7;
  for (; k < 60; k += 2) {
    x = x * 1.125f + 0.5f;
    if (x > 50)
      break;
    x += 1;
    if (x > 100) {
      k += 5;
      break;
    }
  }
  out[i] = (float)k;
}
/// The counter starts at what is known only when it runs, and goes down.
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void from(const float *in, float *out, int i) {
  float x = in[i];
  int k = (int)in[255];
  while (k > -3 && x < 100) {
    x = x * 1.25f + 1;
    --k;
  }
  out[i] = (float)k;
}
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void conditional(const float *in, float *out, int i) {
  float x = in[i];
  int k = -1;
  if (x > 3) {
    k = 0;
    while (k < 20) {
      x = x * 1.25f + 1;
      if (x > 200)
        break;
      ++k;
    }
  }
  out[i] = (float)k + x;
}

static float in[256], wide[256], scalar[256];
typedef void Kernel(const float *, float *, int);

static int differs(const char *name, Kernel *one, Kernel *many, int width) {
  for (int k = 0; k < 256; ++k)
    in[k] = (float)((k * 37 + k / 16) % 120), wide[k] = scalar[k] = -1;
  in[255] = 9;
  for (int i = 0; i < 256; ++i)
    one(in, scalar, i);
  for (int i = 0; i < 256; i += width)
    many(in, wide, i);
  for (int k = 0; k < 256; ++k)
    if (wide[k] != scalar[k]) {
      printf("%s, %d lanes: %g instead of %g at %d\n", name, width, wide[k], scalar[k], k);
      return 1;
    }
  return 0;
}

#define TRY(name)                                                                                  \
  differs(#name, name, name##b, 4) | differs(#name, name, name##d, 8) |                            \
      differs(#name, name, name##e, 16)

int main(void) { return TRY(escape) | TRY(unrolled) | TRY(twos) | TRY(from) | TRY(conditional); }
