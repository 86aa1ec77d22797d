// spotlight.sl: a cone of light with a soft edge.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The RenderMan Interface's standard light "spotlight": it fades with the square of the distance, with a power of
// the cosine of the angle to its axis, and to nothing over the last part of the cone.

light spotlight(float intensity = 1; color lightcolor = 1;
                point from = point "shader" (0, 0, 0), to = point "shader" (0, 0, 1);
                float coneangle = radians(30), conedeltaangle = radians(5), beamdistribution = 2;
                float __nondiffuse = 0, __nonspecular = 0; string __category = "") {
  uniform vector axis = (to - from) / length(to - from);
  uniform float outside = cos(coneangle), inside = cos(coneangle - conedeltaangle);
  illuminate (from, axis, coneangle) {
    float cosine = (L . axis) / length(L);
    float fading = pow(cosine, beamdistribution) / (L . L) * smoothstep(outside, inside, cosine);
    Cl = intensity * lightcolor * fading;
  }
}
