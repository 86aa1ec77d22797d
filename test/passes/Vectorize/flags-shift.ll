; Before AVX2, LLVM shifts lanes by amounts of their own through floating-point conversions, which raise a flag: in functions
; that mind flags, lanes are shifted one after the other. Found by fuzzing.
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=4;verify>' -S %s | FileCheck %s

; CHECK-LABEL: define {{.*}} @_ZGV_LLVM_N4vv_shift(
; CHECK-NOT: shl <4 x i32>
; CHECK-COUNT-4: shl i32
; CHECK: ret <4 x i32>
define i32 @shift(i32 %x, i32 %y) strictfp "_ZGV_LLVM_N4vv_shift" {
  %a = and i32 %y, 31
  %r = shl i32 %x, %a
  ret i32 %r
}

; CHECK-LABEL: define {{.*}} @_ZGV_LLVM_N4vv_other(
; CHECK: shl <4 x i32>
define i32 @other(i32 %x, i32 %y) "_ZGV_LLVM_N4vv_other" {
  %a = and i32 %y, 31
  %r = shl i32 %x, %a
  ret i32 %r
}

; CHECK-LABEL: define {{.*}} @_ZGV_LLVM_N4vv_avx2(
; CHECK: shl <4 x i32>
define i32 @avx2(i32 %x, i32 %y) strictfp "target-features"="+avx2" "_ZGV_LLVM_N4vv_avx2" {
  %a = and i32 %y, 31
  %r = shl i32 %x, %a
  ret i32 %r
}
