#!/usr/bin/env python3
"""check-differentials.py PLACES STEPS

PLACES shows the x and y of what is seen at the middle of each pixel, STEPS the root of the sum of the squares of what
they change by to the next pixels to the right and below, as the renderer has it. Compares those with the differences
of the places.
"""
import math
import re
import subprocess
import sys


def numbers(picture):
    text = subprocess.run(["oiiotool", "--dumpdata", picture], stdout=subprocess.PIPE, text=True, check=True).stdout
    found = re.findall(r"Pixel \((\d+), (\d+)\): (\S+) (\S+)", text)
    return {(int(x), int(y)): (float(a), float(b)) for x, y, a, b in found}


places, steps = numbers(sys.argv[1]), numbers(sys.argv[2])
size = max(x for x, _ in places) + 1
errors = []
for x in range(size // 4, size * 3 // 4):
    for y in range(size // 4, size * 3 // 4):
        for c in (0, 1):
            right = (places[x + 1, y][c] - places[x - 1, y][c]) / 2
            down = (places[x, y + 1][c] - places[x, y - 1][c]) / 2
            errors.append(abs(steps[x, y][c] / math.hypot(right, down) - 1))
errors.sort()
print(f"{len(errors)} steps, median error {errors[len(errors) // 2]:.1e}, largest {errors[-1]:.1e}")
# Of central differences the error falls with the square of the pixel's size.
sys.exit(0 if errors[len(errors) // 2] < 1e-3 and errors[-1] < 0.05 else 1)
