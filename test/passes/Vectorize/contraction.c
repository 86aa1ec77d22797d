// Where the scalar function multiplies and adds in two steps, so does a variant whose instruction set could do it in
// one; where both can, it is left to LLVM.
// RUN: clang -O1 -fopenmp-simd -ffp-contract=on -S -emit-llvm %s -o - | opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8>' -S | FileCheck %s
// RUN: clang -O1 -fopenmp-simd -ffp-contract=on -mfma -S -emit-llvm %s -o - | opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8>' -S | FileCheck --check-prefix=FMA %s

// CHECK-LABEL: define {{.*}} @_ZGVdN8vvv_product(
// CHECK: fmul <8 x float>
// CHECK: fadd <8 x float>
// FMA-LABEL: define {{.*}} @_ZGVdN8vvv_product(
// FMA: call <8 x float> @llvm.fmuladd.v8f32
#pragma omp declare simd notinbranch
float product(float x, float y, float z) { return x * y + z; }
