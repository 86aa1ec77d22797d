// An overload is chosen by its arguments and by what the context wants.
// RUN: rslc -S -o - %s | FileCheck %s

float pick(float x) { return 10; }
color pick(float x) { return 20; }
float kind(point p) { return 1; }
float kind(color c) { return 2; }
float mine(string s) { return 3; }
float abs(string s) { return 4; }

surface overloads() {
  // CHECK: call void @anysl_noise_color_3(
  Ci = noise(P);
  // CHECK: call void @anysl_noise_float_3(
  float f = noise(P);
  // CHECK: call void @anysl_noise_float_3(
  Oi = float noise(P);
  // CHECK: call void @anysl_noise_vector_3(
  P += noise(P);
  // CHECK: call void @anysl_noise_color_2(
  Ci = 2 * noise(s, t);
  // CHECK: call void @anysl_noise_float_1(
  f = smoothstep(0, 1, noise(s));
  // CHECK: call void @anysl_noise_float_4(
  if (noise(P, time) < 0.5) f = 1;
  // CHECK: call void @anysl_noise_color_3(
  Ci = Cs * noise(P);
  // CHECK: call void @anysl_noise_float_3(
  Ci = mix(Cs, Os, noise(P));
  // CHECK: call void @anysl_mix_color(
  // CHECK: call void @anysl_noise_vector_3(
  // CHECK: call void @anysl_length(
  f = length(noise(P));
  // CHECK: call void @anysl_noise_color_3(
  // CHECK: call void @anysl_noise_color_3(
  Ci = s > 0.5 ? noise(P) : noise(2 * P);
  // CHECK: call void @anysl_trace_float(
  f = trace(P, I);
  // CHECK: call void @anysl_trace_color(
  Ci = trace(P, I);
  // CHECK: call void @anysl_random_color(
  Ci = random();
  // CHECK: call void @anysl_max_float(
  // CHECK: call void @anysl_max_float(
  f = max(s, t, u);
  // CHECK: call void @anysl_max_color(
  Ci = max(Cs, 0);
  // CHECK: call void @anysl_min_float(
  Ci = min(1, s);
  // CHECK: double 1.000000e+01
  f = pick(1);
  // CHECK: double 2.000000e+01
  Ci = pick(1);
  // CHECK: double 1.000000e+00
  f = kind(N);
  // CHECK: double 2.000000e+00
  f = kind(Cs);
  // A function goes before a built-in of its name, where it fits.
  // CHECK: double 4.000000e+00
  f = abs("x");
  // CHECK: call void @anysl_abs(
  f = abs(-1);
  // CHECK: call void @anysl_make_color(
  Ci = (s, t, 0);
  // CHECK: call void @anysl_make_vector(
  P = P + (0, 1, 0);
  // CHECK: call void @anysl_get_color(
  f = comp(Cs, 1);
  // CHECK: call void @anysl_get_vector(
  f = comp(P, 1);
}
