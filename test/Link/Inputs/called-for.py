#!/usr/bin/env python3
"""Counts instructions of shaders linked without derivatives, with those that are called for, and with all.

usage: called-for.py FOLDER unread SHADER.sl...
       called-for.py FOLDER chain PATTERN.sl     (in the forms of benchmarks/derivatives/pattern.sl)

`unread`: where nobody reads a derivative, numbers that carry them have the code of plain ones, to 2 in a hundred: before widening,
and of the machine. `chain`: one filter costs what leads to it, a small part of what all derivatives cost.
"""
import json
import pathlib
import re
import subprocess
import sys

folder, what, *shaders = sys.argv[1:]
folder = pathlib.Path(folder)
folder.mkdir(parents=True, exist_ok=True)


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{command}: exit status {done.returncode}\n{done.stdout}{done.stderr}")


def count(shader, *link, defines=()):
    """Instructions of the shader for one point, and of the processor in all that is emitted."""
    stc, code, report = (folder / f"counted{suffix}" for suffix in (".stc.bc", ".s", ".json"))
    run("rslc", *defines, shader, "-o", stc)
    run("anysl-link", stc, "-o", code, "--report", report, "--width", "1,8", *link)
    contents = json.loads(report.read_text())
    machine = sum(bool(re.match(r"\t[a-z]", line)) for line in code.read_text().splitlines())
    return contents["real"], contents["shaders"][0]["scalarInstructions"], machine


if what == "unread":
    compared = 0
    for shader in shaders:
        real, *plain = count(shader)
        if real != "float":
            continue  # it asks for derivatives
        real, *carried = count(shader, "--real", "dual")
        print(shader, plain, carried)
        compared += 1
        for few, many in zip(plain, carried):
            if not 0.98 * few <= many <= 1.02 * few:
                sys.exit(f"{shader}: {many} instructions with real dual, {few} with float")
    if compared < 15:
        sys.exit(f"only {compared} of these read no derivative")
else:
    forms = {form: count(shaders[0], defines=[f"-DFORM={form}"]) for form in ("PLAIN", "FILTERSTEP", "CARRIED")}
    print(forms)
    if [forms[form][0] for form in forms] != ["float", "dual", "dual"]:
        sys.exit("the forms have other reals than expected")
    for kind in (1, 2):
        plain, chain, everything = (forms[form][kind] for form in forms)
        if not plain < chain < plain + 0.2 * (everything - plain):
            sys.exit(f"{plain} instructions without derivatives, {chain} with one filter, {everything} with all")
