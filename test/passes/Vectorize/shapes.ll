; Which values differ between lanes, how, and where lanes part and meet.
; RUN: opt -load-pass-plugin=%plugin -passes='print<anysl-shapes>' -disable-output %s 2>&1 | FileCheck --check-prefix=VALUES %s
; RUN: opt -load-pass-plugin=%plugin -passes='anysl-normalize,print<anysl-shapes>' -disable-output %s 2>&1 | FileCheck %s

; Strides survive what is exact: a linear argument does not wrap, nor does arithmetic that says so.
; VALUES-LABEL: shapes of strides, 8 lanes
; VALUES-NEXT: p: uniform
; VALUES-NEXT: i: stride 1
; VALUES-NEXT: x: varying
; VALUES: wide: stride 1
; VALUES-NEXT: plus: stride 1
; VALUES-NEXT: exact: stride 1
; VALUES-NEXT: wraps: stride 1
; VALUES-NEXT: unknown: varying
; VALUES-NEXT: times: stride 12
; VALUES-NEXT: next: stride 4
; VALUES-NEXT: record: stride 12
; VALUES-NEXT: gather: varying
; VALUES-NEXT: same: uniform
; VALUES-NEXT: loaded: uniform
; VALUES-NEXT: row: varying
; VALUES-NEXT: test: varying
define float @strides(ptr %p, i32 %i, i32 %x) "_ZGV_LLVM_N8ulv_strides" {
  %wide = sext i32 %i to i64
  %plus = add nsw i32 %i, 5
  %exact = sext i32 %plus to i64
  %wraps = add i32 %i, 5
  %unknown = sext i32 %wraps to i64
  %times = mul nsw i64 %wide, 12
  %next = getelementptr float, ptr %p, i64 %exact
  %record = getelementptr i8, ptr %p, i64 %times
  %gather = getelementptr float, ptr %p, i64 %unknown
  %same = getelementptr float, ptr %p, i64 7
  %loaded = load float, ptr %same
  %row = load float, ptr %next
  %test = icmp slt i32 %i, 100
  %other = load float, ptr %record
  %third = load float, ptr %gather
  %sum = fadd float %loaded, %row
  %sum2 = fadd float %sum, %other
  %sum3 = fadd float %sum2, %third
  %chosen = select i1 %test, float %sum3, float %row
  ret float %chosen
}

; After a divergent branch, a phi of uniform values varies; after a uniform one it does not.
; CHECK-LABEL: shapes of joins
; CHECK: entry:
; CHECK-NOT: lanes
; CHECK: meet:
; CHECK-NEXT: a: uniform
; CHECK: then:
; CHECK: last: lanes meet
; CHECK-NEXT: b: varying
define i32 @joins(ptr %p, i32 %n, i32 %x) "_ZGV_LLVM_N8uuv_joins" {
entry:
  %c = icmp sgt i32 %n, 0
  br i1 %c, label %one, label %meet
one:
  store volatile i32 1, ptr %p
  br label %meet
meet:
  %a = phi i32 [ 1, %one ], [ 2, %entry ]
  %d = icmp sgt i32 %x, 0
  br i1 %d, label %then, label %last
then:
  store volatile i32 2, ptr %p
  br label %last
last:
  %b = phi i32 [ %a, %then ], [ 7, %meet ]
  ret i32 %b
}

; A counter is uniform inside a loop that lanes leave at different times, and varies behind it.
; CHECK-LABEL: shapes of count
; CHECK: loop: divergent loop lanes part
; CHECK-NEXT: k: uniform
; CHECK-NEXT: next: uniform
; CHECK: out: lanes meet
; CHECK-NEXT: {{.*}}: varying
define i32 @count(i32 %x) "_ZGV_LLVM_N8v_count" {
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

; A uniform exit under a divergent branch makes a loop divergent.
; CHECK-LABEL: shapes of hidden
; CHECK: loop: divergent loop lanes part
define void @hidden(ptr %p, i32 %n, i32 %x) "_ZGV_LLVM_N8uuv_hidden" {
entry:
  br label %loop
loop:
  %k = phi i32 [ 0, %entry ], [ %next, %latch ]
  %c = icmp slt i32 %x, %k
  br i1 %c, label %inner, label %latch
inner:
  %d = icmp eq i32 %n, %k
  store volatile i32 2, ptr %p
  br i1 %d, label %out, label %latch
latch:
  %next = add i32 %k, 1
  %e = icmp slt i32 %next, 50
  br i1 %e, label %loop, label %out
out:
  ret void
}

; With a stride comes an alignment of lane 0: of pointers as declared or assumed, of indices by arithmetic.
; VALUES-LABEL: shapes of alignments, 8 lanes
; VALUES-NEXT: p: stride 4, aligned to 64
; VALUES-NEXT: q: uniform
; VALUES-NEXT: r: uniform, aligned to 32
; VALUES-NEXT: i: stride 1
; VALUES-NEXT: n: uniform
; VALUES-NEXT: entry:
; VALUES-NEXT: half: stride 4, aligned to 32
; VALUES-NEXT: odd: stride 4, aligned to 4
; VALUES-NEXT: row: uniform
; VALUES-NEXT: line: stride 4, aligned to 32
; VALUES-NEXT: assumed: uniform
; VALUES-NEXT: bytes: uniform
; VALUES-NEXT: known: stride 4, aligned to 16
; VALUES-NEXT: unknown: stride 4{{$}}
; VALUES-NEXT: scaled: stride 16, aligned to 16
; VALUES-NEXT: own: stride 64, aligned to 64
define void @alignments(ptr %p, ptr %q, ptr %r, i64 %i, i64 %n) "_ZGV_LLVM_N8l4a64uua32lu_alignments" {
entry:
  %half = getelementptr i8, ptr %p, i64 -32
  %odd = getelementptr i8, ptr %half, i64 4
  %row = mul i64 %n, 8
  %line = getelementptr float, ptr %p, i64 %row
  %assumed = getelementptr float, ptr %q, i64 %n
  call void @llvm.assume(i1 true) [ "align"(ptr %assumed, i64 16) ]
  %bytes = ptrtoint ptr %assumed to i64
  %known = getelementptr i8, ptr %p, i64 %bytes
  %unknown = getelementptr float, ptr %q, i64 %i
  %scaled = mul i64 %i, 16
  %own = alloca [3 x i8], align 64
  ret void
}
