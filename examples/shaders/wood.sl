// wood.sl: turned wood with growth rings and grain.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Rings are cylinders about the shader's y axis, disturbed by slow noise; the grain is fast noise drawn out along the
// trunk.

surface wood(float Ka = 1, Kd = 0.8, Ks = 0.2, roughness = 0.15; color specularcolor = 1;
             float ringscale = 12, wobble = 0.15, grainscale = 60;
             color early = color(0.72, 0.48, 0.26), late = color(0.42, 0.22, 0.10)) {
  normal Nf = faceforward(normalize(N), I);
  vector V = -normalize(I);
  point PP = transform("shader", P);
  vector offset = wobble * (vector noise(PP * 2) - vector(0.5));
  point Q = PP + offset;

  float radius = sqrt(xcomp(Q) * xcomp(Q) + zcomp(Q) * zcomp(Q)) * ringscale;
  float phase = mod(radius, 1);
  // Slow growth in spring, an abrupt end in autumn.
  float ring = smoothstep(0.1, 0.8, phase) - smoothstep(0.92, 1, phase);
  point G = (xcomp(PP) * grainscale, ycomp(PP), zcomp(PP) * grainscale);
  float grain = 0.8 + 0.4 * float noise(G);

  color base = Cs * mix(early, late, ring) * grain;
  Oi = Os;
  Ci = Os * (base * (Ka * ambient() + Kd * diffuse(Nf)) +
             specularcolor * Ks * (1 - 0.5 * ring) * specular(Nf, V, roughness));
}
