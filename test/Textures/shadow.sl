// Shadow maps from the origin along z, by parallel rays and in perspective: on the left something at depth 5, on the
// right nothing.
// RUN: rm -rf %t && mkdir %t && cd %t
// RUN: oiiotool --pattern constant:color=5 2x4 1 --pattern constant:color=1e30 2x4 1 --mosaic 2x1 -d float --attrib:type=matrix worldtocamera 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1 -o depths.exr
// RUN: oiiotool depths.exr --attrib:type=matrix worldtoscreen 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1 -o flat.exr
// RUN: oiiotool depths.exr --attrib:type=matrix worldtoscreen 1,0,0,0,0,1,0,0,0,0,1,1,0,0,0,0 -o deep.exr
// RUN: %shade_everywhere %s %t/shadow --space world=1,0,0,0,0,1,0,0,0,0,1,0,10,0,0,1
// ARGS: --grid 9x3
// REALS: float

// The light's world is 10 to the right of the shaders' space.
// EXPECT near: 0
// EXPECT behind: 1
// EXPECT biased: 0
// EXPECT right: 0
// EXPECT outside: 0
// EXPECT half: 0.5
// EXPECT corners: 0.5
// EXPECT perspective: 1 0 0

surface shadows(output varying float near = 1, behind = 0, biased = 1, right = 1, outside = 1, half = 0, corners = 0;
                output varying color perspective = 0) {
  point light = (10, 0, 0);
  near = shadow("flat.exr", light + vector(-0.5, 0, 4));
  behind = shadow("flat.exr", light + vector(-0.5, 0.25, 6));
  biased = shadow("flat.exr", light + vector(-0.5, 0, 6), "bias", 2);
  right = shadow("flat.exr", light + vector(0.5, 0, 6));
  outside = shadow("flat.exr", light + vector(-1.5, 0, 6));
  half = shadow("flat.exr", light + vector(0, 0, 6), "blur", 0.5, "samples", 64);
  corners = shadow("flat.exr", light + vector(-0.5, -0.5, 6), light + vector(0.5, -0.5, 6), light + vector(-0.5, 0.5, 6),
                   light + vector(0.5, 0.5, 6), "samples", 16);
  perspective = (shadow("deep.exr", light + vector(-6, 0, 10)), shadow("deep.exr", light + vector(6, 0, 10)),
                 shadow("deep.exr", light + vector(-6, 0, -10)));
}
