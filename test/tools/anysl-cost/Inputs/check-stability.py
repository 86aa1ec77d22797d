"""Checks what a stability report says of its worst points by computing them anew.

usage: check-stability.py QUADRATIC.json CRITICAL.json
"""
import json
import math
import struct
import sys
from decimal import Decimal, getcontext

getcontext().prec = 50


def f(x):
    """Rounds to float; a sum, product, quotient or root of floats, rounded to double before, stays right."""
    return struct.unpack("f", struct.pack("f", x))[0]


def lost(value, exact):
    if Decimal(value) == exact:
        return 0
    digits = 24 * math.log10(2)
    return min(max(digits + float((abs(Decimal(value) - exact) / abs(exact)).log10()), 0), digits)


def quadratic(inputs, number, root):
    scale, tenth = number(10000), number(0.1)
    s, t = number(inputs["s"][0]), number(inputs["t"][0])
    b, c = step(number, scale * step(number, tenth + s)), step(number, tenth + t)
    return step(number, step(number, b - step(number, root(step(number, step(number, b * b) - step(number, 4 * c))))) / 2)


def step(number, x):
    return f(x) if number is f else x


reports = [json.load(open(path))["shaders"] for path in sys.argv[1:]]
first, stable = reports[0]
place = first["places"][0]
assert place["operator"] == "sub_float" and place["cause"] == "lost digits", place
rounded = quadratic(place["inputs"], f, math.sqrt)
exact = quadratic(place["inputs"], Decimal, lambda x: x.sqrt())
assert abs(lost(rounded, exact) - place["lostDigits"]) < 0.01, (lost(rounded, exact), place["lostDigits"])
# The subtraction gives twice the result.
assert abs(place["value"][0] - 2 * rounded) <= 1e-12 and abs(Decimal(place["exact"][0]) / (2 * exact) - 1) < Decimal(1e-9)
assert len(first["lost"]) == first["points"] == 576 and first["unstable"] == sum(x > 3 for x in first["lost"])
# A shader whose worst point loses less than the limit has no place, whatever was tried.
assert not stable["places"] and max(stable["lost"]) < 1, stable["places"]

hand, library = reports[1]
place = hand["places"][0]
x, _, z = map(Decimal, place["inputs"]["I"])
k = 1 - Decimal(2.25) * (x * x / (x * x + z * z))
assert abs(Decimal(place["exact"][0]) / k - 1) < Decimal(1e-9), (place["exact"], k)
assert 0 < k < Decimal(1e-3), "the worst is not near the critical angle"
assert not library["places"]
print("the worst points lose what is said")
