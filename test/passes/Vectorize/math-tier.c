// With a tier, C's elementary functions are the tier's, wide, and nothing is left of the library's; without one they run
// once per active lane, with a remark, be they calls or LLVM's intrinsics.
// REQUIRES: avx2
// RUN: clang -O1 -mavx2 -mfma -fopenmp-simd -emit-llvm -g -c %s -o %t.calls.bc
// RUN: clang -O1 -mavx2 -mfma -fopenmp-simd -fno-math-errno -emit-llvm -g -c %s -o %t.intrinsics.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;math=u10;verify>,verify' -pass-remarks-missed=anysl-vectorize %t.calls.bc -S -o %t.tier.ll 2>&1 | FileCheck --check-prefix=QUIET --allow-empty %s
// RUN: FileCheck %s < %t.tier.ll
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;math=u10>' %t.intrinsics.bc -S | FileCheck %s
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8>' -pass-remarks-missed=anysl-vectorize %t.calls.bc -S -o %t.lanes.ll 2>&1 | FileCheck --check-prefix=REMARK -DCALL= %s
// RUN: FileCheck --check-prefix=LANES %s < %t.lanes.ll
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8>' -pass-remarks-missed=anysl-vectorize %t.intrinsics.bc -S -o %t.lanes.ll 2>&1 | FileCheck --check-prefix=REMARK %s
// RUN: FileCheck --check-prefix=LANES %s < %t.lanes.ll
//
// The wide functions give what the tier gives one at a time, bit for bit.
// RUN: clang -O2 %t.tier.ll %lib_dir/anysl/math/u10.bc -o %t -lm && %t
//
// RUN: not opt -load-pass-plugin=%plugin -passes='anysl-vectorize<math=u99>' %t.calls.bc -S 2>&1 | FileCheck --check-prefix=NONE %s
// NONE: there is no math tier 'u99'; there are cr, fast, u10, u35
#include <immintrin.h>
#include <math.h>
#include <string.h>

// QUIET-NOT: calls {{(llvm.)?(sin|pow|atan2)}}
// CHECK-LABEL: define {{.*}} @_ZGVdN8vv_wave(
// CHECK-NOT: call {{.*}}@{{(llvm\.)?(sin|pow|atan2|fmod)}}
// CHECK-NOT: anysl_math
// CHECK: ret <8 x float>
// LANES-LABEL: define {{.*}} @_ZGVdN8vv_wave(
// LANES: call float @{{sinf|llvm.sin.f32}}(float
// LANES: ret <8 x float>
// REMARK: math-tier.c:[[@LINE+4]]:{{[0-9]+}}: calls {{sinf|llvm.sin.f32}} once per active lane
// REMARK: math-tier.c:[[@LINE+3]]:{{[0-9]+}}: calls {{powf|llvm.pow.f32}} once per active lane
#pragma omp declare simd notinbranch
float wave(float x, float y) {
  return sinf(x) + powf(fabsf(x), y) * atan2f(y, x);
}
__m256 waves(__m256, __m256) __asm__("_ZGVdN8vv_wave");

// What a program calls by such a name itself is nobody else's.
// CHECK-LABEL: define {{.*}} @_ZGVdN8v_own(
// CHECK: call {{.*}} @divide
__attribute__((weak)) float divide(float, float);
#pragma omp declare simd notinbranch
float own(float x) { return divide(x, 2); }

float anysl_math_sinf(float), anysl_math_powf(float, float), anysl_math_atan2f(float, float);

int main(void) {
  for (int i = -2000; i < 2000; i += 8) {
    float x[8], y[8], z[8];
    for (int k = 0; k < 8; ++k)
      x[k] = (float)(i + k) * 0.013f, y[k] = (float)(i * k % 97) * 0.05f;
    _mm256_storeu_ps(z, waves(_mm256_loadu_ps(x), _mm256_loadu_ps(y)));
    for (int k = 0; k < 8; ++k) {
      float one = anysl_math_sinf(x[k]) + anysl_math_powf(fabsf(x[k]), y[k]) * anysl_math_atan2f(y[k], x[k]);
      if (memcmp(&one, &z[k], 4) != 0)
        return 1;
    }
  }
  return 0;
}
