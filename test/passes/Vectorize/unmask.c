// Where the processor has no gather, idle lanes load from a place on the stack and store to it: no test and jump for each
// lane. Where it has one, the mask stays.
// RUN: clang -O1 -mavx2 -fopenmp-simd -emit-llvm -c %s -o %t.avx2.bc
// RUN: clang -O1 -msse4.2 -fopenmp-simd -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=4;verify>' %t.bc -S -o %t.ll
// RUN: FileCheck %s < %t.ll
// RUN: clang -O2 -S -x ir %t.ll -o - | FileCheck --check-prefix=ASM %s
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' %t.avx2.bc -S | FileCheck --check-prefix=NATIVE %s

// CHECK-LABEL: define {{.*}} @_ZGVbN4uuvv_exchange(
// CHECK: %idle = alloca i64
// CHECK: select <4 x i1> %{{.*}}, <4 x ptr> %{{.*}}, <4 x ptr>
// CHECK: call <4 x float> @llvm.masked.gather.v4f32.v4p0(<4 x ptr> %{{.*}}, i32 4, <4 x i1> <i1 true, i1 true, i1 true, i1 true>
// CHECK: call void @llvm.masked.scatter.v4f32.v4p0(<4 x float> %{{.*}}, <4 x ptr> %{{.*}}, i32 4, <4 x i1> <i1 true, i1 true, i1 true, i1 true>)
// CHECK: ret void
// NATIVE-LABEL: define {{.*}} @_ZGVdN8uuvv_exchange(
// NATIVE: call <8 x float> @llvm.masked.gather.v8f32.v8p0(<8 x ptr> %{{.*}}, i32 4, <8 x i1> %
// ASM-LABEL: _ZGVbN4uuvv_exchange:
// ASM-NOT: {{[[:space:]]j[a-z]+[[:space:]]}}
// ASM: ret
#pragma omp declare simd uniform(to, from) notinbranch
void exchange(float *restrict to, const float *restrict from, unsigned k, float x) {
  if (x > 0)
    to[k & 255] = from[k & 127] * x;
}
