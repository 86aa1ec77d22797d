// A library linked for a scene refuses a scene that calls for more, with the reason, or a general library takes its place.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: rslc %S/../Link/Inputs/effects.sl -o effects.stc.bc
// RUN: echo '{"complete": true, "shutter": [2, 2], "shaders": {"effects": {"parameters": {"Kd": 0.1}}}, "rayDepth": 4}' > scene.json
// RUN: anysl-link effects.stc.bc -o small.so --scene scene.json --width 1
// RUN: anysl-link effects.stc.bc -o general.so --width 1
// RUN: echo '{"outputs": ["Oi", "dots"], "asked": []}' > shadow.json
// RUN: anysl-link effects.stc.bc -o shadow.so --scene shadow.json --width 1
// RUN: echo '{"lights": [{"kind": "pointlight", "from": [0, 5, 0]}], "shaders": {"effects": {}}}' > lit.json
// RUN: anysl-link effects.stc.bc -o lit.so --scene lit.json --width 1
// RUN: echo '{"globals": {"Cs": [0.5, 0.1, 1]}, "lights": [{"kind": "ambientlight", "color": [1, 0, 0]}], "shaders": {}}' > fixed.json
// RUN: printf 'surface fixed() { Ci = Cs * ambient(); Oi = Os; }' > fixed.sl && rslc fixed.sl -o fixed.stc.bc && anysl-link fixed.stc.bc -o fixed.so --scene fixed.json --width 1
// RUN: clang -std=c99 -Wall -Werror %anysl_include %s %lib_dir/libanysl.a -lstdc++ -lm -o demand
// RUN: ./demand | FileCheck %s
// UNSUPPORTED: sanitizer

#include <anysl/demand.h>
#include <stdio.h>
#include <string.h>

static void show(const char *what, AnyslStatus status) {
  printf("%s: %s\n", what, status ? anysl_last_error() : "yes");
}

