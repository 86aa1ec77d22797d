"""Checks that objects linked for scenes have no symbol and no call of an effect that the scene does not call for.

    dropped-symbols.py FOLDER SCENE.rib... -- SHADER.stc.bc OTHER.stc.bc...
"""
import json
import pathlib
import re
import subprocess
import sys

# Names of what the packet runtime keeps apart, and the effects that lead there: shadows of lights are part of loops over lights,
# environment("raytrace") traces, and shadow() is a lookup.
LIGHTING = {"Lights", "Diffuse", "Specular", "LightValues", "Solar"}
SYMBOLS = {
    "packet_trace": {"Trace", "Textures"},
    "packet_hit": {"Trace", "Indirect", "Textures"},
    "packet_texture": {"Textures"},
    "packet_transmission": {"Shadows", "Textures"} | LIGHTING,
    "packet_light": {"Shadows", "Textures"} | LIGHTING,
    "spaceMatrix": {"Spaces", "Textures"},
}


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def names(path):
    """All that symbols, relocations and calls in an object name."""
    return run("llvm-nm", path) + run("llvm-objdump", "-d", "-r", path)


folder = pathlib.Path(sys.argv[1])
divider = sys.argv.index("--")
scenes, shader, others = sys.argv[2:divider], sys.argv[divider + 1], sys.argv[divider + 2:]
general = folder / "general.o"
run("anysl-link", shader, "-o", general, "--width", "1,8")
found = names(general)
assert all(re.search(symbol, found) for symbol in SYMBOLS), "the general object has all of them"
absent = set()
for scene in scenes:
    special, report = folder / "special.o", folder / "special.json"
    beside = [word for other in others for word in ("--beside", other)]
    run("anysl-link", shader, "-o", special, "--width", "1,8", "--scene", scene, *beside, "--report", report)
    uses = json.loads(report.read_text())["shaders"][0]["effectUses"]
    kept = {use["effect"] for use in uses if use["kept"]}
    found = names(special)
    for symbol, effects in SYMBOLS.items():
        if effects & kept:
            continue
        absent.add(symbol)
        print(pathlib.Path(scene).name, "without", symbol)
        assert not re.search(symbol, found), f"{scene} calls for none of {effects}, and there is {symbol}"
assert absent == set(SYMBOLS), "each is absent somewhere"
