// rslc --library: functions become the operators that built-ins of their name and signature stand for.
// RUN: rslc --library -S -o - %s | FileCheck %s

float square(float x) { return x * x; }

// CHECK: define void @anysl_length(ptr %result, ptr %v)
// CHECK: call void @anysl_mul_float
// CHECK: call void @anysl_sqrt
float length(vector v) { return sqrt(square(v[0]) + square(v[1]) + square(v[2])); }

// CHECK: define void @anysl_normalize(
// CHECK: call void @anysl_length(
vector normalize(vector v) { return v / length(v); }

// CHECK: define void @anysl_mix_color(
color mix(color a; color b; float x) { return (1 - x) * a + x * b; }

// A plain `P` is the operator's operand, although the signature of diffuse(N) does not show it.
// CHECK: define void @anysl_diffuse(ptr %result, ptr %ctx, ptr %P, ptr %N)
// CHECK-NOT: load_global
// CHECK: call i1 @anysl_light_sample(ptr %ctx, i32 %light, ptr [[P:%[0-9]+]], ptr [[N:%[0-9]+]], ptr %L, ptr %Cl, ptr %Ol)
// CHECK: call i1 @anysl_light_is_nondiffuse(ptr %ctx, i32 %light, ptr [[P]], ptr [[N]])
color diffuse(normal N) {
  color sum = 0;
  illuminance(P, N, PI / 2)
    if (!__light_is_nondiffuse())
      sum += Cl * (normalize(L) . N);
  return sum;
}

// Outputs are written at the end.
// CHECK: define void @anysl_fresnel(ptr %I, ptr %N, ptr %eta, ptr %Kr, ptr %Kt, ptr %R, ptr %T)
// CHECK: copy_float(ptr %Kr, ptr
// CHECK: copy_float(ptr %Kt, ptr
// CHECK: copy_vector(ptr %R, ptr
// CHECK: copy_vector(ptr %T, ptr
// CHECK: ret void
void fresnel(vector I; vector N; float eta; output float Kr; output float Kt; output vector R; output vector T) {
  Kr = 1; Kt = 0; R = reflect(I, N); T = 0;
}
