// uber.sl: every effect that a surface can have, each switched on by its weight.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// What renderers offer as their one material. A scene calls for few of its parts, and is linked for those
// (docs/effects.md; examples/scenes/effects).
//
//   Kc                light of its own, the same in all directions
//   Ka Kd Ks          weights of ambient, diffuse and specular light
//   Kn Kb             weights of noise in the colour, and of bumps
//   Kr Kt             weights of reflection and refraction
//   blur samples      angle of the cone of rays for reflection, and their number; 0: one ray
//   Ko Ki             weights of occlusion and of light by way of other surfaces, with raysFor rays
//   Ke                weight of the surroundings' picture
//   texturename environmentname: pictures; empty: none
//   direct, mirrored, hidden: outputs

surface uber(float Kc = 0, Ka = 0, Kd = 0, Ks = 0, roughness = 0.1;
             float Kn = 0, Kb = 0, Kr = 0, Kt = 0, eta = 1.5, blur = 0, samples = 4;
             float Ko = 0, Ki = 0, raysFor = 4, Ke = 0;
             string texturename = "", environmentname = "";
             output varying color direct = 0, mirrored = 0; output varying float hidden = 0;) {
  normal Nn = normalize(N);
  vector V = -normalize(I);
  color body = Cs;

  if (Kb != 0) {
    point bumped = P + Kb * noise(4 * transform("object", P)) * Nn;
    Nn = calculatenormal(bumped);
  }
  normal Nf = faceforward(Nn, I);
  if (Kn != 0) {
    point Q = transform("object", P);
    float sum = 0, size = 1;
    uniform float octave;
    for (octave = 0; octave < 4; octave += 1) {
      sum += abs(2 * noise(3 * size * Q) - 1) / size;
      size *= 2;
    }
    body *= mix(1, sum, Kn);
  }
  if (texturename != "")
    body *= color texture(texturename);

  direct = Kc * body;
  if (Ka != 0)
    direct += Ka * body * ambient();
  if (Kd != 0)
    direct += Kd * body * diffuse(Nf);
  if (Ks != 0)
    direct += Ks * specular(Nf, V, roughness);
  if (Ko != 0) {
    hidden = occlusion(P, Nf, raysFor);
    direct *= 1 - Ko * hidden;
  }
  if (Ki != 0)
    direct += Ki * body * indirectdiffuse(P, Nf, raysFor);

  mirrored = 0;
  color through = 0;
  if (Kr != 0 || Kt != 0) {
    float share, rest;
    vector R, T;
    fresnel(-V, Nf, I . N < 0 ? 1 / eta : eta, share, rest, R, T);
    if (Kr != 0)
      mirrored = Kr * share * (blur > 0 ? color trace(P, R, "samples", samples, "samplecone", blur) : color trace(P, R));
    if (Kt != 0)
      through = Kt * rest * color trace(P, T);
  }
  if (Ke != 0 && environmentname != "")
    mirrored += Ke * color environment(environmentname, vtransform("world", reflect(-V, Nf)));

  Oi = Os;
  Ci = Os * (direct + mirrored + through);
}
