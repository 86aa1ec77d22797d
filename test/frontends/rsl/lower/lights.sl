// illuminance is a loop over the lights; illuminate and solar set L and test their cone.
// RUN: rslc -S -o - %s | FileCheck %s

// A function that is called inside of illuminance sees the light of the loop.
color lambert(normal n) { extern vector L; extern color Cl; return Cl * max(0, normalize(L) . n); }

surface lit(float nolight = 1) {
  normal Nf = normalize(N);
  Ci = 0;
  // CHECK: [[COUNT:%[0-9]+]] = call i32 @anysl_light_count(ptr %ctx)
  // CHECK: %light = phi i32 [ 0, %entry ], [ [[NEXT:%[0-9]+]], %light.next ]
  // CHECK: icmp ult i32 %light, [[COUNT]]
  // CHECK: [[HIT:%[0-9]+]] = call i1 @anysl_light_sample(ptr %ctx, i32 %light, ptr [[P:%[0-9]+]], ptr [[N:%[0-9]+]], ptr %L, ptr %Cl, ptr %Ol)
  // CHECK: [[IN:%[0-9]+]] = call i1 @anysl_in_cone(ptr %L, ptr [[N]], ptr %{{[0-9]+}})
  // CHECK: and i1 [[HIT]], [[IN]]
  // CHECK: call void @anysl_light_shadow(ptr %ctx, i32 %light, ptr [[P]], ptr %L, ptr %Cl)
  // CHECK: normalize(ptr [[UNIT:%[0-9]+]], ptr %L)
  // CHECK: light.next:
  // CHECK: [[NEXT]] = add i32 %light, 1
  illuminance(P, Nf, PI / 2) {
    Ci += lambert(Nf);
    if (comp(Ci, 0) > 10)
      break;
  }
  // CHECK: light.belongs:
  // CHECK: call i1 @anysl_light_in_category(ptr %ctx, i32 %light{{[0-9]*}}, ptr %{{[0-9]+}})
  illuminance("-key", P) Ci += Cl;
  // CHECK-NOT: load_global_vector(ptr %L
}

light spot(float intensity = 1; color lightcolor = 1; point from = point "shader" (0, 0, 0);
           vector axis = (0, 0, 1); float angle = 0.5) {
  // CHECK-LABEL: define void @spot(
  // CHECK: copy_vector(ptr %L
  // CHECK: sub_vector(ptr [[TO:%[0-9]+]], ptr %Ps, ptr %from)
  // CHECK: in_cone(ptr [[TO]], ptr %{{[0-9]+}}, ptr %{{[0-9]+}})
  // CHECK: lit:
  // CHECK: copy_vector(ptr %L, ptr [[TO]])
  illuminate(from, axis, angle) {
    Cl = intensity * lightcolor / (L . L);
  }
  // CHECK: eq_vector(ptr %L
  // CHECK: unlit:
  // CHECK: copy_color(ptr %Cl
  // CHECK: store_global_vector(ptr %ctx, i32 20, ptr %L)
  // CHECK: store_global_color(ptr %ctx, i32 21, ptr %Cl)
}

// CHECK-LABEL: define void @spot.init(
// CHECK: space_matrix(ptr [[M:%[0-9]+]], ptr %ctx
// CHECK: transform_point(ptr %{{[0-9]+}}, ptr [[M]], ptr

light sun(vector to = (0, -1, 0)) {
  // CHECK-LABEL: define void @sun(
  // CHECK: solar_direction(ptr [[TO:%[0-9]+]], ptr %{{[0-9]+}})
  // CHECK: copy_vector(ptr %L, ptr [[TO]])
  solar(to, 0) { Cl = 1; }
}

// CHECK: !{!"spot", !"light", ptr @spot, ptr @spot.init
