// What the front end wrote and what the linker made of it tell the same of a shader.
//
// RUN: rslc %s -o %t.stc.bc
// RUN: anysl-info %t.stc.bc | FileCheck %s --check-prefixes=BOTH,STC
// RUN: anysl-link %t.stc.bc --width 1,8 --param described.Kr=0.25 -o %t.so
// RUN: anysl-info %t.so | FileCheck %s --check-prefixes=BOTH,LIBRARY
//
// STC:     {{.*}}.stc.bc: subroutine-threaded code, made by rslc {{[0-9.]+}}
// LIBRARY: {{.*}}.so: shader library, made by AnySL {{[0-9.]+}}
// LIBRARY: runtime packet, layout SoA
// LIBRARY: real float
// LIBRARY: math u10
// LIBRARY: runs here yes
// BOTH:    surface described
// LIBRARY: widths 1 8
// BOTH:    reads P N I s{{$}}
// BOTH:    writes Ci{{$}}
// BOTH:    services Lights Trace
// STC:     parameters uniform float Ka{{$}}
// LIBRARY: parameters uniform float Ka = 0.5{{$}}
// LIBRARY: uniform float Kr = 0.25 (fixed by anysl-link)
// BOTH:    uniform color tint
// LIBRARY-SAME: = (0.5, 0.5, 0.5)
// BOTH:    uniform string name
// LIBRARY-SAME: = "a \22quoted\22 name"
// BOTH:    varying point knots[2]
// LIBRARY-SAME: = {(0, 0, 0), (1, 2, 3)}
// BOTH:    output varying float depth
//
// The two forms as JSON, compared field by field.
// RUN: anysl-info --json %t.stc.bc > %t.stc.json
// RUN: anysl-info --json %t.so > %t.so.json
// RUN: python3 -c "import json; stc, so = (json.load(open('%t.%%s.json' %% form)) for form in ('stc', 'so')); \
// RUN:   a, b = stc['shaders'][0], so['shaders'][0]; \
// RUN:   assert all(a[key] == b[key] for key in ('name', 'kind', 'globals_read', 'globals_written')); \
// RUN:   defaults = [p.pop('default') for p in b['parameters']]; \
// RUN:   b['parameters'][1]['fixed'] = False; \
// RUN:   assert a['parameters'] == b['parameters']; \
// RUN:   assert defaults[3] == ['a \"quoted\" name'] and defaults[4] == [0, 0, 0, 1, 2, 3]"

surface described(float Ka = 0.5, Kr = 1; color tint = Ka; string name = "a \"quoted\" name";
                  varying point knots[2] = {0, point(1, 2, 3)}; output varying float depth = 0;) {
  depth = distance(knots[0], knots[1]);
  Ci = tint * (Ka * ambient() + diffuse(normalize(N))) + Kr * color trace(P, reflect(I, N));
  if (name == "left")
    Ci *= s;
}
