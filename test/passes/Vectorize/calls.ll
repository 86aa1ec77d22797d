; Which wide form of a callee a call takes, and what happens where there is none.
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-vectorize<width=8>' -pass-remarks-missed=anysl-vectorize -S %s -o %t.ll 2> %t.remarks
; RUN: FileCheck %s < %t.ll
; RUN: FileCheck --check-prefix=REMARK %s < %t.remarks

; REMARK: calls opaque once per active lane, as it has no vector variant for 8 lanes
declare float @opaque(float)
; The mask of a variant may have any form: here an integer of 16 bits, of which 8 count.
declare void @service_x8(ptr, i32, <8 x float>, ptr, i16)
declare <8 x float> @both_all(<8 x float>)
declare <8 x float> @both_some(<8 x float>, <8 x i1>)
declare float @both(float) "_ZGV_LLVM_N8v_both(both_all)" "_ZGV_LLVM_M8v_both(both_some)"
declare float @pure(float) #0
; REMARK: calls whole once per active lane unless all are active
declare <8 x float> @whole_x8(<8 x float>)
declare float @whole(float) "_ZGV_LLVM_N8v_whole(whole_x8)"

define float @helper(float %x, float %y, ptr %p) noinline {
  %v = load float, ptr %p
  %s = fadd float %x, %y
  %r = fmul float %s, %v
  ret float %r
}

; All lanes are active at first, then some.
; CHECK-LABEL: define void @_ZGV_LLVM_N8ul_calls(
; CHECK: call <8 x float> @both_all(<8 x float> [[X:%.*]])
; CHECK: [[TEST:%.*]] = fcmp ogt
; CHECK: call <8 x float> @both_some(<8 x float> {{%.*}}, <8 x i1> [[TEST]])
define void @calls(ptr %a, i32 %i) "_ZGV_LLVM_N8ul_calls" {
  %p = getelementptr float, ptr %a, i32 %i
  %x = load float, ptr %p
  %b = call float @both(float %x)
  %c = fcmp ogt float %b, 0.0
  br i1 %c, label %then, label %end
then:
  %d = call float @both(float %b)
  store float %d, ptr %p
  br label %end
end:
  ret void
}

; Each active lane by itself, lowest first.
; CHECK-LABEL: define void @_ZGV_LLVM_N8ul_lanes(
; CHECK: call {{.*}}i{{[0-9]+}} @llvm.cttz
; CHECK: call float @opaque(float
define void @lanes(ptr %a, i32 %i) "_ZGV_LLVM_N8ul_lanes" {
  %p = getelementptr float, ptr %a, i32 %i
  %x = load float, ptr %p
  %b = call float @opaque(float %x)
  store float %b, ptr %p
  ret void
}

; A function without effects, on what is the same for all lanes, is called once.
; CHECK-LABEL: define void @_ZGV_LLVM_N8ul_once(
; CHECK: [[ONE:%.*]] = call float @pure(float 1.0
; CHECK-NOT: call
; CHECK: ret void
define void @once(ptr %a, i32 %i) "_ZGV_LLVM_N8ul_once" {
  %p = getelementptr float, ptr %a, i32 %i
  %b = call float @pure(float 1.0)
  store float %b, ptr %p
  ret void
}

; A function of the module gets the wide form that the call needs: varying, uniform, linear.
; CHECK-LABEL: define void @_ZGV_LLVM_N8ulu_defined(
; CHECK: call <8 x float> @helper.N8vul4{{.*}}(<8 x float> {{%.*}}, float %y, ptr
define void @defined(ptr %a, i32 %i, float %y) "_ZGV_LLVM_N8ulu_defined" {
  %p = getelementptr float, ptr %a, i32 %i
  %x = load float, ptr %p
  %b = call float @helper(float %x, float %y, ptr %p)
  store float %b, ptr %p
  ret void
}

; A lane's variable is passed by the address of lane 0's.
; CHECK-LABEL: define void @_ZGV_LLVM_M8ul_addresses(
; CHECK: [[BITS:%.*]] = bitcast <8 x i1> %mask to i8
; CHECK: [[VARIABLE:%.*]] = alloca [8 x [4 x i8]]
; CHECK: [[MASK:%.*]] = zext i8 [[BITS]] to i16
; CHECK: call void @service_x8(ptr %a, i32 %i, <8 x float> {{.*}}, ptr {{.*}}[[VARIABLE]], i16 {{.*}}[[MASK]])
define void @addresses(ptr %a, i32 %i) "_ZGV_LLVM_M8ul_addresses" {
  %r = alloca float
  %p = getelementptr float, ptr %a, i32 %i
  %x = load float, ptr %p
  call void @serviceVoid(ptr %a, i32 %i, float %x, ptr %r)
  %b = load float, ptr %r
  store float %b, ptr %p
  ret void
}
declare void @serviceVoid(ptr, i32, float, ptr) "_ZGV_LLVM_M8ulvl4_serviceVoid(service_x8)"

attributes #0 = { nounwind willreturn memory(none) }

; What can only be called for all lanes is, if all are active.
; CHECK-LABEL: define void @_ZGV_LLVM_N8ul_perhapsWhole(
; CHECK: [[TEST:%.*]] = fcmp ogt <8 x float>
; CHECK: i8 -1, label %all
; CHECK: call <8 x float> @whole_x8(<8 x float>
; CHECK: call float @whole(float
; CHECK: phi <8 x float>
define void @perhapsWhole(ptr %a, i32 %i) "_ZGV_LLVM_N8ul_perhapsWhole" {
  %p = getelementptr float, ptr %a, i32 %i
  %x = load float, ptr %p
  %c = fcmp ogt float %x, 0.0
  br i1 %c, label %then, label %end
then:
  %d = call float @whole(float %x)
  store float %d, ptr %p
  br label %end
end:
  ret void
}
