#!/usr/bin/env python3
"""Compares the derivative of every function with central differences of the oracle, by each of its arguments.

usage: rules.py TEMPORARY-PREFIX

The oracle's numbers have 200 bits, so that its differences are exact in all digits that count. Arguments run through all signs; a place
where the slopes to both sides differ is a kink or a jump and left out, as is what lies next to a singular point.
"""
import json
import pathlib
import statistics
import sys

from running import run

# a, b and c run from -2 to 2; v and w are vectors, k, l and m are a color and matrices made of them.
PRELUDE = """
float kr(vector i, n; float eta) { float r, t; fresnel(i, n, eta, r, t); return r; }
float kt(vector i, n; float eta) { float r, t; fresnel(i, n, eta, r, t); return t; }
"""
RULES = """
a + b * c | a - b | a / b | -a * a | radians(a) + degrees(b)
sin(a) | cos(a) | tan(a) | asin(a / 2) | acos(a / 2) | atan(a) | atan(a, b) | atan(b, a)
pow(a, b) | pow(abs(a), b) | pow(a, 2) | pow(a, 3) | pow(2, a) | exp(a) | sqrt(a) | inversesqrt(a) | log(a) | log(a, b) | log(4 + a, 4 + b)
mod(a, b) | abs(a) | sign(a) | floor(a) | ceil(a) | round(a) | step(a, b) | min(a, b, c) | max(a, b, c) | clamp(a, b, c)
mix(a, b, c) | smoothstep(a, b, c) | smoothstep(-2, b, a) | smoothstep(a, 2, b) | filterstep(a, b, c)
length(v) | distance(v, w) | xcomp(normalize(v)) | ycomp(normalize(w)) | v . w | zcomp(v ^ w)
ycomp(faceforward(v, w)) | zcomp(reflect(v, w)) | zcomp(reflect(normalize(v), normalize(w)))
xcomp(refract(normalize(v), normalize(w), 0.7)) | zcomp(refract(normalize(v), normalize(w), 1.4))
kr(normalize(v), faceforward(normalize(w), v), 0.7) | kt(normalize(v), faceforward(normalize(w), v), 1.2)
xcomp(rotate(v, a, w, point(0.1, 0.2, 0.3))) | ptlined(v, w, point(0.1, 0.2, 0.3))
determinant(m) | xcomp(transform(m, point(v))) | ycomp(vtransform(m, v)) | zcomp(ntransform(m, normal(w))) | comp(m * l, 1, 2)
comp(l / m, 0, 1) | comp(rotate(m, a, w), 2, 0) | comp(translate(m, v), 3, 1) | comp(scale(m, point(v)), 1, 1)
comp(ctransform("hsv", k), 1) | comp(ctransform("hsl", k), 2) | comp(ctransform("xyz", k), 0) | comp(ctransform("YIQ", k), 1)
comp(ctransform("hsv", "rgb", k), 0) | comp(ctransform("hsl", "rgb", k), 1) | comp(ctransform("xyz", "rgb", k), 2)
comp(ctransform("YIQ", "rgb", k), 2) | comp(k * color(b, c, a) / color(3 + a, 3 + b, 3 + c), 1) | comp(mix(k, color(b, c, a), a), 2)
noise(a) | noise(a, b) | noise(point(v)) | noise(point(v), b) | comp(color noise(a, b), 2) | ycomp(point noise(point(v)))
pnoise(a, 3) | pnoise(a, b, 2, 3) | pnoise(point(v), point(2, 3, 2)) | pnoise(point(v), a, point(2, 3, 2), 2) | cellnoise(a, b)
spline(0.5 + a / 5, a, b, c, 1, b, 2, a) | spline("linear", 0.5 + a / 5, a, b, c, 1) | spline("bezier", 0.5 + b / 5, a, b, c, 1, b, 2, a)
spline("bspline", 0.5 + c / 5, a, b, c, 1, b) | spline("hermite", 0.5 + a / 5, a, b, c, 1, b, 2)
spline("catmull-rom", 0.5 + b / 5, a, b, c, 1, b) | comp(spline(0.5 + a / 5, k, color(b, c, a), k, k * k, color(a)), 1)
comp(specularbrdf(normalize(v), normalize(w), normalize(point(1, c, b)), 0.3), 0)
"""
rules = [rule.strip() for line in RULES.strip().splitlines() for rule in line.split("|")]
prefix = sys.argv[1]


