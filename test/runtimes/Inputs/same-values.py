#!/usr/bin/env python3
"""Shades grids with numbers that carry derivatives and with plain ones, and compares every bit.

usage: same-values.py TEMPORARY-PREFIX SHADER.sl...

The shaders are those of shade-everywhere.py; their comments say how to shade them and what to compare.
"""
import re
import shlex
import subprocess
import sys

PAIRS = [("packet", "float", "dual"), ("scalar", "float", "dual"), ("scalar", "double", "dualdouble")]


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{shlex.join(command)}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


prefix, *shaders = sys.argv[1:]
for shader in shaders:
    text = open(shader).read()
    words = lambda key: [word for line in re.findall(rf"// {key}: (.*)", text) for word in shlex.split(line)]
    names = words("PRINT") + re.findall(r"// EXPECT (\w+):", text)
    prints = [word for name in names or ["Ci"] for word in ("--print", name)]
    run("rslc", shader, "-o", f"{prefix}.stc.bc")
    for runtime, *reals in PAIRS:
        results = []
        for real in reals:
            run("anysl-link", f"{prefix}.stc.bc", "-o", f"{prefix}.{real}.so", "--runtime", runtime, "--real", real,
                "--width", "1,8", *words("PARAM"))
            for width in ("1", "8"):
                results.append(run("anysl-shade", f"{prefix}.{real}.so", "--width", width, "--json", *prints,
                                   *words("ARGS")))
        if len(set(results)) != 1:
            sys.exit(f"{shader}: runtime {runtime} gives other values with real {reals[1]} than with {reals[0]}")
