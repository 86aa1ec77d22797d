; What cannot be widened is left alone, with a remark that says why; other functions are widened.
; RUN: opt -load-pass-plugin=%plugin -passes=anysl-vectorize -pass-remarks-missed=anysl-vectorize -S %s 2>&1 | FileCheck %s

; CHECK-DAG: remark: {{.*}}: variadic has no variant _ZGV_LLVM_N4v_variadic: it takes a variable number of arguments
; CHECK-DAG: remark: {{.*}}: computed has no variant _ZGV_LLVM_N4v_computed: it jumps to computed addresses
; CHECK-DAG: remark: {{.*}}: misnamed has no variant _ZGV_LLVM_N4vv_misnamed: its parameters do not match the variant's name
; CHECK-DAG: remark: {{.*}}: linear has no variant _ZGV_LLVM_N4l_linear: a parameter that is neither integer nor pointer cannot be linear
; CHECK-DAG: define <4 x i32> @_ZGV_LLVM_N4v_fine(

define i32 @variadic(i32 %x, ...) "_ZGV_LLVM_N4v_variadic" {
  ret i32 %x
}

define i32 @computed(i32 %x) "_ZGV_LLVM_N4v_computed" {
entry:
  %c = icmp sgt i32 %x, 0
  %to = select i1 %c, ptr blockaddress(@computed, %a), ptr blockaddress(@computed, %b)
  indirectbr ptr %to, [label %a, label %b]
a:
  ret i32 1
b:
  ret i32 2
}

define i32 @misnamed(i32 %x) "_ZGV_LLVM_N4vv_misnamed" {
  ret i32 %x
}

define float @linear(float %x) "_ZGV_LLVM_N4l_linear" {
  ret float %x
}

define i32 @fine(i32 %x) "_ZGV_LLVM_N4v_fine" "_ZGV_nonsense" "_ZGVnN4v_fine" {
  ret i32 %x
}
