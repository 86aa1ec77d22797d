// Colour spaces.
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

// Every conversion goes through rgb: linear light with the primaries of ITU-R BT.709 and white D65. Hue counts
// turns, in [0, 1); grey has hue 0. An unknown space counts as rgb.

// The hue of a colour whose largest component is `largest` and whose components span `range`.
float hueOf(color c; float largest, range) {
  float r = comp(c, 0), g = comp(c, 1), b = comp(c, 2);
  float sixths = r == largest ? (g - b) / range : (g == largest ? 2 + (b - r) / range : 4 + (r - g) / range);
  return mod(sixths / 6, 1);
}

// The saturated colour of a hue; each component is a trapezium over the circle.
color fromHue(float hue) {
  float sixths = 6 * mod(hue, 1);
  return clamp(color(abs(sixths - 3) - 1, 2 - abs(sixths - 2), 2 - abs(sixths - 4)), color(0), color(1));
}

color xyzFromRgb(float r, g, b) {
  return color(0.4124564 * r + 0.3575761 * g + 0.1804375 * b,
               0.2126729 * r + 0.7151522 * g + 0.0721750 * b,
               0.0193339 * r + 0.1191920 * g + 0.9503041 * b);
}

// The inverse, to the digits of double.
color rgbFromXyz(float x, y, z) {
  return color(3.2404548360214083 * x - 1.5371388501025751 * y - 0.4985315468684809 * z,
               -0.9692663898756537 * x + 1.8760109288424913 * y + 0.041556082346673524 * z,
               0.05564341960421366 * x - 0.20402585426769815 * y + 1.0572251624579287 * z);
}

color fromRgb(string space; color c) {
  float r = comp(c, 0), g = comp(c, 1), b = comp(c, 2);
  color result = c;
  if (space == "hsv" || space == "hsl") {
    float largest = max(max(r, g), b), smallest = min(min(r, g), b);
    float range = largest - smallest, sum = largest + smallest;
    float hue = hueOf(c, largest, range);
    if (space == "hsv")
      result = color(hue, range / largest, largest);
    else
      result = color(hue, range / (1 - abs(sum - 1)), 0.5 * sum);
  } else if (space == "yiq" || space == "YIQ") {
    result = color(0.299 * r + 0.587 * g + 0.114 * b,
                   0.595716 * r - 0.274453 * g - 0.321263 * b,
                   0.211456 * r - 0.522591 * g + 0.311135 * b);
  } else if (space == "xyz" || space == "XYZ") {
    result = xyzFromRgb(r, g, b);
  } else if (space == "xyY") {
    color xyz = xyzFromRgb(r, g, b);
    float sum = comp(xyz, 0) + comp(xyz, 1) + comp(xyz, 2);
    result = color(comp(xyz, 0) / sum, comp(xyz, 1) / sum, comp(xyz, 1));
  }
  return result;
}

color toRgb(string space; color c) {
  float x = comp(c, 0), y = comp(c, 1), z = comp(c, 2);
  color result = c;
  if (space == "hsv") {
    result = z * mix(color(1), fromHue(x), y);
  } else if (space == "hsl") {
    float range = y * (1 - abs(2 * z - 1));
    result = color(z) + range * (fromHue(x) - color(0.5));
  } else if (space == "yiq" || space == "YIQ") {
    result = color(1.0 * x + 0.9562957197589484 * y + 0.6210244164652612 * z,
                   1.0 * x - 0.2721220993185105 * y - 0.6473805968256952 * z,
                   1.0 * x - 1.1069890167364904 * y + 1.7046149983646484 * z);
  } else if (space == "xyz" || space == "XYZ") {
    result = rgbFromXyz(x, y, z);
  } else if (space == "xyY") {
    float scale = z / y;
    result = rgbFromXyz(x * scale, z, (1 - x - y) * scale);
  }
  return result;
}

color ctransform(string from, to; color c) { return from == to ? c : fromRgb(to, toRgb(from, c)); }
