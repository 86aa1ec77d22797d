/* What a runtime does not offer but may decline: a neutral value with a warning at the line, or an error.

RUN: rslc %s -o %t.stc.bc
RUN: anysl-link %t.stc.bc --width 1,8 -o %t.so 2>&1 | FileCheck %s --check-prefix=WARNING
RUN: anysl-shade %t.so --grid 5x1 --width 1 --print Ci --print Oi --print ok | FileCheck %s
RUN: anysl-shade %t.so --grid 5x1 --width 8 --print Ci --print Oi --print ok | FileCheck %s
RUN: not anysl-link %t.stc.bc --decline=error -o %t.error.so 2>&1 | FileCheck %s --check-prefix=ERROR
RUN: not ls %t.error.so
RUN: not anysl-link %t.stc.bc --decline=never -o %t.error.so 2>&1 | FileCheck %s --check-prefix=OPTION
OPTION: error: --decline=never: there are neutral and error

Arguments of any number are taken, and their effects happen.
CHECK-COUNT-5: Ci 2 2 3  Oi 0 0 0  ok 7
*/

surface declined(string file = "a.pm"; output varying float ok = 0) {
  color found = 1;
  // WARNING: declined.sl:[[#@LINE+3]]:8: warning: runtime 'packet' does not offer 'photonmap' (shader 'declined'): no light [-Wdeclined]
  // WARNING-NEXT: Ci = photonmap
  // ERROR: declined.sl:[[#@LINE+1]]:8: error: runtime 'packet' does not offer 'photonmap' (shader 'declined')
  Ci = photonmap(file, P, N, "filter", "none") + caustic(P, N) + color subsurface(P, N, "samples", 4);
  ok = 7 * (1 - bake3d(file, "a,b", P, N, "occ", 3, "rad", Cs));
  // WARNING: declined.sl:[[#@LINE+1]]:{{.*}} 'texture3d' {{.*}}: nothing is found, and the variables stay as they are
  ok += texture3d(file, P, N, "rad", found);
  normal changed = N + bump("bumps"[2], N, dPdu, dPdv, s, t);
  // Each place is named.
  // WARNING: declined.sl:[[#@LINE+1]]:{{.*}} 'photonmap'
  Ci += photonmap("b.pm", P, N, "estimator", ok = 7) + found + visibility(P, P) + color changed;
  Ci += areashadow("map", P, "blur", 0.1);
  // Files of light and occlusion are told from rays by the first argument.
  // WARNING: declined.sl:[[#@LINE+1]]:{{.*}} 'occlusion_file' {{.*}}: nothing is hidden
  Ci += occlusion("a.tex", P, N, 16) + indirectdiffuse("b.env", N) + color indirect("c.ptc", "_radiosity", P, N, I);
  Ci += bake3d_diffuse("d.ptc", P, N, Cs, area(P)) + bake3d_nondiffuse("n.ptc", P, N, Cs, 1, "phong", 20);
  Ci += bake3d_brdf("b.ptc", P, N, I, "diffuse_ptc", file) + rayserver_photon(P, I, N, vector(0, 0, 1));
  Oi = hair() + directlighting() + bake("c", s, t, Cs);
}