def shader():
    """Du by x, Dv by y, where x and y are a and b, or c and a; and, for the oracle, the slopes to both sides."""
    n = len(rules)
    body = "\n".join(f"  f[{i}] = {rule};" for i, rule in enumerate(rules))
    arrays = " ".join(f"output varying float {name}[{n}] = {{{', '.join(['0'] * n)}}};"
                      for name in ("byU", "byV", "rightU", "rightV", "leftU", "leftV"))
    return f"""{PRELUDE}
void all(float x, y, turn; output float f[{n}]) {{
  float a = x, b = y, c = 0.625;
  if (turn == 1) {{ a = y; b = -1.375; c = x; }}
  vector v = vector(a, b, c), w = vector(c + 0.25, a - b, b);
  color k = color(0.5 + a / 8, 0.5 + b / 8, 0.5 + c / 16);
  matrix m = matrix(a, 1, 0, 0,  b, c, 1, 0,  0, a, 2, 0,  c, 0, b, 1), l = matrix(1, b, 0, 0,  0, 2, a, 0,  c, 0, 1, 0,  a, b, 0, 1);
{body}
}}
surface rules(float turn = 0; {arrays}) {{
  float x = -1.9375 + 3.8125 * s, y = -1.8125 + 3.6875 * t;
  float f[{n}], i;
#ifdef ORACLE
  float h = 1e-20, before[{n}], side;
  for (side = 0; side < 5; side += 1) {{
    float du = side == 1 ? h : side == 2 ? -h : 0, dv = side == 3 ? h : side == 4 ? -h : 0;
    all(x + du, y + dv, turn, f);
    for (i = 0; i < {n}; i += 1) {{
      float slope = (f[i] - before[i]) / (du + dv);
      if (side == 0)
        before[i] = f[i];
      else if (side == 1)
        rightU[i] = slope;
      else if (side == 2)
        leftU[i] = slope;
      else if (side == 3)
        rightV[i] = slope;
      else
        leftV[i] = slope;
    }}
  }}
#else
  all(x, y, turn, f);
  for (i = 0; i < {n}; i += 1) {{
    byU[i] = Du(f[i]) / 3.8125;
    byV[i] = Dv(f[i]) / 3.6875;
  }}
#endif
}}
"""


def flat(value):
    return [x for part in value for x in flat(part)] if isinstance(value, list) else [float(value)]


def shade(names, real, defines=()):
    """Of each turn and name, the rules' numbers at each point."""
    run("rslc", *defines, f"{prefix}.sl", "-o", f"{prefix}.stc.bc")
    run("anysl-link", f"{prefix}.stc.bc", "-o", f"{prefix}.so", "--runtime", "scalar", "--real", real, "--width", "1")
    prints = [word for name in names for word in ("--print", name)]
    result = {}
    for turn in (0, 1):
        grid = json.loads(run("anysl-shade", f"{prefix}.so", "--grid", "17x17", "--param", f"turn={turn}", "--json", *prints))
        for name in names:
            numbers = flat(grid[name])
            result[turn, name] = [numbers[i:i + len(rules)] for i in range(0, len(numbers), len(rules))]
    return result


pathlib.Path(f"{prefix}.sl").write_text(shader())
TOLERANCE = {"float": (1e-3, 1e-5), "double": (1e-8, 1e-12)}  # at most, and typically
failed = False
errors = {real: [[] for _ in rules] for real in TOLERANCE}
smooth = [0] * len(rules)
count = 0
oracle = shade(["rightU", "leftU", "rightV", "leftV"], "mp", ["-DORACLE"])
for real in TOLERANCE:
    for (turn, name), points in shade(["byU", "byV"], real).items():
        by = name[-1]
        for point, slopes in enumerate(points):
            count += real == "float"
            for i, slope in enumerate(slopes):
                right, left = oracle[turn, "right" + by][point][i], oracle[turn, "left" + by][point][i]
                scale = max(1, abs(right), abs(left))
                if abs(right - left) > 1e-6 * scale or scale > 1e6:
                    continue
                smooth[i] += real == "float"
                error = abs(slope - (right + left) / 2) / scale
                errors[real][i].append((error, turn, by, point, slope, right))
for i, rule in enumerate(rules):
    if smooth[i] < 0.9 * count:
        print(f"{rule}: smooth at {smooth[i]} of {count} only")
        failed = True
    for real, (most, typical) in TOLERANCE.items():
        worst = max(errors[real][i])
        median = statistics.median(error[0] for error in errors[real][i])
        if not (worst[0] <= most and median <= typical):
            print(f"{rule}: {real} is {worst} off, and typically {median:.2g}")
            failed = True
print(f"{len(rules)} rules, {count} slopes of each")
sys.exit(failed)
