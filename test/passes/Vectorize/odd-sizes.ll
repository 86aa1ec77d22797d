; Numbers of odd sizes are stored by one lane after the other, and by none where none is active.
; RUN: opt -load-pass-plugin=%plugin -passes=anysl-vectorize -S %s | FileCheck %s
; CHECK-LABEL: define void @_ZGV_LLVM_M4v_put(
; CHECK: %[[NONE:.*]] = icmp eq i4 %{{.*}}, 0
; CHECK: br i1 %[[NONE]], label %[[END:.*]], label
; CHECK: store i24 5, ptr
; CHECK: [[END]]:
; CHECK-NEXT: ret void
define void @put(ptr %p) "_ZGV_LLVM_M4v_put" {
  store i24 5, ptr %p, align 4
  ret void
}
