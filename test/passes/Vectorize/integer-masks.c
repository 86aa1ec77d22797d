// Without mask registers, masks are integers of 32 bits wherever they cross a block or meet logic; with
// them they stay as they are. What leaves a loop starts at zero, so that no garbage is computed with.
//
// RUN: clang -O1 -march=x86-64-v3 -fopenmp-simd -emit-llvm -c %s -o %t.bc
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' %t.bc -S | FileCheck %s
// RUN: anysl-opt -passes='anysl-vectorize<width=16;verify>' %t.bc -S | FileCheck --check-prefix=REGISTERS %s
// RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8>' %t.bc -o %t.wide.bc
// RUN: clang -O3 -march=x86-64-v3 -S %t.wide.bc -o - | FileCheck --check-prefix=ASM %s

// CHECK-LABEL: define {{.*}}@_ZGVdN8vv_shrink(
// CHECK-NOT: phi <8 x i1>
// CHECK: phi <8 x float> {{.*}}[ zeroinitializer,
// CHECK-NOT: phi <8 x i1>
// CHECK: phi <8 x i32>
// CHECK-NOT: phi <8 x i1>
// CHECK: icmp slt <8 x i32> %{{.*}}, zeroinitializer
// CHECK: ret <8 x float>

// REGISTERS-LABEL: define {{.*}}@_ZGVeN16vv_shrink(
// REGISTERS: phi <16 x i1>

// ASM-LABEL: _ZGVdN8vv_shrink:
// ASM-NOT: packss
// ASM: vblendvps
// ASM-NOT: packss
// ASM: ret
#pragma omp declare simd notinbranch
float shrink(float x, float limit) {
  float steps = 0;
  while (x > limit) {
    if (x > 2 * limit)
      x *= 0.5f;
    else
      x -= limit * 0.75f;
    if (x == 3)
      break;
    steps += 1;
  }
  return steps * x;
}

// A sign that some lanes turn is an exclusive or, not a blend of a number and its negative: of all bits of a comparison
// the sign's, or a bit of an integer moved to where the sign is.
// CHECK-LABEL: define {{.*}}@_ZGVdN8vvv_turn(
// CHECK-NOT: fneg
// CHECK-DAG: shl <8 x i32> %{{.*}}, {{(splat \(i32 31\)|<i32 31)}}
// CHECK-DAG: shl <8 x i32> %{{.*}}, {{(splat \(i32 29\)|<i32 29)}}
// CHECK-DAG: and <8 x i32> %{{.*}}, {{(splat \(i32 -2147483648\)|<i32 -2147483648)}}
// CHECK-NOT: fneg
// CHECK: ret <8 x float>
// REGISTERS-LABEL: define {{.*}}@_ZGVeN16vvv_turn(
// REGISTERS: fneg <16 x float>
// ASM-LABEL: _ZGVdN8vvv_turn:
// ASM-NOT: vblendvps
// ASM: ret
#pragma omp declare simd notinbranch
float turn(float x, float y, unsigned bits) {
  return ((bits & 1) ? -x : x) * ((bits & 4) ? y : -y) + (x > y ? -(x * y) : x * y);
}
