// What the lights of a scene add up to at a surface.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

color diffuse(normal N) {
  color sum = 0;
  illuminance (P, N, PI / 2) {
    if (!__light_is_nondiffuse())
      sum += Cl * max(0, normalize(L) . N);
  }
  return sum;
}

// Blinn's highlight for L, N and V of unit length: at most 1, however small the roughness.
color specularbrdf(vector L; normal N; vector V; float roughness) {
  float c = clamp(N . normalize(L + V), 0, 1);
  return color(pow(c, 1 / max(roughness, 1e-8)));
}

color specular(normal N; vector V; float roughness) {
  color sum = 0;
  illuminance (P, N, PI / 2) {
    if (!__light_is_nonspecular())
      sum += Cl * specularbrdf(normalize(L), N, V, roughness);
  }
  return sum;
}

color phong(normal N; vector V; float size) {
  vector R = reflect(-normalize(V), normalize(N));
  color sum = 0;
  illuminance (P, N, PI / 2) {
    sum += Cl * pow(clamp(R . normalize(L), 0, 1), size);
  }
  return sum;
}
