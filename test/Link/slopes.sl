// A lookup in a picture asks how the picture changes only where somebody reads that in the end.
// RUN: rslc %s -o %t.stc.bc
// RUN: anysl-link %t.stc.bc --width 8 --dump-after optimize -o %t.so | FileCheck %s

// CHECK: call void @packet_texture({{[^,]*}}, i32 {{[^,]*}}, i32 noundef 256,
// CHECK: call void @packet_texture({{[^,]*}}, i32 {{[^,]*}}, i32 noundef 65792,
// CHECK: call void @packet_texture({{[^,]*}}, i32 {{[^,]*}}, i32 noundef 256,
surface slopes(output varying float value = 0, steep = 0, even = 0) {
  value = texture("a.tx", s, t);
  steep = Du(float texture("b.tx", s, t));
  // It does not change with v.
  even = Dv(float texture("c.tx", u, 0.5));
}
