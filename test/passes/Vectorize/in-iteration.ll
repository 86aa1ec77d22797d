; A choice between values within an iteration does not wait for which lanes are still in the loop: those that have left do
; not look at it. What leaves the loop, and who goes on, is a matter of active lanes.
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' -S %s | FileCheck %s

; CHECK-LABEL: define <8 x float> @_ZGV_LLVM_N8vvv_halve(
; CHECK: [[MASK:%.*]] = phi <8 x i1> [ {{(splat \(i1 true\)|<i1 true)}}
; CHECK: [[TEST:%.*]] = fcmp ogt <8 x float> [[S:%.*]], %limit
; CHECK: [[D:%.*]] = fdiv <8 x float>
; CHECK: [[V:%.*]] = select <8 x i1> [[TEST]], <8 x float> [[D]], <8 x float> [[S]]
; CHECK: select <8 x i1> [[MASK]], <8 x i1>
; CHECK: select <8 x i1> [[MASK]], <8 x float> [[V]]
define float @halve(float %x, float %limit, i32 %n) "target-features"="+avx512f,+avx512vl" "_ZGV_LLVM_N8vvv_halve" {
entry:
  br label %body
body:
  %k = phi i32 [ 0, %entry ], [ %next, %latch ]
  %s = phi float [ %x, %entry ], [ %v, %latch ]
  %c = fcmp ogt float %s, %limit
  br i1 %c, label %then, label %latch
then:
  %d = fdiv float %s, %x
  br label %latch
latch:
  %v = phi float [ %d, %then ], [ %s, %body ]
  %next = add i32 %k, 1
  %again = icmp slt i32 %next, %n
  br i1 %again, label %body, label %end
end:
  ret float %v
}
