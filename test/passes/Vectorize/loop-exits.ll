; Exits that meet after an operation or two become one, and the loop keeps one value for all of them.
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-normalize' -S %s | FileCheck %s
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-normalize,verify,print<anysl-schedule>' -disable-output %s 2>&1 | FileCheck --check-prefix=MASKS %s

; As clang unrolls: one exit for each copy of the body, each of which counts on.
; CHECK-LABEL: define i32 @unrolled(
; CHECK: or disjoint i32 %k, 1
; CHECK: br i1 %{{.*}}, label %[[EXIT:.*]], label
; CHECK: [[EXIT]]:
; CHECK-NEXT: phi i32
; CHECK-NOT: add
; CHECK: ret i32
; MASKS-LABEL: schedule of unrolled
; MASKS-NOT: mask of {{.*}} without
; MASKS: out: full, mask of entry
define i32 @unrolled(i32 %x) "_ZGV_LLVM_N8v_unrolled" {
entry:
  br label %body
body:
  %k = phi i32 [ 0, %entry ], [ %next, %second ]
  %s = phi i32 [ %x, %entry ], [ %b, %second ]
  %a = mul i32 %s, 1664525
  %c = icmp slt i32 %a, 0
  br i1 %c, label %one, label %second
second:
  %b = mul i32 %a, 1664525
  %next = add i32 %k, 2
  %d = icmp slt i32 %b, 0
  br i1 %d, label %two, label %body
one:
  br label %out
two:
  %after = or disjoint i32 %k, 1
  br label %out
out:
  %r = phi i32 [ %k, %one ], [ %after, %two ]
  ret i32 %r
}

; What takes long is not done in each iteration in place of once.
; CHECK-LABEL: define i32 @divides(
; CHECK: two:
; CHECK: udiv i32
; CHECK: br label %out
define i32 @divides(i32 %x) "_ZGV_LLVM_N8v_divides" {
entry:
  br label %body
body:
  %k = phi i32 [ 0, %entry ], [ %next, %second ]
  %s = phi i32 [ %x, %entry ], [ %b, %second ]
  %a = mul i32 %s, 1664525
  %c = icmp slt i32 %a, 0
  br i1 %c, label %one, label %second
second:
  %b = mul i32 %a, 1664525
  %next = add i32 %k, 2
  %d = icmp slt i32 %b, 0
  br i1 %d, label %two, label %body
one:
  br label %out
two:
  %after = udiv i32 %b, 10
  br label %out
out:
  %r = phi i32 [ %k, %one ], [ %after, %two ]
  ret i32 %r
}

; Nor what must not happen if the loop goes on.
; CHECK-LABEL: define i32 @stores(
; CHECK: two:
; CHECK: store i32
; CHECK: br label %out
define i32 @stores(ptr %p, i32 %x) "_ZGV_LLVM_N8uv_stores" {
entry:
  br label %body
body:
  %k = phi i32 [ 0, %entry ], [ %next, %second ]
  %s = phi i32 [ %x, %entry ], [ %b, %second ]
  %a = mul i32 %s, 1664525
  %c = icmp slt i32 %a, 0
  br i1 %c, label %one, label %second
second:
  %b = mul i32 %a, 1664525
  %next = add i32 %k, 2
  %d = icmp slt i32 %b, 0
  br i1 %d, label %two, label %body
one:
  br label %out
two:
  store i32 1, ptr %p
  br label %out
out:
  %r = phi i32 [ %k, %one ], [ %b, %two ]
  ret i32 %r
}
