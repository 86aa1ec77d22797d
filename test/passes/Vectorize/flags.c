// In a function that minds floating-point exceptions, and with keep-fp-flags in any, idle lanes raise no flags: they
// compute with ones. Elsewhere C leaves flags open, and idle lanes compute with what they hold.
// REQUIRES: avx2
// RUN: clang -O1 -mavx2 -fopenmp-simd -ffp-exception-behavior=strict -DSTRICT -emit-llvm -c %s -o %t.strict.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' %t.strict.bc -S -o %t.strict.ll
// RUN: FileCheck %s < %t.strict.ll
// RUN: clang -O2 -mavx2 %t.strict.ll -o %t.strict -lm && %t.strict
// RUN: clang -O1 -mavx2 -fopenmp-simd -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;keep-fp-flags;verify>' %t.bc -o %t.kept.bc
// RUN: clang -O2 -mavx2 %t.kept.bc -o %t.kept -lm && %t.kept
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' %t.bc -o %t.relaxed.bc
// RUN: clang -O2 -mavx2 %t.relaxed.bc -o %t.relaxed -lm && not %t.relaxed
#include <fenv.h>
#include <immintrin.h>

// CHECK-LABEL: define {{.*}} @_ZGVdN8vv_quotient(
// CHECK: select <8 x i1> %{{.*}}, <8 x float> %{{.*}}, <8 x float> <float 1.000000e+00, float 1.000000e+00,
// CHECK: call <8 x float> @llvm.experimental.constrained.fdiv.v8f32({{.*}}, metadata !"fpexcept.strict")
// CHECK: ret <8 x float>
#pragma omp declare simd notinbranch
float quotient(float x, float y) {
  float sum = 0;
  if (y != 0)
    for (int k = 0; k < 3; ++k)
      sum = sum + x / y;
  return sum;
}
__m256 quotients(__m256, __m256) __asm__("_ZGVdN8vv_quotient");

int main(void) {
  // Infinities and zeros over zeros in lanes that do not divide; exact quotients in the others.
  float x[8] = {1, 0, 6, 7, 8, 0, 2, 1}, y[8] = {0, 0, 2, 1, 0, 0, 4, 0}, z[8];
  feclearexcept(FE_ALL_EXCEPT);
  _mm256_storeu_ps(z, quotients(_mm256_loadu_ps(x), _mm256_loadu_ps(y)));
  int raised = fetestexcept(FE_ALL_EXCEPT);
  for (int k = 0; k < 8; ++k)
    if (z[k] != (y[k] != 0 ? 3 * x[k] / y[k] : 0))
      return 2;
  return raised != 0;
}
