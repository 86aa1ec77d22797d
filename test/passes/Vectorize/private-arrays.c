// What each lane has for itself: an array lies element by element, so that one index for all lanes is a plain load or
// store, and an index of each lane's own a gather with 32-bit offsets; an array that clang unrolls needs no memory at all.
// RUN: clang -O1 -mavx2 -fopenmp-simd -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' %t.bc -S | FileCheck %s
// RUN: clang -O3 -mavx2 -fno-vectorize -fno-slp-vectorize -fopenmp-simd -DSORT -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' %t.bc -S | FileCheck --check-prefix=SORT %s

#ifndef SORT
// CHECK-LABEL: define {{.*}} @_ZGVdN8vvu_history(
// CHECK: alloca [256 x i32]
// CHECK-NOT: gather
// CHECK: store <8 x float>
// CHECK-NOT: gather
// CHECK: call <8 x float> @llvm.masked.gather.v8f32.v8p0(<8 x ptr>
// CHECK-NOT: gather
// CHECK: ret <8 x float>
#pragma omp declare simd notinbranch uniform(n)
float history(float x, unsigned k, int n) {
  float seen[32];
  for (int i = 0; i < 32; ++i)
    seen[i] = x * (float)i;
  for (int i = 1; i < n; ++i)
    seen[i & 31] += seen[(i - 1) & 31];
  return seen[k & 31];
}

// Whoever gets the address wants a lane's variable in one piece.
// CHECK-LABEL: define {{.*}} @_ZGVdN8v_shown(
// CHECK: alloca {{\[8 x \[16 x i8\]\]|\[16 x i8\], i32 8}}
void show(float *);
#pragma omp declare simd notinbranch
float shown(float x) {
  float four[4] = {x, x, x, x};
  show(four);
  return four[2];
}
#else
// SORT-LABEL: define {{.*}} @_ZGVdN8vvvv_second(
// SORT-NOT: alloca
// SORT-NOT: scatter
// SORT: ret <8 x float>
#pragma omp declare simd notinbranch
float second(float a, float b, float c, float d) {
  float in[4] = {a, b, c, d}, sorted[4];
  for (int k = 0; k < 4; ++k) {
    int place = k;
    while (place > 0 && sorted[place - 1] > in[k]) {
      sorted[place] = sorted[place - 1];
      --place;
    }
    sorted[place] = in[k];
  }
  return sorted[1];
}
#endif
