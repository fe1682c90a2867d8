#!/usr/bin/python3
"""`fatline region`: control points whose regions are known, both methods, mistakes in the input.  Prints TAP.

The verified regions are read from the folder in FATLINE_CASES or from ../shared/cases, where they are."""

import json

import runner
from runner import ROOT, Skipped, at_each_precision, number, run_tests

CASES = runner.CASES / "regions.jsonl"
OWN = ROOT / "datasets" / "regions.jsonl"
# The parabola over [0, 1] with its middle point free: curvature keeps its sign on one side of the chord's line.
PARABOLA = {"id": "parabola", "degree": 2, "knots": None, "points": [["0", "0"], ["1", "2"], ["2", "0"]],
            "weights": None, "free": 1, "interval": ["0", "1"], "sign": -1}


def region(precision, options, line):
    return runner.fatline("region", *options, text=line, precision=precision)


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


# What is wrong, the field the complaint names, and a word of the complaint.
SPLINE = dict(PARABOLA, points=[["0", "0"], ["1", "2"], ["2", "0"], ["3", "1"]], knots=[0, 0, 0, "1/2", 1, 1, 1])
MISTAKES = [
    (dict(PARABOLA, free=7), "free", "expected"), (dict(PARABOLA, free=-1), "free", "expected"),
    (dict(PARABOLA, free=[]), "free", "expected"), (dict(PARABOLA, free={"t": 2}), "free.t", "interval"),
    (dict(PARABOLA, weights=["1", "-1", "1"]), "weights[1]", "positive"),
    (dict(PARABOLA, weights=["1", "0", "1"]), "weights[1]", "positive"),
    (dict(PARABOLA, weights=["1", "1"]), "weights", "3"),
    (dict(PARABOLA, interval=["1", "1"]), "interval", "empty"), (dict(PARABOLA, interval=["1/2", "0"]), "interval", "empty"),
    (dict(PARABOLA, interval=["0", "2"]), "interval", "not inside"),
    (dict(PARABOLA, points=[["0", "0"]]), "points", "expected"),
    (dict(PARABOLA, points=[["1", "1"], ["1", "1"], ["1", "1"]]), "points", "length"),
    (dict(PARABOLA, points=[["0", "0"], ["1", "x"], ["1", "1"]]), "points[1][1]", "expected"),
    (dict(PARABOLA, degree=3), "points", "degree 3 needs 4"), (dict(PARABOLA, degree=1), "degree", "expected"),
    (dict(SPLINE, knots=[0, 0, 0, 1, "1/2", 1, 1]), "knots[4]", "decrease"),
    (dict(SPLINE, knots=[0, 0, 0, 1, 1, 1]), "knots", "7"),
    (dict(SPLINE, points=SPLINE["points"] + SPLINE["points"][:2], knots=[0, 0, 0, "1/2", "1/2", "1/2", 1, 1, 1]),
     "knots", "repeated"),
    (dict(PARABOLA, sign=0), "sign", "expected 1 or -1"), (dict(PARABOLA, loop_free=1), "loop_free", "true or false"),
    (dict(PARABOLA, wieghts=None), "wieghts", "unknown"), (dict(PARABOLA, id=3), "id", "expected text"),
]


def mistakes(precision):
    """Each is refused with file:line: field: what is wrong; the line before it is answered, the next only on request."""
    good = json.dumps(PARABOLA) + "\n"
    for line, field, word in MISTAKES:
        done = region(precision, [], good + json.dumps(line) + "\n" + good)
        where, _, complaint = done.stderr.partition(f" {field}")
        assert done.returncode == 65 and where == "stdin:2:" and word in complaint, (line, done.returncode, done.stderr)
        assert len(done.stdout.splitlines()) == 1, (line, done.stdout)
    lines = good + "".join(json.dumps(line) + "\n" for line, _, _ in MISTAKES) + "nonsense\n[]\n" + good
    done = region(precision, ["--keep-going"], lines)
    assert done.returncode == 65 and len(done.stdout.splitlines()) == 2, (done.returncode, done.stderr)
    assert len(done.stderr.splitlines()) == len(MISTAKES) + 2, done.stderr


def degenerate(precision):
    """The project's own cases: points, segments, rays and lines left by the closed conditions, the paper's example."""
    done = region(precision, ["--check", OWN], "")
    assert done.returncode == 0 and " 0 wrong" in done.stdout, (done.returncode, done.stdout, done.stderr)
    kinds = [json.loads(line)["expected"]["closed_kind"] for line in open(OWN) if "degenerate" in line]
    assert all(kinds.count(kind) >= 2 for kind in ("point", "segment", "ray", "line")) and len(kinds) >= 10, kinds
    point = next(json.loads(line) for line in open(OWN) if '"degenerate-point"' in line)
    point["expected"]["closed"] = [["-9", "0"]]  # negative control
    done = region(precision, ["--check"], json.dumps(point))
    assert done.returncode == 1 and "closed" in done.stdout, (done.returncode, done.stdout)


def triangle(precision):
    """The paper's example (Karousos): a triangle, to the figures of an independent computation in 60 digits."""
    line = next(line for line in open(OWN) if '"karousos-quintic"' in line)
    answer = json.loads(region(precision, [], line).stdout)
    close = 1e-12
    assert answer["kind"] == "bounded" and answer["certified"] and len(answer["vertices"]) == 3, answer
    assert abs(number(answer["area"]) - 246.77605535129645) <= 246 * close, answer["area"]
    assert abs(number(answer["disc"]["radius"]) - 6.834669324435441) <= 7 * 1e-9, answer["disc"]
    for x, y in ((16.3602104622995783, 15.5050859720125890), (1.1337995080074070, 37.1478787208192582),
                 (-6.9266338180725433, 16.1907520730113876)):
        assert any(abs(number(p) - x) + abs(number(q) - y) <= 40 * close for p, q in answer["vertices"]), answer


def unsupported(precision):
    """Weights above degree 17 are not taken, and said so."""
    line = {"id": "high", "degree": 18, "points": [[i, i * i] for i in range(19)], "weights": [1] * 19, "free": 3}
    answer = json.loads(region(precision, [], json.dumps(line)).stdout)
    assert answer["outcome"] == "UNSUPPORTED" and not answer["certified"], answer


def randomly(precision):
    """`--random` is the same at every precision and for each seed; all is right, both methods agree."""
    lines = region(precision, ["--random", "60" if precision == "double" else "6", "--seed", "5"], "").stdout
    assert region("double", ["--random", "6", "--seed", "5"], "").stdout == "".join(lines.splitlines(True)[:6])
    assert region(precision, ["--random", "6", "--seed", "6"], "").stdout not in lines
    done = region(precision, ["--check", "--method", "all" if precision == "double" else "region_carriers"], lines)
    assert done.returncode == 0 and " 0 wrong" in done.stdout, (done.returncode, done.stdout, done.stderr)


def verified(precision):
    if not CASES.exists():
        raise Skipped(f"no file {CASES.name} beside the project")
    done = region(precision, ["--check", str(CASES)], "")
    assert done.returncode == 0 and " 0 wrong" in done.stdout, (done.returncode, done.stdout, done.stderr)


if __name__ == "__main__":
    run_tests(at_each_precision(half_plane, wrong_sign_is_other_side, mistakes, degenerate, triangle, unsupported,
                                randomly, verified))
