// TESTS: ctransform
// RUN: %shade_everywhere %s %t
// ARGS: --grid 5x2
// EXPECT toHsv: 0.5833333333333333 0.8 0.5
// EXPECT toHsl: 0.5833333333333333 0.6666666666666667 0.3
// EXPECT toYiq: 0.299 0.595716 0.211456
// EXPECT toXyz: 0.4124564 0.2126729 0.0193339
// EXPECT toXyY: 0.639999925519 0.330000068274 0.2126729
// EXPECT grey: 0 0 0.25
// EXPECT black: 0 0 0
// EXPECT fromHsv: 0.1 0.3 0.5
// EXPECT fromHsl: 0.1 0.3 0.5
// EXPECT unknown: 0.1 0.3 0.5
// EXPECT roundTrips: 0.1 0.3 0.5 0.1 0.3 0.5 0.1 0.3 0.5 0 0 0
surface colors(float one = 1; output varying color toHsv = 9; output varying color toHsl = 9; output varying color toYiq = 9;
               output varying color toXyz = 9; output varying color grey = 9; output varying color black = 9; output varying color fromHsv = 9;
               output varying color fromHsl = 9; output varying color unknown = 9; output varying color toXyY = 9; output varying color roundTrips[4] = {9, 9, 9, 9};) {
  color c = color (0.1, 0.3, 0.5 * one);
  toHsv = ctransform("hsv", c);
  toHsl = ctransform("hsl", c);
  toYiq = ctransform("yiq", color (one, 0, 0));
  toXyz = ctransform("xyz", color (one, 0, 0));
  grey = ctransform("hsv", color (0.25 * one)); // no hue to find, and none invented
  black = ctransform("hsl", color (0 * one));
  fromHsv = ctransform("hsv", "rgb", color (7 / 12, 0.8, 0.5 * one));
  fromHsl = ctransform("hsl", "rgb", color (7 / 12, 2 / 3, 0.3 * one));
  unknown = ctransform("unheard-of", c);
  toXyY = ctransform("xyY", color (one, 0, 0));
  roundTrips[0] = ctransform("YIQ", "rgb", ctransform("rgb", "yiq", c));
  roundTrips[1] = ctransform("xyz", "hsl", ctransform("hsl", "xyz", c));
  roundTrips[2] = ctransform("xyY", "rgb", ctransform("xyY", c));
  roundTrips[3] = ctransform("xyY", "rgb", ctransform("xyY", color (0 * one)));
}
