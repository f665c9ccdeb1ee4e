#!/usr/bin/env python3
"""Follows every number in the tables of a report to the file of the workspace that it is taken from.

Usage: check_report.py WORKSPACE   (exit 0: every number is traced and right; 1: it is not)

Numbers are <data value='exact' title='formula'>shown</data>. The formula is evaluated here, from the
files alone: members of JSON files, parameters of COLMAP cameras, medians computed anew. The shown text
must be that value, rounded. A number in a cell of figures without such a source is an error.
"""
import html.parser
import json
import math
import pathlib
import re
import sys

REFERENCE = re.compile(r"([\w./-]+\.(?:json|txt))#([^\s,()]+)")
NUMBER = re.compile(r"[+-]?\d")
CAMERA_MODELS = {
    "SIMPLE_PINHOLE": ["f", "cx", "cy"],
    "PINHOLE": ["f", "fy", "cx", "cy"],
    "SIMPLE_RADIAL": ["f", "cx", "cy", "k1"],
    "RADIAL": ["f", "cx", "cy", "k1", "k2"],
    "OPENCV": ["f", "fy", "cx", "cy", "k1", "k2", "p1", "p2"],
    "FULL_OPENCV": ["f", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"],
}


class Numbers(html.parser.HTMLParser):
    """All <data> of the page, and what of its tables of figures lies outside of them."""

    def __init__(self):
        super().__init__()
        self.data = []
        self.untraced = []
        self.cell = False
        self.open = None

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if tag == "table":
            self.lights = attrs.get("class") == "lights"
        if tag == "td":
            self.cell = attrs.get("class") == "v" or (self.lights and not attrs)
        if tag == "data":
            self.open = [attrs, ""]

    def handle_endtag(self, tag):
        if tag == "data":
            self.data.append((self.open[0], self.open[1]))
            self.open = None
        if tag == "td":
            self.cell = False

    def handle_data(self, text):
        if self.open is not None:
            self.open[1] += text
        elif self.cell and NUMBER.match(text.strip()):
            self.untraced.append(text.strip())


class Workspace:
    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.files = {}

    def json(self, name):
        if name not in self.files:
            self.files[name] = json.loads((self.root / name).read_text())
        return self.files[name]

    def rows(self, name):
        lines = (self.root / name).read_text().splitlines()
        return [line for line in lines if not line.startswith("#")]

    def camera(self, name, key):
        wanted, parameter = key.split("/")
        for line in self.rows(name):
            camera, model, width, height, *values = line.split()
            if camera != wanted:
                continue
            given = dict(zip(CAMERA_MODELS[model], map(float, values)))
            given["focal_px"] = given["f"]
            given["center_x_px"] = given["cx"] - int(width) / 2
            given["center_y_px"] = given["cy"] - int(height) / 2
            return given.get(parameter, 0.0)
        raise KeyError(f"{name} has no camera {wanted}")

    def member(self, name, key):
        if name.endswith(".txt"):
            return self.camera(name, key)
        value = self.json(name)
        for part in key.lstrip("/").split("/"):
            part = part.replace("~1", "/").replace("~0", "~")
            value = value[int(part)] if isinstance(value, list) else value[part]
        return value

    def median_observations(self, name):
        # Two lines an image, the second may be empty; it lists triples x y id.
        lines = self.rows(name)
        counts = sorted(len(line.split()) // 3 for line in lines[1::2])
        # The smallest value that half of them do not exceed, or the mean of the two in the middle.
        middle = [counts[(len(counts) - 1) // 2], counts[len(counts) // 2]]
        return middle

    def value(self, formula):
        whole = REFERENCE.fullmatch(formula)
        if whole:
            return self.member(*whole.groups())
        names = {}

        def name_of(match):
            names[f"v{len(names)}"] = self.member(*match.groups())
            return f"v{len(names) - 1}"

        expression = REFERENCE.sub(name_of, formula)
        allowed = {n: getattr(math, n) for n in ("sqrt", "hypot", "atan2", "degrees")}
        return eval(expression, {"__builtins__": {}}, {**allowed, **names, "max": max, "shift": shift})


def shift(own, result, at, axis):
    """Where one pose puts what another one puts at `at`, less `at`; poses are 4 x 4, row-major."""
    rotated = [at[i] - result[4 * i + 3] for i in range(3)]
    source = [sum(result[4 * k + i] * rotated[k] for k in range(3)) for i in range(3)]
    return sum(own[4 * axis + k] * source[k] for k in range(3)) + own[4 * axis + 3] - at[axis]


def as_text(value):
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "–" if value is None else value


def complaint(workspace, attrs, shown):
    formula = attrs["title"]
    if "value" not in attrs:
        value = workspace.value(formula)
        if shown == as_text(value) or shown == f"{len(value)} entries" or json.loads(shown) == value:
            return None
        return f"shows {shown!r}, the file says {value!r}"
    exact = float(attrs["value"])
    if formula.startswith("median observations of "):
        low, high = workspace.median_observations(formula.rsplit(" ", 1)[1])
        truth = min(max(exact, low), high)
    else:
        truth = workspace.value(formula)
    if not math.isclose(exact, truth, rel_tol=1e-6, abs_tol=1e-6):
        return f"carries {exact!r}, the files say {truth!r}"
    digits = re.fullmatch(r"[+-]?\d+(?:\.(\d+))?(?:e([+-]\d+))?", shown)
    if not digits:
        return f"shows {shown!r}, which is no number"
    half = 0.5 * 10.0 ** (int(digits[2] or 0) - len(digits[1] or ""))
    if abs(float(shown) - truth) > half * 1.000001 + 1e-6 * abs(truth):
        return f"shows {shown}, the files say {truth!r}"
    return None


def main():
    workspace = Workspace(sys.argv[1])
    page = Numbers()
    page.feed((workspace.root / "report/index.html").read_text())
    wrong = [f"{text}: no source" for text in page.untraced]
    for attrs, shown in page.data:
        try:
            reason = complaint(workspace, attrs, shown)
        except (OSError, KeyError, IndexError, ValueError, TypeError, NameError, SyntaxError) as error:
            reason = f"{type(error).__name__}: {error}"
        if reason:
            wrong.append(f"{attrs.get('title')}: {reason}")
    for line in wrong[:20]:
        print(line)
    print(f"{len(page.data)} numbers, {len(wrong)} wrong")
    return 1 if wrong or not page.data else 0


if __name__ == "__main__":
    sys.exit(main())
