"""Runs anysl-shade on each library at each of its widths; prints what it printed, which must be the same each time.

usage: at-every-width.py LIBRARY... -- ARGUMENT...
"""
import json
import subprocess
import sys

split = sys.argv.index("--")
libraries, arguments = sys.argv[1:split], sys.argv[split + 1:]


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, (command, done)
    return done.stdout


first = None
for library in libraries:
    info = json.loads(run("anysl-info", "--json", library))
    for width in info["shaders"][0]["widths"]:
        text = run("anysl-shade", library, "--width", str(width), *arguments)
        first = first or text
        assert text == first, f"{library} at width {width}:\n{text}instead of:\n{first}"
print(first, end="")
