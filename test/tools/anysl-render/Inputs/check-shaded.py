"""Checks colours that anysl-shade computed at the recorded points of ball.rib: what the lights give, and noise in [0, 1)."""
import json
import math
import sys

shaded = json.load(open(sys.argv[1]))
spread = []
for P, Ci in zip(shaded["P"], shaded["Ci"]):
    normal = [(p - c) / 2 for p, c in zip(P, (0, 0, 6))]
    lit = max(0, (normal[1] - normal[2]) * math.sqrt(0.5))
    noise = [Ci[k] - Cs * (0.5 * 0.25 + 0.5 * lit) - 0.1 * math.sin(20 * P[0]) for k, Cs in enumerate((0.5, 0.75, 1))]
    assert max(noise) - min(noise) < 1e-5, "the same noise in all three"
    assert -1e-5 < noise[0] < 1
    spread.append(noise[0])
mean = sum(spread) / len(spread)
deviation = math.sqrt(sum((x - mean) ** 2 for x in spread) / len(spread))
# Four samples of a uniform variable.
assert math.isclose(mean, 0.5, abs_tol=0.05), mean
assert math.isclose(deviation, math.sqrt(1 / 12) / 2, rel_tol=0.15), deviation
print("colours are those of the lights")
