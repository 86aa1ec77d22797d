; A loop entered at two blocks, from one of which a branch on a value that the other chooses leads to either.
; RUN: opt -load-pass-plugin=%plugin -passes=anysl-vectorize -S %s | FileCheck %s
; CHECK: define <4 x i32> @_ZGV_LLVM_N4v_twice(
define i32 @twice(i32 %x) "_ZGV_LLVM_N4v_twice" {
entry:
  %start = icmp sgt i32 %x, 3
  br i1 %start, label %second, label %first
latch:
  br i1 %again, label %first, label %second
first:
  %n1 = phi i32 [ %x, %entry ], [ %less, %latch ]
  %doubled = shl i32 %n1, 1
  br label %second
second:
  %n2 = phi i32 [ %x, %entry ], [ %less, %latch ], [ %doubled, %first ]
  %again = phi i1 [ %start, %entry ], [ %again, %latch ], [ false, %first ]
  %less = sub i32 %n2, 7
  %more = icmp sgt i32 %less, 0
  br i1 %more, label %latch, label %end
end:
  ret i32 %less
}
