#!/usr/bin/python3
"""`fatline region`: a control point whose region is known, both methods, mistakes in the input.  Prints TAP.

The verified regions are read from the folder in FATLINE_CASES or from ../shared/cases, where they are."""

import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CASES = Path(os.environ.get("FATLINE_CASES", ROOT.parent / "shared" / "cases")) / "regions.jsonl"
PRECISIONS = ["double", "quad", "multi"]
# The parabola over [0, 1] with its middle point free: curvature keeps its sign on one side of the chord's line.
PARABOLA = {"id": "parabola", "degree": 2, "knots": None, "points": [["0", "0"], ["1", "2"], ["2", "0"]],
            "weights": None, "free": 1, "interval": ["0", "1"], "sign": -1}


def region(precision, options, line):
    command = [ROOT / "build" / "fatline", "--precision", precision, "region", *options]
    return subprocess.run([str(c) for c in command], input=line, capture_output=True, text=True)


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def half_plane(precision):
    """The edge of the parabola's region is the line through its ends, with (1, 2) inside."""
    for method in ("region_carriers", "region_cutting"):
        done = region(precision, ["-m", method], json.dumps(PARABOLA) + "\n")
        answer = json.loads(done.stdout)
        assert done.returncode == 0 and answer["kind"] == "unbounded", (method, answer)
        lines = [edge["line"] for edge in answer["edges"] if edge["type"] == "line"]
        assert lines, answer
        for a, b, c in ([number(x) for x in line] for line in lines):
            size = abs(a) + abs(b) + abs(c)
            assert abs(c) <= 1e-9 * size and abs(2 * a + c) <= 1e-9 * size, (method, lines)
            assert a + 2 * b + c > 0, (method, lines)


def wrong_sign_is_other_side(precision):
    """Negative control: with the other sign the same expectation is refuted."""
    other = dict(PARABOLA, sign=1, expected={"kind": "empty"})
    done = region(precision, ["--check"], json.dumps(other) + "\n")
    assert done.returncode == 1, (done.returncode, done.stdout, done.stderr)


def mistakes(precision):
    for field, value in (("free", 7), ("weights", ["1", "-1", "1"]), ("interval", ["1", "1"]), ("points", [["0", "0"]]),
                         ("knots", ["0", "0", "0", "1", "-1", "1"])):
        done = region(precision, [], json.dumps(dict(PARABOLA, **{field: value})) + "\n")
        assert done.returncode == 65 and field in done.stderr, (field, done.returncode, done.stderr)


def verified(precision):
    done = region(precision, ["--check", str(CASES)], "")
    assert done.returncode == 0 and " 0 wrong" in done.stdout, (done.returncode, done.stdout, done.stderr)


def main():
    tests = [(f"{test.__name__} {p}", test, p) for test in (half_plane, wrong_sign_is_other_side, mistakes)
             for p in PRECISIONS]
    if CASES.exists():
        tests += [(f"verified {p}", verified, p) for p in PRECISIONS]
    print(f"1..{len(tests) + (not CASES.exists())}")
    for k, (name, test, precision) in enumerate(tests, 1):
        try:
            test(precision)
            print(f"ok {k} - {name}")
        except (AssertionError, ValueError, KeyError) as why:
            print(f"not ok {k} - {name}\n# {why}")
    if not CASES.exists():
        print(f"ok {len(tests) + 1} - verified # SKIP no file {CASES.name} beside the project")


if __name__ == "__main__":
    main()
