"""Reads a file of recorded points of ball.rib and checks them against the geometry of a ball.

usage: check-recording.py FILE
"""
import math
import shlex
import struct
import sys

data = open(sys.argv[1], "rb").read()
head, body = data.split(b"data\n", 1)
lines = [shlex.split(line) for line in head.decode().splitlines()]
assert lines[0] == ["anysl-points", "1"]
value = {line[0]: line[1:] for line in lines}
assert value["shader"] == ["surface", "flat"]
assert value["file"][0].endswith("/flat.sl")
points = int(value["points"][0])
assert {line[1]: line[2:] for line in lines if line[0] == "param"} == {"Ka": ["0.5"], "samples": ["4"]}
assert [float(x) for x in value["ambient"]] == [0.25] * 3
lights = [[float(x) for x in line[1:-1]] for line in lines if line[0] == "light"]
assert len(lights) == 1 and lights[0][0] == 1 and lights[0][2:5] == [0.5] * 3
assert all(math.isclose(a, b, abs_tol=1e-6) for a, b in zip(lights[0][8:11], [0, -math.sqrt(0.5), math.sqrt(0.5)]))
components = {"P": 3, "N": 3, "I": 3, "Cs": 3, "Ci": 3, "Oi": 3, "Os": 3, "Ng": 3}
values, at = {}, 0
for line in lines:
    if line[0] == "global":
        count = points * components[line[1]]
        values[line[1]] = struct.unpack_from(f"<{count}f", body, at)
        at += 4 * count
seeds = struct.unpack_from(f"<{points}I", body, at)
assert at + 4 * points == len(body), "nothing is left"
assert len(set(seeds)) > 0.99 * points, "points have random numbers of their own"
centre = (0, 0, 6)
for i in range(points):
    P, N, I, Cs = (values[name][3 * i:3 * i + 3] for name in ("P", "N", "I", "Cs"))
    assert math.isclose(math.dist(P, centre), 2, rel_tol=1e-6), "points lie on the ball"
    assert all(math.isclose(a, b, abs_tol=1e-5) for a, b in zip(P, I)), "the eye is at the origin"
    length = math.hypot(*N)
    outwards = sum(n * (p - c) for n, p, c in zip(N, P, centre)) / (2 * length)
    assert math.isclose(abs(outwards), 1, rel_tol=1e-5), "N points away from the centre"
    assert Cs == (0.5, 0.75, 1)
print(points, "points lie on the ball")
