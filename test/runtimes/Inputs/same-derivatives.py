#!/usr/bin/env python3
"""Shades grids with shaders that read derivatives, linked in every way, and compares the numbers.

usage: same-derivatives.py TEMPORARY-PREFIX SHADER.sl... [-- options for anysl-shade]

The shaders are those of shade-everywhere.py; their comments say how to shade them and what to compare. Each is linked for both
runtimes, in `dual` and `dualdouble`, at every math tier, and for a scene that has it. Of one way of linking all widths give the
same bits, and so does the library for the scene; tiers agree to what they promise of results that may have cancelled.
"""
import json
import pathlib
import re
import shlex
import sys

from running import run

WAYS = [("packet", "dual", ["u10", "cr", "u35", "fast"]), ("scalar", "dual", ["u10"]),
        ("scalar", "dualdouble", ["u10", "cr", "fast"])]
WIDTHS = ["1", "4", "8", "16"]
# Of the greatest number of an output, or of 1 where all are smaller.
TOLERANCE = {"cr": 1e-5, "u35": 1e-5, "fast": 2e-3}
COMPONENTS = {"float": 1, "color": 3, "point": 3, "vector": 3, "normal": 3, "matrix": 16}


def flat(value):
    return [x for part in value for x in flat(part)] if isinstance(value, list) else [float(value)]


def scene_for(text, names, arguments, folder):
    """A scene that calls for what the shader puts out, with the parameters that the command line sets."""
    kind, name = re.search(r"^(surface|displacement)\s+(\w+)", text, re.MULTILINE).groups()
    parameters, variables = "", ""
    for option, value in zip(arguments, arguments[1:]):
        key, _, values = value.partition("=")
        declared = re.search(rf"varying (\w+) {key}(?:\[(\d+)\])?\s*[=;]", text)
        if option == "--param":
            number = re.fullmatch(r"[-+.\de]+", values)
            parameters += f' "uniform float {key}" [{values}]' if number else f' "uniform string {key}" ["{values}"]'
        elif option in ("--ramp", "--set") and declared:
            kind_of, length = declared.groups()
            zeros = " 0" * (4 * COMPONENTS[kind_of] * int(length or 1))
            variables += f' "varying {kind_of}{f"[{length}]" if length else ""} {key}" [{zeros}]'
    displays = 'Display "beauty.exr" "file" "rgba"\n' + "".join(
        f'Display "+{each}.exr" "file" "{each}"\n' for each in names if each not in ("Ci", "Oi"))
    path = pathlib.Path(f"{folder}.rib")
    path.write_text(f'{displays}WorldBegin\n{kind.title()} "{name}"{parameters}\nSphere 1 -1 1 360{variables}\nWorldEnd\n')
    return str(path)


def shade(library, width, prints, arguments):
    return run("anysl-shade", library, "--width", width, "--json", *prints, *arguments)


def numbers_by_width(link, library, prints, arguments, what):
    """Links, and shades at every width, which must all give the same."""
    run("anysl-link", *link, "-o", library, "--width", ",".join(WIDTHS))
    results = {width: shade(library, width, prints, arguments) for width in WIDTHS}
    for width in WIDTHS:
        if results[width] != results["1"]:
            sys.exit(f"{what}: width {width} gives other bits than width 1")
    return results["1"]


def compare(what, got, wanted, tolerance):
    for name, values in json.loads(got).items():
        a, b = flat(values), flat(json.loads(wanted)[name])
        size = max(1, *map(abs, b))
        worst = max((abs(x - y) for x, y in zip(a, b)), default=0)
        if not worst <= tolerance * size:
            sys.exit(f"{what}: {name} is {worst} off")


words = sys.argv[1:]
more = []
if "--" in words:
    more = words[words.index("--") + 1:]
    words = words[:words.index("--")]
prefix, *shaders = words
for shader in shaders:
    text = pathlib.Path(shader).read_text()
    of = lambda key: [word for line in re.findall(rf"// {key}: (.*)", text) for word in shlex.split(line)]
    names = of("PRINT") + re.findall(r"// EXPECT (\w+):", text)
    names = names or ["N" if re.search(r"^displacement", text, re.MULTILINE) else "Ci"]
    prints = [word for name in names for word in ("--print", name)]
    arguments = of("ARGS") + more
    stc = f"{prefix}.stc.bc"
    run("rslc", shader, "-o", stc)
    scene = scene_for(text, names, arguments, prefix)
    for runtime, real, tiers in WAYS:
        reference = None
        for tier in tiers:
            what = f"{shader}: {runtime} {real} {tier}"
            link = [stc, "--runtime", runtime, "--real", real, "--math", tier]
            got = numbers_by_width(link, f"{prefix}.so", prints, arguments, what)
            if reference is None:
                reference = got
                report = f"{prefix}.json"
                small = numbers_by_width(link + ["--scene", scene, "--report", report], f"{prefix}.scene.so", prints,
                                         arguments, what + " --scene")
                if small != got:
                    sys.exit(f"{what}: the library for a scene gives other bits")
            else:
                compare(what + ", beside u10", got, reference, TOLERANCE[tier])
    print(f"{shader}: {len(flat(list(json.loads(reference).values())))} numbers alike")
