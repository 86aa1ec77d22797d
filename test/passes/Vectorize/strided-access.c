// Members of records are read and written as whole vectors and shuffles: all members together, some of
// them, or one alone. What leaves a member out is stored under a constant mask.
//
// RUN: clang -O1 -march=x86-64-v3 -fopenmp-simd -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<verify>' %t.bc -o %t.wide.bc
// RUN: llvm-dis %t.wide.bc -o - | FileCheck %s
// RUN: clang -O2 %t.wide.bc -o %t.run
// RUN: %if avx512 %{ %t.run %}
//
// CHECK-LABEL: define {{.*}}@_ZGVeN16uul_turn3(
// CHECK-NOT: masked.
// CHECK: ret void
// CHECK-LABEL: define {{.*}}@_ZGVeN16uul_some(
// CHECK-NOT: masked.gather
// CHECK-NOT: masked.scatter
// CHECK: call void @llvm.masked.store.v16f32.p0({{.*}} <16 x i1> <i1 true, i1 false, i1 false, i1 false, i1 true,
// CHECK-NOT: masked.scatter
// CHECK: ret void
#include <stdio.h>

#define WIDE(isa, width, name)                                                                     \
  void name##isa(const float *in, float *out, int i) __asm__("_ZGV" #isa "N" #width "uul_" #name);
#define ALL(name) WIDE(b, 4, name) WIDE(d, 8, name) WIDE(e, 16, name)

ALL(turn2) ALL(turn3) ALL(turn4) ALL(some) ALL(shorts)

static float in[256], wide[256], scalar[256];

typedef void Kernel(const float *, float *, int);

static int differs(const char *name, Kernel *one, Kernel *many, int width) {
  for (int k = 0; k < 256; ++k)
    in[k] = (float)k + 0.5f, wide[k] = scalar[k] = -1;
  for (int i = 0; i < 32; ++i)
    one(in, scalar, i);
  for (int i = 0; i < 32; i += width)
    many(in, wide, i);
  for (int k = 0; k < 256; ++k)
    if (wide[k] != scalar[k]) {
      printf("%s, %d lanes: %g instead of %g at %d\n", name, width, wide[k], scalar[k], k);
      return 1;
    }
  return 0;
}

#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void turn3(const float *in, float *out, int i) {
  float x = in[3 * i], y = in[3 * i + 1], z = in[3 * i + 2];
  out[3 * i] = z;
  out[3 * i + 1] = x;
  out[3 * i + 2] = y;
}
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void turn2(const float *in, float *out, int i) {
  float x = in[2 * i], y = in[2 * i + 1];
  out[2 * i + 1] = x;
  out[2 * i] = y;
}
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void turn4(const float *in, float *out, int i) {
  float x = in[4 * i], y = in[4 * i + 1], z = in[4 * i + 2], w = in[4 * i + 3];
  out[4 * i] = z;
  out[4 * i + 2] = w;
  out[4 * i + 1] = y;
  out[4 * i + 3] = x;
}
/// Not all members are written, and one is read alone.
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void some(const float *in, float *out, int i) {
  float y = in[3 * i + 1];
  out[4 * i + 3] = y;
  out[4 * i] = in[4 * i] - in[4 * i + 2];
}
#pragma omp declare simd notinbranch uniform(in, out) linear(i : 1)
void shorts(const float *in, float *out, int i) {
  const short *from = (const short *)in;
  short *to = (short *)out;
  short a = from[3 * i + 2], b = from[3 * i], c = from[3 * i + 1];
  to[3 * i] = a;
  to[3 * i + 2] = b;
  to[3 * i + 1] = c;
}

#define TRY(name)                                                                                  \
  differs(#name, name, name##b, 4) | differs(#name, name, name##d, 8) |                            \
      differs(#name, name, name##e, 16)

int main(void) { return TRY(turn2) | TRY(turn3) | TRY(turn4) | TRY(some) | TRY(shorts); }
