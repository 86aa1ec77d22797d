"""Checks that effects.json of anysl-render --effects has the time of every effect of the scene that is kept, and no more."""
import json
import sys

report = json.load(open(sys.argv[1]))
own = [effect for effect in report["effects"] if effect["of"] == "scene"]
assert len(own) == 10, own
for effect in own:
    assert "instructions" not in effect
    assert ("seconds" in effect) == effect["kept"] == bool(effect["asking"]) != bool(effect["dropped"]), effect
