// Where the processor knows no masks, loads and stores under one come in two forms: plain ones for when all lanes are active,
// and for each lane by itself, without a jump. Where it does, nothing would be gained.
// REQUIRES: avx2
// RUN: clang -O1 -msse4.2 -fopenmp-simd -emit-llvm -c %s -o %t.sse.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=4;verify>' %t.sse.bc -S -o %t.sse.ll
// RUN: FileCheck %s < %t.sse.ll
// RUN: clang -O1 -mavx2 -fopenmp-simd -emit-llvm -c %s -o %t.avx2.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' %t.avx2.bc -S | FileCheck --check-prefix=NATIVE %s
//
// Whatever lanes are active, they and nobody else store.
// RUN: clang -O2 -msse4.2 -fopenmp-simd -DMAIN -c %s -o %t.main.o
// RUN: clang -O2 -c -x ir %t.sse.ll -o %t.wide.o
// RUN: clang %t.main.o %t.wide.o -o %t && %t

#ifndef MAIN
// CHECK-LABEL: define {{.*}} @_ZGVbN4uuluv_scale(
// CHECK: icmp eq i4 %{{.*}}, -1
// CHECK: all:
// CHECK: load <4 x float>, ptr %
// CHECK: store <4 x float> %
// CHECK: br label %joined
// CHECK: some:
// CHECK: select <4 x i1> %{{.*}}, <4 x ptr>
// CHECK: call <4 x float> @llvm.masked.gather{{.*}}<4 x i1> {{(splat \(i1 true\)|<i1 true)}}
// CHECK: joined:
// CHECK: phi <4 x float>
// NATIVE-LABEL: define {{.*}} @_ZGVdN8uuluv_scale(
// NATIVE-NOT: icmp eq i8
// NATIVE: call <8 x float> @llvm.masked.load
// NATIVE: call void @llvm.masked.store
#pragma omp declare simd uniform(to, from, factor) linear(i) notinbranch
float scale(float *restrict to, const float *restrict from, int i, float factor, float x) {
  float sum = x;
  if (x > 0) {
    float value = from[i] * factor;
    to[i] = value;
    sum += value;
  }
  return sum;
}
#else
#include <immintrin.h>
#include <stdio.h>
__m128 scale4(float *to, const float *from, int i, float factor, __m128 x) __asm__("_ZGVbN4uuluv_scale");
int main(void) {
  for (int active = 0; active < 16; ++active) {
    float x[4], to[4], from[4], sum[4];
    for (int k = 0; k < 4; ++k)
      x[k] = active >> k & 1 ? 1.5f : -1.5f, to[k] = 77, from[k] = (float)(k + 1);
    _mm_storeu_ps(sum, scale4(to - 5, from - 5, 5, 3, _mm_loadu_ps(x)));
    for (int k = 0; k < 4; ++k) {
      int is = active >> k & 1;
      if (to[k] != (is ? 3 * from[k] : 77) || sum[k] != (is ? 1.5f + 3 * from[k] : -1.5f))
        return printf("lanes %x: lane %d has %g, %g\n", active, k, to[k], sum[k]), 1;
    }
  }
  return 0;
}
#endif
