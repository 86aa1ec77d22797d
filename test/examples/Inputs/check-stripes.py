"""Compares what examples/host-c prints with examples/host-c/stripes.sl, computed here."""
import re
import sys

POINTS, COUNT, BLUR = 13, 3, 0.2
DARK, BRIGHT = (0.1, 0.1, 0.4), (1, 0.5, 0.25)

with open(sys.argv[1]) as file:
    lines = file.read().splitlines()
assert re.fullmatch(r"surface stripes, \d+ points at once", lines[0]), lines[0]
assert len(lines) == 1 + POINTS
for i, line in enumerate(lines[1:]):
    s = i / (POINTS - 1)
    x = s * COUNT % 1
    y = (abs(2 * x - 1) - (0.5 - BLUR)) / (2 * BLUR)
    y = min(max(y, 0), 1)
    k = y * y * (3 - 2 * y)
    wanted = [(1 - k) * d + k * b for d, b in zip(DARK, BRIGHT)]
    found = [float(word) for word in line.split(":")[1].split()]
    assert line.startswith(f"s = {s:.3f}: "), line
    assert all(abs(a - b) < 0.6e-3 for a, b in zip(wanted, found)), (line, wanted)
