; Structures as values: chosen, merged behind divergent branches, passed and returned; each field is a vector. Found
; by fuzzing: the blend of two.
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8;verify>' -S %s | FileCheck %s

%pair = type { i32, float }

define internal %pair @turn(%pair %p) noinline {
  %a = extractvalue %pair %p, 0
  %b = add i32 %a, 1
  %q = insertvalue %pair %p, i32 %b, 0
  ret %pair %q
}

; CHECK-LABEL: define {{.*}} @_ZGV_LLVM_N8uv_merge(
; CHECK: call { <8 x i32>, <8 x float> } @turn.M8
; CHECK-DAG: select <8 x i1> %{{.*}}, <8 x i32>
; CHECK-DAG: select <8 x i1> %{{.*}}, <8 x float>
; CHECK: ret <8 x float>
define float @merge(i32 %n, i32 %x) "_ZGV_LLVM_N8uv_merge" {
entry:
  %one = insertvalue %pair { i32 0, float 1.0 }, i32 %x, 0
  %c = icmp sgt i32 %x, 0
  br i1 %c, label %then, label %end
then:
  %two = call %pair @turn(%pair %one)
  %d = icmp sgt i32 %x, %n
  br i1 %d, label %more, label %end
more:
  %three = insertvalue %pair %two, float 3.0, 1
  br label %end
end:
  %p = phi %pair [ %one, %entry ], [ %two, %then ], [ %three, %more ]
  %i = extractvalue %pair %p, 0
  %f = extractvalue %pair %p, 1
  %g = sitofp i32 %i to float
  %r = fadd float %f, %g
  ret float %r
}
