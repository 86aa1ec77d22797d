; In which order blocks run, which branches stay, and what is jumped over.
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-normalize,print<anysl-schedule>' -disable-output %s 2>&1 | FileCheck %s

; A uniform branch stays one, and costs no mask.
; CHECK-LABEL: schedule of uniform
; CHECK-NEXT: entry: full
; CHECK-NEXT: branch then, end
; CHECK-NEXT: then: full
; CHECK-NEXT: jump end
; CHECK-NEXT: end: full, mask of entry
; CHECK-NEXT: return
define void @uniform(ptr %p, i32 %n) "_ZGV_LLVM_N8uu_uniform" {
entry:
  %c = icmp sgt i32 %n, 0
  br i1 %c, label %then, label %end
then:
  store volatile i32 1, ptr %p
  br label %end
end:
  ret void
}

; Both sides of a divergent branch run one after the other; lanes wait for the second at its place. Each is
; skipped when nobody takes it, as a volatile store must not run for nobody.
; CHECK-LABEL: schedule of divergent
; CHECK-NEXT: entry: full
; CHECK-NEXT: jump [[FIRST:then|else]]
; CHECK-NEXT: [[FIRST]]: occupied, pending [[SECOND:then|else]], skipped to [[SECOND]]
; CHECK-NEXT: jump [[SECOND]]
; CHECK-NEXT: [[SECOND]]: occupied, pending end, skipped to end
; CHECK-NEXT: jump end
; CHECK-NEXT: end: full, mask of entry
define void @divergent(ptr %p, i32 %x) "_ZGV_LLVM_N8uv_divergent" {
entry:
  %c = icmp sgt i32 %x, 0
  br i1 %c, label %then, label %else
then:
  store volatile i32 1, ptr %p
  br label %end
else:
  store volatile i32 2, ptr %p
  br label %end
end:
  ret void
}

; Lanes that leave a loop wait outside; it repeats while any is left.
; CHECK-LABEL: schedule of loop
; CHECK-NEXT: entry: full
; CHECK-NEXT: jump loop
; CHECK-NEXT: loop: occupied, pending [[OUT:.*]]
; CHECK-NEXT: repeat if any, else [[OUT]]
; CHECK-NEXT: [[OUT]]: full, mask of entry
define i32 @loop(i32 %x) "_ZGV_LLVM_N8v_loop" {
entry:
  br label %loop
loop:
  %k = phi i32 [ 0, %entry ], [ %next, %loop ]
  %next = add i32 %k, 1
  %again = icmp slt i32 %next, %x
  br i1 %again, label %loop, label %out
out:
  ret i32 %next
}

; A uniform loop inside a divergent branch stays a plain loop, entered only if somebody is in it.
; CHECK-LABEL: schedule of inner
; CHECK: [[GUARD:.*]]: occupied, pending end, skipped to end
; CHECK-NEXT: jump body
; CHECK-NEXT: body: occupied, mask of [[GUARD]], pending end
; CHECK-NEXT: branch body, {{end.*}}
define void @inner(ptr %p, i32 %n, i32 %x) "_ZGV_LLVM_N8uuv_inner" {
entry:
  %c = icmp sgt i32 %x, 0
  br i1 %c, label %guard, label %end
guard:
  br label %body
body:
  %k = phi i32 [ 0, %guard ], [ %next, %body ]
  store volatile i32 %k, ptr %p
  %next = add i32 %k, 1
  %again = icmp ult i32 %next, %n
  br i1 %again, label %body, label %end
end:
  ret void
}

; Every way to the end leads through `check`, but out of the loop around it and in again: lanes that take
; `around` must not count as being in `check`. Found by fuzzing.
; CHECK-LABEL: schedule of leavesBetween
; CHECK: check: {{[^,]*}}, pending
define void @leavesBetween(ptr %p, i32 %n, i32 %x) "_ZGV_LLVM_N8uuv_leavesBetween" {
entry:
  br label %outer
outer:
  %first = phi i1 [ true, %entry ], [ false, %around ]
  br label %head
head:
  %k = phi i32 [ 0, %outer ], [ %next, %check ]
  %c = icmp eq i32 %x, %k
  %leave = and i1 %c, %first
  br i1 %leave, label %around, label %check
check:
  store volatile i32 %k, ptr %p
  %next = add i32 %k, 1
  %again = icmp slt i32 %next, %x
  br i1 %again, label %head, label %end
around:
  store volatile i32 7, ptr %p
  br label %outer
end:
  ret void
}

; More ways lead to `join` than lanes have to leave the way to it: it has whom nobody saw leaving.
; CHECK-LABEL: schedule of leavers
; CHECK: join: perhaps empty, mask of body without second->latch, pending
; CHECK: latch: perhaps empty, mask of body without join->[[END:[a-z.]+]], pending [[END]]
define i32 @leavers(i32 %n, i32 %x, i32 %y) "_ZGV_LLVM_N8vvv_leavers" {
entry:
  br label %body
body:
  %k = phi i32 [ 0, %entry ], [ %next, %latch ]
  %c = icmp sgt i32 %x, %k
  br i1 %c, label %first, label %second
first:
  %d = icmp sgt i32 %y, %k
  br i1 %d, label %third, label %join
third:
  br label %join
second:
  %e = icmp slt i32 %y, %k
  br i1 %e, label %join, label %latch
join:
  %v = phi i32 [ 1, %first ], [ 2, %third ], [ 3, %second ]
  %w = mul i32 %v, %x
  %f = icmp eq i32 %w, %k
  br i1 %f, label %out, label %latch
latch:
  %l = phi i32 [ %w, %join ], [ 0, %second ]
  %next = add i32 %k, 1
  %again = icmp slt i32 %next, %n
  br i1 %again, label %body, label %end
out:
  ret i32 %w
end:
  ret i32 %l
}

; A division is quick for four lanes and takes its time for sixteen, where a jump costs less.
; CHECK-LABEL: _ZGV_LLVM_N16v_inverse
; CHECK: positive: occupied, pending end, skipped to end
; CHECK-LABEL: _ZGV_LLVM_N4v_inverse
; CHECK: positive: perhaps empty, pending end{{$}}
define float @inverse(float %x) "_ZGV_LLVM_N4v_inverse" "_ZGV_LLVM_N16v_inverse" {
entry:
  %c = fcmp ogt float %x, 0.0
  br i1 %c, label %positive, label %end
positive:
  %y = fdiv float 1.0, %x
  %z = fadd float %y, 1.0
  br label %end
end:
  %r = phi float [ %x, %entry ], [ %z, %positive ]
  ret float %r
}
