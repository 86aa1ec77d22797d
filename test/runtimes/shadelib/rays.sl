// gather, occlusion and their like over a plane, z = -1, that is all there is: what they find is known, exactly along
// one ray, within the errors of stratified sampling over a cone.
// TESTS: cone_direction indirect_diffuse occlusion trace_cone trace_length transmission_cone
// RUN: %shade_everywhere %s %t
// ARGS: --grid 11x3
// REALS: float

// EXPECT open: 0
// EXPECT hidden: 1
// EXPECT side: 1
// EXPECT beyond: 0
// EXPECT fading: 0.60653066 0.5625 0.5625
// EXPECT counts: 5 0 3 1
// EXPECT found: 1 0.3 0.25 0.2
// EXPECT missed: 1
// EXPECT place: 0 0 0
// EXPECT normals: 0 0 2
// EXPECT ground: 0.3 0.25 0.2
// EXPECT sky: 1
// EXPECT cones: 0 0 0
// EXPECT passing: 1 1 0
// EXPECT among: 1 0 1

surface rays(output varying float open = 1, hidden = 0, side = 0, beyond = 1, fading[3] = {0, 0, 0}, counts[4] = {0, 0, 0, 0};
             output varying float found[4] = {0, 0, 0, 0}, missed = 0, sky = 0;
             output varying vector place = 1, normals = 0; output varying color ground = 0, cones = 1, passing = 0, among = 0.5) {
  normal up = (0, 0, 1), down = (0, 0, -1), across = (1, 0, 0);
  open = occlusion(P, up, 16, "bias", 0.01, "label", "any");
  hidden = occlusion(P, down);
  // Half of the hemisphere of a wall.
  side = abs(occlusion(P, across, 256) - 0.5) < 0.05 ? 1 : 0;
  beyond = occlusion(P, down, 64, "maxdist", 0.9);
  fading[0] = occlusion(P, down, 4, "coneangle", 0, "falloff", 0.5);
  fading[1] = occlusion(P, down, 4, "coneangle", 0, "maxdist", 4, "falloff", 2, "falloffmode", "linear");
  fading[2] = occlusion(P, down, 4, "coneangle", 0, "maxdist", 4, "falloff", 2, "falloffmode", 1);

  // Along the axis: how far, what, where.
  float far = 0;
  color seen = 0;
  point met = 0, start = 0;
  normal n = 0, ng = 0;
  gather("illuminance", P, down, 0, 5, "ray:length", far, "surface:Ci", seen, "surface:P", met, "surface:N", n,
         "primitive:Ng", ng, "ray:origin", start) {
    counts[0] += 1;
  } else {
    counts[1] += 1;
  }
  found[0] = far;
  found[1] = seen[0];
  found[2] = seen[1];
  found[3] = seen[2];
  place = met - start - vector(0, 0, -1);
  normals = n + ng;
  // Loops can be left, and rays of a pattern meet nothing; all directions lie in the cone.
  gather("illuminance", P, down, PI / 4, 100) {
    counts[2] += 1;
    if (counts[2] == 3)
      break;
  }
  vector way = 0;
  float inside = 0;
  gather("samplepattern", P, down, PI / 3, 64, "ray:direction", way) counts[3] += 100;
  else inside += way . down >= 0.499 && abs(length(way) - 1) < 1e-5 ? 1 : 0;
  missed = inside == 64 ? 1 : 0;
  // Uniform over the sphere's half: half of the rays to the side go down.
  float hits = 0;
  gather("", P, across, PI / 2, 256) hits += 1;
  counts[3] += abs(hits - 128) < 16 ? 1 : 0;

  ground = indirectdiffuse(P, down, 4);
  // The mean of z over a hemisphere by its cosine is 2/3.
  color off = indirect(P, up, 256) - mix(color(0.9, 0.95, 1), color(0.25, 0.5, 0.9), 2 / 3);
  sky = max(abs(off[0]), abs(off[1]), abs(off[2])) < 0.02 ? 1 : 0;
  cones = trace(P, down, "samples", 3, "samplecone", 0) - color trace(P, down) + color trace(P, up, "maxdist", 5) - color trace(P, up);
  passing = (comp(transmission(P, P + up, "samples", 4, "samplecone", 0.3), 0),
             float trace(P, down, "bias", 0.1), comp(visibility(P, P + 2 * down), 0));
  // All is in every set here.
  among = (comp(transmission(P, P + up, "subset", "a"), 0), comp(transmission(P, P + 2 * down, "hitsides", "both"), 0),
           float trace(P, down, "subset", "a"));
}
