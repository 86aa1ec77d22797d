"""Checks the relations that must hold in a report of anysl-render --accuracy-report of ball.rib, whose shader is noisy.

usage: check-accuracy.py FOLDER
"""
import json
import sys
import xml.etree.ElementTree as ElementTree

folder = sys.argv[1]
report = json.load(open(folder + "/accuracy.json"))
by = {}
for s in report["settings"]:
    by.setdefault(s["changed"], {})[s["to"]] = s
    assert s["seconds"] > 0 and 0 < s["flip"] < 1 and s["rmse"] > 0, s
assert list(by["math"]) == ["cr", "u10", "u35", "fast"]
# More samples, of either kind, make both errors smaller. The shader's own do nothing for the ball's edge.
for kind, counts, most in (("samples", ["1", "4", "16", "64"], 0.5), ("ownSamples", ["1", "2", "4", "8"], 0.9)):
    for measure in ("rmse", "flip"):
        errors = [by[kind][count][measure] for count in counts]
        assert errors == sorted(errors, reverse=True) and errors[-1] < most * errors[0], (kind, errors)
# Tiers and reals change what the same samples give, by no more than the tiers' bounds allow; against the noise that is nothing.
assert by["real"]["double"]["sameSamplesRmse"] == 0 and by["real"]["double"]["sameSamplesFlip"] == 0
assert by["math"]["fast"]["sameSamplesRmse"] >= by["math"]["cr"]["sameSamplesRmse"]
for s in list(by["math"].values()) + list(by["real"].values()):
    assert s["sameSamplesRmse"] < 1e-3 * s["rmse"], s
    assert abs(s["rmse"] / by["math"]["cr"]["rmse"] - 1) < 1e-3, s
svg = ElementTree.parse(folder + "/accuracy.svg").getroot()
points = [e for e in svg.iter() if (e.get("class") or "").split()[:1] == ["point"]]
assert len(points) == len(report["settings"])
page = open(folder + "/accuracy.html").read()
assert "<script" not in page and "src=" not in page and "href=" not in page
print("everything holds")
