"""Checks the relations that must hold in a report of anysl-cost, and that its three forms agree.

usage: check-report.py FOLDER [--exact | --inexact]   the shader's results are exact in every variant, or in none of float
"""
import csv
import html.parser
import json
import math
import sys
import xml.etree.ElementTree as ElementTree

folder = sys.argv[1]
report = json.load(open(folder + "/report.json"))
tiers = ["cr", "u10", "u35", "fast"]
wrong = []
# What the functions of wavy.sl see where s and t go from 0 to 1.
ARGUMENTS = {"sin": [(0, 9)], "cos": [(0, 9)], "exp": [(-3, 0)], "pow": [(math.exp(-3), 1), (0.7, 0.7)]} if "--inexact" in sys.argv else {}


def expect(holds, what):
    if not holds:
        wrong.append(what)


def check_variant(v):
    name = v["name"]
    error, arithmetic, tier = (v[part] for part in ("error", "arithmetic", "tier"))
    for measure in ("max", "rms", "maxUlps", "rmsUlps"):
        expect(error[measure] <= (arithmetic[measure] + tier[measure]) * (1 + 1e-9), f"{name}: {measure} is no more than the sum of its parts")
        expect(abs(arithmetic[measure] - tier[measure]) <= error[measure] * (1 + 1e-9) + 1e-300, f"{name}: {measure} is no less than the difference of its parts")
    for part in (error, arithmetic, tier):
        expect(0 <= part["rms"] <= part["max"] and part["p999"] <= part["max"], f"{name}: the largest is the largest")
        expect(0 <= part["changed8"] <= part["changed16"] <= 1, f"{name}: finer pixels change more often")
        expect(part["numbers"] == report_points * 6, f"{name}: all numbers of Ci and Oi")
    if v["math"] == "cr":
        expect(tier["max"] == 0, f"{name}: correctly rounded functions add no error")
    time = v["nsPerPoint"]
    expect(0 < time["lowerQuartile"] <= time["median"] <= time["upperQuartile"], f"{name}: quartiles about the median")


def check_shader(shader):
    variants = shader["variants"]
    for v in variants:
        check_variant(v)
    find = {}
    for v in variants:
        for math_name in [v["math"]] + v["sameCode"]:
            find[v["real"], math_name, v["width"]] = v
    for real in ("float", "double"):
        widths = (1, 4, 8, 16) if real == "float" else {w for r, m, w in find if r == real}
        for tier in tiers:
            for width in widths:
                expect((real, tier, width) in find, f"{real} {tier} x{width} is there")
    plain = [find[key] for key in find if key[1] in tiers]
    floats = [v for v in plain if v["real"] == "float"]
    # One float arithmetic, whatever the tier and the width.
    expect(len({v["arithmetic"]["rms"] for v in floats}) == 1, "the floor is the same for every tier and width")
    for tier in tiers:
        expect(len({find["float", tier, w]["error"]["rms"] for w in (1, 4, 8, 16)}) == 1, f"{tier} gives the same at every width")
    doubles = [v for v in plain if v["real"] == "double"]
    if "--inexact" in sys.argv:
        expect(floats[0]["arithmetic"]["rms"] > 0, "floats round")
        expect(all(v["error"]["rms"] < 1e-6 * floats[0]["arithmetic"]["rms"] for v in doubles), "double is far below float")
        by_tier = [find["float", tier, 1]["tier"]["rms"] for tier in tiers]
        expect(by_tier[1] < by_tier[3], "fast is less exact than u10")
        expect(by_tier[2] < by_tier[3], "fast is less exact than u35")
    if "--exact" in sys.argv:
        expect(all(v["error"]["max"] == 0 for v in variants), "everything is exact")
    front = [v for v in variants if v["onFront"]]
    cost = lambda v: (v["error"]["rms"], v["nsPerPoint"]["median"])
    for v in variants:
        beaten = any(cost(o)[0] <= cost(v)[0] and cost(o)[1] <= cost(v)[1] and cost(o) != cost(v) for o in variants)
        expect(v["onFront"] != beaten or sum(cost(o) == cost(v) for o in variants) > 1, v["name"] + ": on the front unless another is better")
    expect(front, "there is a front")
    mixtures = [v for v in variants if "," in v["math"]]
    for v in mixtures:
        worst = max(find["float", tier, 1]["tier"]["rms"] for tier in tiers)
        expect(v["tier"]["rms"] <= 2 * worst, v["name"] + ": a mixture is no worse than its worst part, twice over")
    sites = shader["sites"]
    expect("--inexact" not in sys.argv or (mixtures and len(sites) >= 4), "there are mixtures, and sites")
    for site in sites:
        place = f"{site['file']}:{site['line']} {site['function']}"
        line = open(site["file"]).read().splitlines()[site["line"] - 1]
        expect(site["function"] in line, place + ": the line calls the function")
        expect(site["chosen"] in tiers and site["function"] in shader["functions"], place + ": of a tier")
        expect(0 <= site["errorShare"] <= 1 and site["timeShare"] < 1, place + ": shares")
        if site["function"] in ARGUMENTS:
            expect(site["calls"] == shader["points"], place + ": is called once a point")
            for seen, known in zip(site["arguments"], ARGUMENTS[site["function"]], strict=True):
                expect(all(math.isclose(a, b, rel_tol=0.02, abs_tol=0.02) for a, b in zip(seen, known)), f"{place}: sees {known}, not {seen}")
        for option in site["options"]:
            expect(option["tier"] in tiers[1:] and option["added"]["rms"] >= 0, place + ": options")
    total = sum(site["errorShare"] for site in sites)
    expect(not sites or total == 0 or math.isclose(total, 1, rel_tol=1e-9), "shares of the error add up")


