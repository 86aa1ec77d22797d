"""Compares a JSON file of a 3 x 2 grid with the definition of anysl-shade's grid."""
import json
import sys

with open(sys.argv[1]) as file:
    grid = json.load(file)
W, H = grid.pop("width"), grid.pop("height")
assert (W, H) == (3, 2)

u = [i / (W - 1) for j in range(H) for i in range(W)]
v = [j / (H - 1) for j in range(H) for i in range(W)]
position = [[x, y, 0] for x, y in zip(u, v)]


def everywhere(value):
    return [value] * (W * H)


expected = {
    "u": u, "s": u, "v": v, "t": v, "P": position, "Ps": position,
    "N": everywhere([0, 0, 1]), "Ng": everywhere([0, 0, 1]), "Ns": everywhere([0, 0, 1]),
    "I": everywhere([0, 0, -1]), "E": everywhere([0, 0, 1]), "L": everywhere([0, 0, 0]),
    "Cs": everywhere([1, 1, 1]), "Os": everywhere([1, 1, 1]),
    "Ci": everywhere([0, 0, 0]), "Oi": everywhere([1, 1, 1]),
    "dPdu": everywhere([1, 0, 0]), "dPdv": everywhere([0, 1, 0]),
    "du": everywhere(0.5), "dv": everywhere(1), "time": everywhere(0), "ncomps": everywhere(3),
    "alpha": everywhere(1),
}
assert set(grid) == set(expected), set(grid) ^ set(expected)
for name, values in expected.items():
    assert grid[name] == values, (name, grid[name], values)
