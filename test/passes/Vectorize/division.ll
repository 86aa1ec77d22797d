; Idle lanes divide by one; all lanes active, or a constant divisor, need no care.
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<no-cleanup>' -S %s | FileCheck %s

; CHECK-LABEL: define <4 x i32> @_ZGV_LLVM_M4vv_divide(
; CHECK: [[SAFE:%.*]] = select <4 x i1> %{{.*}}, <4 x i32> %y, <4 x i32> {{<i32 1, i32 1, i32 1, i32 1>|splat \(i32 1\)}}
; CHECK: sdiv <4 x i32> %x, [[SAFE]]
; CHECK: udiv <4 x i32> %x, <i32 7
; CHECK-LABEL: define <4 x i32> @_ZGV_LLVM_N4vv_divide(
; CHECK: sdiv <4 x i32> %x, %y
define i32 @divide(i32 %x, i32 %y) "_ZGV_LLVM_M4vv_divide" "_ZGV_LLVM_N4vv_divide" {
  %q = sdiv i32 %x, %y
  %r = udiv i32 %x, 7
  %s = add i32 %q, %r
  ret i32 %s
}
