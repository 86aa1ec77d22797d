"""Says whether two outputs of anysl-shade are nowhere further apart than a number.

usage: within.py A.json B.json DISTANCE
"""
import json
import sys

a, b = (json.load(open(path)) for path in sys.argv[1:3])
most = max(abs(x - y) for name in ("Ci", "Oi") for p, q in zip(a[name], b[name]) for x, y in zip(p, q))
# The inputs of the second are rounded to double, those of the first to float.
print("within" if most <= float(sys.argv[3]) else f"{most} apart")