class Page(html.parser.HTMLParser):
    """Counts elements and notes whatever would be fetched."""

    def __init__(self):
        super().__init__()
        self.count, self.fetched, self.open = {}, [], []

    def handle_starttag(self, tag, attributes):
        self.count[tag] = self.count.get(tag, 0) + 1
        if tag in ("script", "link", "img", "iframe", "object"):
            self.fetched.append(tag)
        self.fetched += [value for key, value in attributes if key in ("src", "href") or "url(" in (value or "")]
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        self.open.pop()

    def handle_endtag(self, tag):
        expect(self.open and self.open.pop() == tag, f"</{tag}> closes what is open")


text = open(folder + "/report.html").read()
page = Page()
page.feed(text)
expect(not page.open, "every element is closed")
expect(not page.fetched and "@import" not in text and "url(" not in text, f"nothing is fetched: {page.fetched}")
expect(page.count.get("svg") == len(report["shaders"]), "a plot for each shader")
expect(text.index("<svg") < text.index("<table"), "the picture comes first")
expect("prefers-color-scheme: dark" in text, "there are dark colours")

pieces = text.split("<svg")[1:]
for shader, piece in zip(report["shaders"], pieces):
    report_points = shader["points"]
    check_shader(shader)
    svg = ElementTree.fromstring("<svg" + piece.split("</svg>")[0] + "</svg>")
    titles = [e.text for e in svg.iter() if e.get("class") == "tip-title"]
    expect(sorted(titles) == sorted(v["name"] for v in shader["variants"]), "every variant is in the plot")
    fronts = [e for e in svg.iter() if (e.get("class") or "").startswith("point") and "on-front" in e.get("class")]
    expect(len(fronts) == sum(v["onFront"] for v in shader["variants"]), "the front is marked")
    labels = {e.text for e in svg.iter() if (e.get("class") or "") == "label front-label"}
    expect(labels or len(fronts) == 0, "the front is labelled")

rows = list(csv.DictReader(open(folder + "/report.csv")))
listed = [(shader, v) for shader in report["shaders"] for v in shader["variants"]]
expect(len(rows) == len(listed), "a row for each variant")
for row, (shader, v) in zip(rows, listed):
    expect((row["shader"], row["real"], row["math"], row["width"]) == (shader["shader"], v["real"], v["math"], str(v["width"])), "rows in order")
    expect(math.isclose(float(row["ns_per_point"]), v["nsPerPoint"]["median"], rel_tol=1e-5), "CSV has the time of JSON")
    expect(math.isclose(float(row["error_rms"]), v["error"]["rms"], rel_tol=1e-5, abs_tol=1e-300), "CSV has the error of JSON")

for line in sorted(set(wrong)):
    print("does not hold:", line)
if not wrong:
    print(f"{len(listed)} variants: everything holds")
sys.exit(bool(wrong))
