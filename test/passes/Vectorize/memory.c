// What loads and stores become: plain, masked (idle lanes read 0), reversed, one for all lanes, gathers and scatters.
// RUN: clang -O1 -fopenmp-simd -fno-math-errno -S -emit-llvm %s -o - | opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8>' -S -o %t.ll
// RUN: FileCheck %s < %t.ll

// CHECK-LABEL: define {{.*}} @_ZGVdN8uul_consecutive(
// CHECK: load <8 x float>
// CHECK: load float
// CHECK: store <8 x float>
// CHECK: ret void
#pragma omp declare simd uniform(a, b) linear(i) notinbranch
void consecutive(float *a, const float *b, int i) { a[i] = b[i + 3] * b[2]; }

// CHECK-LABEL: define {{.*}} @_ZGVdN8uul_conditional(
// CHECK: [[TEST:%.*]] = fcmp ogt <8 x float>
// CHECK-NOT: bitcast <8 x i1>
// CHECK: call void @llvm.masked.store.v8f32.p0({{.*}}<8 x i1>
// CHECK: ret void
#pragma omp declare simd uniform(a, b) linear(i) notinbranch
void conditional(float *a, const float *b, int i) {
  if (b[i] > 0)
    a[i] = b[i] + 1;
}

// CHECK-LABEL: define {{.*}} @_ZGVdM8uul_consecutive_masked(
// CHECK: call <8 x float> @llvm.masked.load.v8f32.p0({{.*}}, <8 x float> zeroinitializer)
// CHECK: call void @llvm.masked.store
#pragma omp declare simd uniform(a, b) linear(i) inbranch
void consecutive_masked(float *a, const float *b, int i) { a[i] = b[i]; }

// CHECK-LABEL: define {{.*}} @_ZGVdN8uul_reversed(
// CHECK: load <8 x float>
// CHECK: shufflevector <8 x float> {{.*}} <i32 7, i32 6, i32 5, i32 4, i32 3, i32 2, i32 1, i32 0>
#pragma omp declare simd uniform(a, b) linear(i) notinbranch
void reversed(float *a, const float *b, int i) { a[i] = b[100 - i]; }

// CHECK-LABEL: define {{.*}} @_ZGVdN8uv_table(
// CHECK: call <8 x float> @llvm.masked.gather.v8f32
// CHECK-NOT: gather
// CHECK: ret <8 x float>
#pragma omp declare simd uniform(t) notinbranch
float table(const float *t, int k) { return t[k & 255]; }

// CHECK-LABEL: define {{.*}} @_ZGVdN8uvv_scatter(
// CHECK: call void @llvm.masked.scatter.v8f32
#pragma omp declare simd uniform(t) notinbranch
void scatter(float *t, int k, float x) { t[k] = x; }

// All lanes write to one place; in order, the last would stay.
// CHECK-LABEL: define {{.*}} @_ZGVdN8uv_last(
// CHECK: extractelement <8 x float> %{{.*}}, i{{32|64}} 7
// CHECK-NEXT: store float
#pragma omp declare simd uniform(t) notinbranch
void last(float *t, float x) { *t = x; }

// A variable of each lane's own that is never indexed needs no memory.
// CHECK-LABEL: define {{.*}} @_ZGVdN8v_local(
// CHECK-NOT: alloca
// CHECK: ret <8 x float>
#pragma omp declare simd notinbranch
float local(float x) {
  float a[2] = {x, 1};
  float *p = x > 0 ? &a[0] : &a[1];
  return *p;
}

// AVX2's own gather, which LLVM replaces by a load for each lane unless it is told that gathers are fast.
// RUN: clang -O1 -mavx2 -S -x ir %t.ll -o - | FileCheck --check-prefix=ASM %s
// ASM-LABEL: _ZGVdN8uv_table:
// ASM: vgatherdps
