// Globals are loaded where some way may read them before they are written, and stored where they are written.
// RUN: rslc -S -o - %s | FileCheck %s

surface globals() {
  // CHECK-LABEL: define void @globals(
  // CHECK-NOT: load_global
  // CHECK: load_global_vector(ptr %P, ptr %ctx, i32 0)
  // The way out in the middle leaves N as it was.
  // CHECK-NEXT: load_global_vector(ptr %N, ptr %ctx, i32 1)
  // CHECK-NEXT: load_global_vector(ptr %Ng, ptr %ctx, i32 2)
  // CHECK-NEXT: load_global_color(ptr %Cs, ptr %ctx, i32 4)
  // CHECK-NEXT: load_global_color(ptr %Oi, ptr %ctx, i32 7)
  // CHECK-NEXT: load_global_float(ptr %s, ptr %ctx, i32 10)
  // CHECK-NEXT: copy_color(ptr %Ci, ptr %Cs)
  Ci = Cs;
  if (s > 0.5) {
    Oi = 0.5;
    // Both ways out pass the stores.
    return;
  }
  N = Ng;
  P += N;
  // CHECK: store_global_vector(ptr %ctx, i32 0, ptr %P)
  // CHECK-NEXT: store_global_vector(ptr %ctx, i32 1, ptr %N)
  // CHECK-NEXT: store_global_color(ptr %ctx, i32 6, ptr %Ci)
  // CHECK-NEXT: store_global_color(ptr %ctx, i32 7, ptr %Oi)
  // CHECK-NEXT: ret void
}

// CHECK: !{!"globals", !"surface", ptr @globals, ptr @globals.init, ![[PARAMS:[0-9]+]], ![[GLOBALS:[0-9]+]]}
// CHECK: ![[GLOBALS]] = !{![[P:[0-9]+]], ![[N:[0-9]+]], ![[NG:[0-9]+]], ![[CS:[0-9]+]], ![[CI:[0-9]+]], ![[OI:[0-9]+]], ![[S:[0-9]+]]}
// CHECK-DAG: ![[P]] = !{i32 0, i1 true, i1 true}
// CHECK-DAG: ![[NG]] = !{i32 2, i1 true, i1 false}
// CHECK-DAG: ![[CI]] = !{i32 6, i1 false, i1 true}
// CHECK-DAG: ![[OI]] = !{i32 7, i1 true, i1 true}