int main(void) {
  AnyslLibrary *small, *general;
  if (anysl_library_open("small.so", 0, &small) || anysl_library_open("general.so", 0, &general))
    return 1;
  const AnyslDemandInfo *demand = anysl_library_demand(small);
  // CHECK: general is for all scenes: 1
  printf("general is for all scenes: %d\n", !anysl_library_demand(general));
  // CHECK: {"shaders": {"effects": {"complete": true, "parameters": {"Kd": 0.1}}}, "outputs": ["Ci", "Oi"]
  puts(demand->manifest);
  // CHECK: dots,mirrored
  puts(demand->dropped_outputs);

  AnyslSceneFacts facts;
  memset(&facts, 0, sizeof facts);
  facts.struct_size = sizeof facts;
  facts.time = 2;
  // CHECK: the same: yes
  show("the same", anysl_library_allows(small, &facts));
  facts.has = 1u << ANYSL_ASSUMES_NO_TRACED_RAYS;
  // CHECK: rays: yes
  show("rays", anysl_library_allows(small, &facts));
  facts.has = 1u << ANYSL_ASSUMES_NO_LIGHTS;
  // CHECK: lights: small.so: the library was linked for a scene without lights, and this one has them
  show("lights", anysl_library_allows(small, &facts));
  // CHECK: lights, in general: yes
  show("lights, in general", anysl_library_allows(general, &facts));
  AnyslLibrary *either = NULL;
  // CHECK: open: small.so: the library was linked for a scene without lights
  show("open", anysl_library_open_for("small.so", NULL, &facts, &either));
  // CHECK: fall back: yes
  // CHECK-NEXT: general
  show("fall back", anysl_library_open_for("small.so", "general.so", &facts, &either));
  printf("%s\n", anysl_library_demand(either) ? "special" : "general");
  anysl_library_close(either);
  facts.has = 0;
  // CHECK: special
  show("open", anysl_library_open_for("small.so", "general.so", &facts, &either));
  printf("%s\n", anysl_library_demand(either) ? "special" : "general");
  anysl_library_close(either);
  // What shows opacity alone is refused where light is wanted, which it is unless only the other is.
  AnyslLibrary *shadow;
  AnyslInstance *instance;
  AnyslBatch *batch;
  if (anysl_library_open("shadow.so", 0, &shadow) || anysl_instance_create(shadow, "effects", NULL, NULL, &instance) ||
      anysl_batch_create(instance, 4, 0, &batch))
    return 1;
  // CHECK: dropped: Ci,mirrored
  printf("dropped: %s\n", anysl_library_demand(shadow)->dropped_outputs);
  // CHECK: light: shadow.so: the library was linked for a scene that does not show 'Ci', and this one does
  show("light", anysl_library_allows(shadow, &facts));
  const char *opacity[] = {"Oi", "dots", NULL};
  facts.outputs = opacity;
  // CHECK: opacity: yes
  show("opacity", anysl_library_allows(shadow, &facts));
  // CHECK: wanted: yes
  show("wanted", anysl_batch_want_output(batch, "dots"));
  // CHECK: wanted: shadow.so: the library was linked for a scene that does not show 'mirrored', and this one does
  show("wanted", anysl_batch_want_output(batch, "mirrored"));
  anysl_batch_free(batch);
  anysl_instance_free(instance);
  anysl_library_close(shadow);
  const char *outputs[] = {"Ci", "dots", NULL};
  facts.outputs = outputs;
  // CHECK: output: small.so: the library was linked for a scene that does not show 'dots', and this one does
  show("output", anysl_library_allows(small, &facts));
  facts.outputs = NULL;
  facts.time = 3;
  // CHECK: time: small.so: the library was linked for a scene at time 2.000000, and this one is at time 3.000000
  show("time", anysl_library_allows(small, &facts));

  // The lights that are linked in have to be the scene's.
  AnyslLibrary *lit;
  AnyslLight lights[2];
  AnyslStandardLight values;
  if (anysl_library_open("lit.so", 0, &lit))
    return 1;
  anysl_standard_light_defaults(&values);
  values.from[1] = 5;
  anysl_light_standard(ANYSL_LIGHT_POINT, &values, &lights[0]);
  anysl_light_standard(ANYSL_LIGHT_SPOT, &values, &lights[1]);
  memset(&facts, 0, sizeof facts);
  facts.struct_size = sizeof facts;
  // CHECK: linked in: 1 of kind 2
  printf("linked in: %u of kind %u\n", anysl_library_demand(lit)->light_count,
         anysl_library_demand(lit)->lights[0].light.kind);
  // CHECK: no light: lit.so: the library was linked for a scene with 1 light, and this one has 0
  show("no light", anysl_library_allows(lit, &facts));
  facts.lights = lights;
  facts.light_count = 1;
  // CHECK: the light: yes
  show("the light", anysl_library_allows(lit, &facts));
  facts.light_count = 2;
  // CHECK: two lights: lit.so: the library was linked for a scene with 1 light, and this one has 2
  show("two lights", anysl_library_allows(lit, &facts));
  facts.lights = lights + 1;
  facts.light_count = 1;
  // CHECK: a spot light: lit.so: the library was linked for a scene whose light 1 is a point light, and here it is a spot light
  show("a spot light", anysl_library_allows(lit, &facts));
  // CHECK: fall back: yes
  // CHECK-NEXT: general
  show("fall back", anysl_library_open_for("lit.so", "general.so", &facts, &either));
  printf("%s\n", anysl_library_demand(either) ? "special" : "general");
  anysl_library_close(either);
  facts.lights = lights;
  lights[0].from[0] = 1;
  // CHECK: a light elsewhere: lit.so: the library was linked for a scene whose light 1 has another position than here
  show("a light elsewhere", anysl_library_allows(lit, &facts));
  facts.struct_size = 8; // a host from before there were any to be asked for
  // CHECK: a host that says nothing: lit.so: the library was linked for a scene with 1 light, and this one has 0
  show("a host that says nothing", anysl_library_allows(lit, &facts));
  // Shading looks as well.
  AnyslInstance *shader;
  AnyslBatch *points;
  if (anysl_instance_create(lit, NULL, NULL, NULL, &shader) ||
      anysl_batch_create(shader, 1, 0, &points))
    return 1;
  // CHECK: shade without: lit.so: the library was linked for a scene with 1 light, and this one has 0
  show("shade without", anysl_shade(shader, points, 0, 1, 0));
  anysl_batch_set_lights(points, lights, 1, NULL);
  // CHECK: shade elsewhere: lit.so: the library was linked for a scene whose light 1 has another position than here
  show("shade elsewhere", anysl_shade(shader, points, 0, 1, 0));
  lights[0].from[0] = 0;
  // CHECK: shade: yes
  show("shade", anysl_shade(shader, points, 0, 1, 0));
  anysl_batch_free(points);
  anysl_instance_free(shader);
  anysl_library_close(lit);

  // A global that is the same everywhere, and the sum of ambient lights, are what they are.
  AnyslLibrary *fixed;
  float colors[6] = {0.5f, 0.1f, 1, 0.5f, 0.1f, 0}, ambient[3] = {1, 0, 0}, result[3];
  if (anysl_library_open("fixed.so", 0, &fixed) || anysl_instance_create(fixed, NULL, NULL, NULL, &shader) ||
      anysl_batch_create(shader, 2, 0, &points))
    return 1;
  // CHECK: the colour: yes
  show("the colour", anysl_batch_write_float(points, ANYSL_Cs, 0, 1, colors, 3));
  // CHECK: another colour: fixed.so: {{.*}}the library was linked for a scene where 'Cs' is the same everywhere, and here it is another
  show("another colour", anysl_batch_write_float(points, ANYSL_Cs, 0, 2, colors, 3));
  // CHECK: no ambient light: fixed.so: the library was linked for a scene whose ambient lights add up to other light than here
  show("no ambient light", anysl_shade(shader, points, 0, 1, 0));
  anysl_batch_set_lights(points, NULL, 0, ambient);
  // CHECK: ambient light: yes
  // CHECK-NEXT: 0.5 0 0
  show("ambient light", anysl_shade(shader, points, 0, 1, 0));
  anysl_batch_read_float(points, ANYSL_Ci, 0, 1, result, 3);
  printf("%g %g %g\n", (double)result[0], (double)result[1], (double)result[2]);
  memset(&facts, 0, sizeof facts);
  facts.struct_size = sizeof facts;
  // CHECK: asked: fixed.so: the library was linked for a scene whose ambient lights add up to other light than here
  show("asked", anysl_library_allows(fixed, &facts));
  memcpy(facts.ambient, ambient, sizeof ambient);
  // CHECK: asked: yes
  show("asked", anysl_library_allows(fixed, &facts));
  anysl_batch_free(points);
  anysl_instance_free(shader);
  anysl_library_close(fixed);

  if (anysl_instance_create(small, "effects", NULL, NULL, &instance))
    return 1;
  double value = 0.1, other = 0.2;
  const char *none = "", *some = "grid.tex";
  // A constant of the library may be set to what it is.
  // CHECK: Kd = 0.1: yes
  show("Kd = 0.1", anysl_instance_set_numbers(instance, "Kd", &value, 1));
  // CHECK: Kd = 0.2: small.so: shader 'effects': parameter 'Kd' was fixed when the library was linked
  show("Kd = 0.2", anysl_instance_set_numbers(instance, "Kd", &other, 1));
  // CHECK: tex = "": yes
  show("tex = \"\"", anysl_instance_set_strings(instance, "tex", &none, 1));
  // CHECK: tex = "grid.tex": small.so: shader 'effects': parameter 'tex' was fixed when the library was linked
  show("tex = \"grid.tex\"", anysl_instance_set_strings(instance, "tex", &some, 1));
  anysl_instance_free(instance);
  anysl_library_close(small);
  anysl_library_close(general);
  return 0;
}
