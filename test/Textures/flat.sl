// Pictures whose values are known everywhere: between the centres of its 4 x 4 texels the first one is linear,
// (3u + 12v, 3u, 3v) with u = (4s - 1/2) / 3 and v likewise. A filter of no size and linear interpolation show just that.
// RUN: rm -rf %t && mkdir -p %t/more && cd %t
// RUN: printf 'surface make() { Ci = (3*u + 12*v, 3*u, 3*v); }' > make.sl && rslc make.sl && anysl-link make.stc.bc --width 4
// RUN: anysl-shade make.so --grid 4x4 -o ramp.exr
// RUN: oiiotool ramp.exr --ch R -o more/grey.exr && oiiotool ramp.exr --ch R,G,B,A=0.25 -o rgba.exr
// RUN: %shade_everywhere %s %t/flat --texture-path /nowhere:more
// ARGS: --grid 19x6 --ramp s=0.125:0.875:x --ramp t=0.125:0.875:y
// REALS: float

// EXPECT value: 0 0 0
// EXPECT implied: 0 0 0
// EXPECT channels: 0 0 0.25
// EXPECT filled: 0.75 0 0.75
// EXPECT grey: 0 0 0
// EXPECT wrapped: 0 0 0
// EXPECT edges: 0 0 0
// EXPECT chosen: 0
// EXPECT area: 7.5 1.5 1.5
// EXPECT areas: 0 0 0
// EXPECT blurs: 1
// EXPECT nearest: 0

surface flat(string ramp = "ramp.exr", file = "grey.exr"; output varying color value = 0, implied = 0, channels = 0;
             output varying color filled = 0, grey = 0, wrapped = 0, edges = 0, area = 0, areas = 0;
             output varying float chosen = 0, blurs = 0, nearest = 0) {
  float x = 4 * s - 0.5, y = 4 * t - 0.5;
  color there = (x + 4 * y, x, y);
  value = color texture(ramp, s, t, "width", 0) - there;
  implied = color texture(ramp, "width", 0) - there;

  uniform float second = 1;
  channels = (float texture(ramp[second], s, t, "width", 0) - x, float texture(ramp, s, t, "channel", 2, "swidth", 0, "twidth", 0) - y,
              float texture("rgba.exr"[3], s, t));
  // What the file lacks is 0 or the fill.
  color two = texture(ramp[2], s, t, "fill", 0.75, "width", 0);
  filled = (comp(two, 1), float texture(ramp[7], s, t), float texture(ramp[3], s, t, "fill", comp(two, 2)));
  // A grey picture is grey, unless there is a fill.
  color one = texture(file, s, t, "width", 0, "fill", 2);
  grey = color texture(file, s, t, "width", 0) - color(x + 4 * y) + one - color(x + 4 * y, 2, 2);

  wrapped = color texture(ramp, s + 1, t - 2, "wrap", "periodic", "width", 0) +
            color texture(ramp, -s, 2 - t, "swrap", "mirror", "twrap", "mirror", "width", 0) - 2 * there;
  edges = color texture(ramp, 7 + s, t, "wrap", "clamp", "width", 0) - color(3 + 4 * y, 3, y) +
          color texture(ramp, 7 + s, t, "width", 0) + color texture(ramp, s, t + 4, "wrap", "black", "width", 0);

  // The lanes of a packet may name different files; a loop makes the name vary.
  string name = ramp;
  if (s > 0.4)
    name = file;
  chosen = float texture(name, s, t, "width", 0) - x - 4 * y;

  // Corners in rows and around; all of the picture is its mean.
  area = texture(ramp, 0, 0, 1, 0, 0, 1, 1, 1);
  areas = color texture(ramp, 0, 0, 1, 0, 1, 1, 0, 1) - color texture(ramp, 0, 0, 1, 0, 0, 1, 1, 1) +
          color texture(ramp, s, t, s, t, s, t, s, t) - there;
  // Blurred, values come nearer to the mean: in the corners, by at least 1.
  float sharp = texture(ramp, s, t, "width", 0), soft = texture(ramp, s, t, "wrap", "clamp", "width", 0, "blur", 0.5);
  blurs = abs(sharp - 7.5) < 7 || abs(soft - 7.5) < abs(sharp - 7.5) - 1 ? 1 : 0;
  nearest = float texture(ramp[1], s + 0.01, t, "filter", "closest", "width", 0) - floor(4 * (s + 0.01));
}
