// critical.sl: reflection inside of glass, next to the critical angle.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Near total reflection the discriminant is a difference of numbers that are nearly equal; its sign decides, and what
// is left of its digits makes the result. fresnel() forms it exactly.

surface critical(float eta = 1.5) {
  vector incident = normalize(I);
  float cosI = -(incident . N);
  float k = 1 - eta * eta * (1 - cosI * cosI);
  float kr = 1;
  if (k > 0) {
    float cosT = sqrt(k);
    float perpendicular = (eta * cosI - cosT) / (eta * cosI + cosT);
    float parallel = (cosI - eta * cosT) / (cosI + eta * cosT);
    kr = (perpendicular * perpendicular + parallel * parallel) / 2;
  }
  Ci = kr;
}

surface stablecritical(float eta = 1.5) {
  float kr, kt;
  fresnel(I, N, eta, kr, kt);
  Ci = kr;
}
