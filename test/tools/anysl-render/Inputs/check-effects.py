"""Checks effects.json of anysl-render --effects against what a library for any scene says that its shader can do."""
import json
import sys

report, library = (json.load(open(path)) for path in sys.argv[1:])
effects = {effect["effect"]: effect for effect in report["effects"]}
possible = set(library["shaders"][0]["effects"]) - {"Core"}
# Each input and each output is one of its own.
found = {name.split(".")[0] for name, effect in effects.items() if effect["of"] == "shaders"}
assert found == possible, (found ^ possible)
for name, effect in effects.items():
    # Of shaders everything has a time, or a reason for none.
    assert effect["of"] == "scene" or ("seconds" in effect) != ("not measured" in effect), (name, effect)
    assert effect["kept"] == bool(effect["asking"]) and (effect["kept"] or effect["dropped"]), name
    if "instructions" not in effect:
        continue
    before, after = effect["instructions"]
    # Something else may be simpler beside it, and fewer than none is none.
    assert effect["kept"] or (after == 0 and effect["calls"][1] == 0 and effect["seconds"][1] == 0), (name, effect)
assert effects["Trace"]["instructions"][0] > 0 and effects["Trace"]["calls"][1] > 0, effects["Trace"]
assert effects["Textures"]["instructions"][0] > 0
assert effects["Outputs.Ci"]["instructions"][1] > 0 and effects["Outputs.Ci"]["calls"][1] > 0, effects["Outputs.Ci"]
assert "seconds" in effects["Inputs.N"] and "instructions" not in effects["Inputs.N"], effects["Inputs.N"]
assert report["instructions"][0] > report["instructions"][1] > 0, report["instructions"]
