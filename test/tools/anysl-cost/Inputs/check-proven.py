"""Checks that no more points are proven stable than are not found unstable.

usage: check-proven.py REPORT.json...
"""
import json
import sys

for path in sys.argv[1:]:
    for shader in json.load(open(path))["shaders"]:
        stable = sum(lost is not None and lost <= shader["limit"] for lost in shader["lost"])
        assert shader["proven"] <= stable, (shader["shader"], shader["proven"], stable)
print("nothing proven is unstable")
