#!/usr/bin/env python3
"""Shades a grid with one shader on every runtime, real and width, and compares the numbers.

usage: shade-everywhere.py [--linked] SHADER.sl TEMPORARY-PREFIX [options for anysl-shade]

With --linked, the libraries are those that an earlier call for the same shader and prefix has linked.

The shader's comments say what to do:

    // ARGS: --grid 9x5 --light point      options for anysl-shade
    // PARAM: --param name.k=2             options for anysl-link
    // PRINT: a b Ci                       what to compare (globals, output parameters); else Ci
    // REALS: float                        only these, where the numbers depend on the format
    // EXPECT a: 0.5 0.25 1                what `a` is at every point (a number, or components)

An option `--print NAME` adds to PRINT.

Within a runtime and real, all widths give the same bits. Between runtimes, and between float, double and mp, numbers
agree to 1e-5; so do expected ones, and to 1e-9 in double and mp.
"""
import json
import re
import shlex
import sys

from running import run

RUNTIMES = [("packet", "float"), ("scalar", "float"), ("scalar", "double"), ("scalar", "mp")]
WIDTHS = {"float": [1, 4, 8, 16], "double": [1, 4, 8, 16], "mp": [1]}
TOLERANCE = {"float": 1e-5, "double": 1e-9, "mp": 1e-9}


def flat(value):
    """The numbers of a value, however nested; JSON has no infinities, so text stands for them."""
    if isinstance(value, list):
        return [x for part in value for x in flat(part)]
    return [float(value)]


def differs(a, b, tolerance):
    if a != a or b != b:
        return (a == a) != (b == b)
    return a != b and abs(a - b) > tolerance * max(1, abs(a), abs(b))


def compare(what, got, wanted, tolerance):
    got, wanted = flat(got), flat(wanted)
    if len(got) != len(wanted):
        sys.exit(f"{what}: {len(got)} numbers, not {len(wanted)}")
    for index, (a, b) in enumerate(zip(got, wanted)):
        if differs(a, b, tolerance):
            sys.exit(f"{what}: number {index} is {a!r}, not {b!r}")


is_linked = sys.argv[1] == "--linked"
shader, prefix, *options = sys.argv[1 + is_linked:]
text = open(shader).read()
arguments = options + [word for line in re.findall(r"// ARGS: (.*)", text) for word in shlex.split(line)]
parameters = [word for line in re.findall(r"// PARAM: (.*)", text) for word in shlex.split(line)]
expected = {name: [float(x) for x in values.split()] for name, values in re.findall(r"// EXPECT (\w+): (.*)", text)}
names = [word for line in re.findall(r"// PRINT: (.*)", text) for word in line.split()]
while "--print" in arguments:
    at = arguments.index("--print")
    names.append(arguments[at + 1])
    del arguments[at:at + 2]
names += [name for name in expected if name not in names]
names = names or ["Ci"]
reals = re.findall(r"// REALS: (.*)", text)

if not is_linked:
    run("rslc", shader, "-o", f"{prefix}.stc.bc")
reference = None
for runtime, real in RUNTIMES:
    if reals and real not in reals[0].split():
        continue
    library = f"{prefix}.{runtime}.{real}.so"
    if not is_linked:
        run("anysl-link", f"{prefix}.stc.bc", "-o", library, "--runtime", runtime, "--real", real,
            "--width", ",".join(map(str, WIDTHS[real])), *parameters)
    scalar = None
    for width in WIDTHS[real]:
        prints = [word for name in names for word in ("--print", name)]
        grid = json.loads(run("anysl-shade", library, "--width", str(width), "--json", *prints, *arguments))
        where = f"{runtime} {real} width {width}"
        scalar = scalar or grid
        reference = reference or grid
        for name in names:
            compare(f"{where}: {name}, beside width 1", grid[name], scalar[name], 0)
            compare(f"{where}: {name}, beside packet float", grid[name], reference[name], 1e-5)
        for name, values in expected.items():
            points = len(flat(grid[name])) // len(values)
            compare(f"{where}: {name}, beside the expected value", grid[name], values * points, TOLERANCE[real])
