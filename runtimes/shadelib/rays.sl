// Light by way of other surfaces, by rays.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

// Direction number `i` of `count` in a cone about an axis. The directions are stratified: each lies at random in a
// cell of its own of a grid over the cone's solid angle, or, with `cosine`, over what that projects to. Those for
// which the grid has no cell lie anywhere.
vector __cone_direction(vector axis; float angle, i, count, cosine) {
  float columns = max(1, floor(sqrt(count))), rows = max(1, floor(count / columns));
  float x = random(), y = random();
  if (i < columns * rows) {
    x = (mod(i, columns) + x) / columns;
    y = (floor(i / columns) + y) / rows;
  }
  float edge = cos(angle), flatEdge = cos(min(angle, PI / 2));
  float height = cosine != 0 ? sqrt(1 - x * (1 - flatEdge * flatEdge)) : 1 - x * (1 - edge);
  float width = sqrt(1 - height * height), turn = 2 * PI * y;
  vector Z = normalize(axis);
  vector X = normalize(Z ^ (abs(zcomp(Z)) < 0.7 ? vector(0, 0, 1) : vector(1, 0, 0)));
  return width * cos(turn) * X + width * sin(turn) * (Z ^ X) + height * Z;
}

float sampleCount(float samples) { return max(1, floor(samples + 0.5)); }

// How much a surface at a distance counts: it fades with the distance, by default exponentially.
float weightOf(float distance, maxdist, falloff; string mode) {
  float near = maxdist < 1e30 ? 1 - distance / maxdist : 1;
  return falloff == 0 ? 1 : (mode == "linear" || mode == "1" ? pow(near, falloff) : exp(-falloff * distance));
}

float occlusion(point P; normal N; float samples, maxdist, coneangle, falloff;
                string falloffmode, distribution, subset, hitsides) {
  float count = sampleCount(samples), i, sum = 0;
  float cosine = distribution == "uniform" ? 0 : 1;
  for (i = 0; i < count; i += 1) {
    float distance;
    normal metN, metNg;
    if (__trace_hit(P, __cone_direction(N, coneangle, i, count, cosine), maxdist, "diffuse", subset, hitsides, distance,
                    metN, metNg))
      sum += weightOf(distance, maxdist, falloff, falloffmode);
  }
  return sum / count;
}

// What no surface sends comes from the environment map, if there is one, else from the scene's own surroundings. A ray
// that the renderer traces no further meets nothing and is opaque.
color indirectdiffuse(point P; normal N; float samples, maxdist, coneangle, falloff;
                      string falloffmode, distribution, environmentmap, subset, hitsides) {
  float count = sampleCount(samples), i;
  float cosine = distribution == "uniform" ? 0 : 1;
  color sum = 0;
  for (i = 0; i < count; i += 1) {
    vector direction = __cone_direction(N, coneangle, i, count, cosine);
    float distance;
    normal metN, metNg;
    color light, opacity;
    if (__trace_shade(P, direction, maxdist, "diffuse", subset, hitsides, distance, metN, metNg, light, opacity))
      light *= weightOf(distance, maxdist, falloff, falloffmode);
    else if (environmentmap != "")
      light = (1 - opacity) * color environment(environmentmap, direction, direction, direction, direction);
    sum += light;
  }
  return sum / count;
}

color trace(point P; vector R; float maxdist, samples, samplecone; string subset, hitsides) {
  float count = sampleCount(samples), i;
  color sum = 0;
  for (i = 0; i < count; i += 1) {
    vector direction = samplecone > 0 ? __cone_direction(R, samplecone, i, count, 0) : R;
    color opacity;
    sum += maxdist < 1e30 || subset != "" || hitsides != ""
               ? __trace_light(P, direction, maxdist, "specular", subset, hitsides, opacity)
               : color trace(P, direction);
  }
  return sum / count;
}

// Where nothing is met, as far away as without arguments.
float trace(point P; vector R; float maxdist, samples, samplecone; string subset, hitsides) {
  float distance;
  normal N, Ng;
  __trace_hit(P, R, maxdist, "specular", subset, hitsides, distance, N, Ng);
  return distance;
}

// The cone's tip is the first point; its rays end as far away as the second.
color transmission(point P1, P2; float samples, samplecone; string subset, hitsides) {
  float count = sampleCount(samples), i;
  color sum = 0;
  for (i = 0; i < count; i += 1) {
    vector way = P2 - P1;
    if (samplecone > 0)
      way = length(way) * __cone_direction(way, samplecone, i, count, 0);
    if (subset != "" || hitsides != "")
      sum += __transmission_among(P1, way, length(way), subset, hitsides);
    else
      sum += transmission(P1, samplecone > 0 ? P1 + way : P2);
  }
  return sum / count;
}
