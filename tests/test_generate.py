#!/usr/bin/python3
"""Every family at every kind of degrees: the same bytes again, coordinates that are doubles, and what is planted
holds in exact arithmetic.  Prints TAP.

Multiplicities are codimensions of ideals of power series, which shares nothing with the generator.
"""

import json
import os
import subprocess
import sys
from fractions import Fraction
from math import comb, lcm

from runner import ROOT, run_tests

GENERATE = os.environ.get("FATLINE_GENERATE", str(ROOT / "build/double/fatline-generate"))
TRUTH = os.environ.get("FATLINE_TRUTH", str(ROOT / "build/double/fatline-truth"))
DEGREES = ["1", "2", "3", "4", "5", "8", "2x1", "1x3", "3x5", "8x2", "2x8", "12", "32", "32x31"]
COUNT = 8
PRODUCT_MAX = 25  # degree product up to which a common arc is proved


def generate(*arguments):
    return subprocess.run([GENERATE, *map(str, arguments)], capture_output=True, text=True)


# ---- exact arithmetic -----------------------------------------------------------------------------------------


def points(curve):
    """Homogeneous Bernstein coefficients (x w, y w, w)."""
    weights = [Fraction(w) for w in curve.get("weights", ["1"] * (curve["degree"] + 1))]
    return [(Fraction(x) * w, Fraction(y) * w, w) for (x, y), w in zip(curve["points"], weights)]


def value(p, t):
    """Euclidean point by de Casteljau."""
    while len(p) > 1:
        p = [tuple((1 - t) * a + t * b for a, b in zip(u, v)) for u, v in zip(p, p[1:])]
    return p[0][0] / p[0][2], p[0][1] / p[0][2]


def power(p, k, shift):
    """Coefficients of coordinate k in u = t - shift."""
    n = len(p) - 1
    out = [Fraction(0)] * (n + 1)
    for i in range(n + 1):
        term = [p[i][k] * comb(n, i)]
        for root in [(shift, 1)] * i + [(1 - shift, -1)] * (n - i):
            term = [a * root[0] + b * root[1] for a, b in zip(term + [0], [0] + term)]
        out = [a + b for a, b in zip(out, term)]
    return out


def determinant(rows):
    """Of integers, by Bareiss' elimination without fractions."""
    rows, sign, before = [r[:] for r in rows], 1, 1
    for k in range(len(rows) - 1):
        pivot = next((i for i in range(k, len(rows)) if rows[i][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            rows[k], rows[pivot], sign = rows[pivot], rows[k], -sign
        for i in range(k + 1, len(rows)):
            for j in range(k + 1, len(rows)):
                rows[i][j] = (rows[i][j] * rows[k][k] - rows[i][k] * rows[k][j]) // before
        before = rows[k][k]
    return sign * rows[-1][-1]


def integers(*lists):
    """The same numbers times one integer that makes all of them integers."""
    scale = lcm(*(a.denominator for one in lists for a in one))
    return [[int(a * scale) for a in one] for one in lists]


def rank(rows):
    found, rows = 0, [r for r in rows if any(r)]
    for column in range(len(rows[0]) if rows else 0):
        pivot = next((r for r in rows if r[column]), None)
        if pivot is None:
            continue
        found += 1
        rows.remove(pivot)
        rows = [[a - r[column] / pivot[column] * b for a, b in zip(r, pivot)] if r[column] else r for r in rows]
        rows = [r for r in rows if any(r)]
    return found


def codimension(equations, order):
    """Of the ideal of the two equations and all monomials of degree `order`, in the power series."""
    monomials = [(a, b) for a in range(order) for b in range(order - a)]
    place = {one: k for k, one in enumerate(monomials)}
    rows = []
    for equation in equations:
        for a, b in monomials:
            row = [Fraction(0)] * len(monomials)
            for (i, j), c in equation.items():
                if (i + a, j + b) in place:
                    row[place[i + a, j + b]] = c
            rows.append(row)
    return len(monomials) - rank(rows)


def has_multiplicity(f, g, t, s, expected):
    """Codimension of the ideal of the equations f = g at (t, s): reached when it no longer grows (Nakayama)."""
    fx, fy, fw = (power(f, k, t) for k in range(3))
    gx, gy, gw = (power(g, k, s) for k in range(3))
    equations = []
    for a, b in ((fx, gx), (fy, gy)):
        equations.append({(i, j): a[i] * gw[j] - fw[i] * b[j] for i in range(len(a)) for j in range(len(b))
                          if i + j <= expected})
    return codimension(equations, expected) == codimension(equations, expected + 1) == expected


# ---- what must hold of a line ---------------------------------------------------------------------------------


def check_doubles(line):
    for curve in (line["f"], line["g"]):
        pairs = list(zip(curve["points"], curve["f64"], strict=True))
        assert len(pairs) == curve["degree"] + 1, "number of points"
        for exact, double in pairs:
            assert [Fraction(a) for a in exact] == [Fraction(a) for a in double], f"{exact} is not {double}"
        if "weights" in curve:
            assert [Fraction(w) for w in curve["weights"]] == [Fraction(w) for w in curve["w64"]], "weights"
            assert min(curve["w64"]) > 0, "weights"


def check_planted(line):
    f, g = points(line["f"]), points(line["g"])
    for solution in line.get("planted", []):
        t, s = Fraction(solution["t"]), Fraction(solution["s"])
        assert 0 <= t <= 1 and 0 <= s <= 1, "outside the domains"
        assert value(f, t) == value(g, s), f"f({t}) is not g({s})"
        assert has_multiplicity(f, g, t, s, solution["mult"]), f"multiplicity at t = {t} is not {solution['mult']}"


def check_overlap(line):
    """More common points than Bezout allows."""
    if "planted_overlap" not in line:
        return
    f, g = points(line["f"]), points(line["g"])
    t0, t1, s0, s1 = map(Fraction, line["planted_overlap"])
    assert 0 <= t0 < t1 <= 1 and 0 <= s0 <= 1 and 0 <= s1 <= 1 and s0 != s1, "outside the domains"
    assert value(f, t0) == value(g, s0) and value(f, t1) == value(g, s1), "the ends differ"
    # g's points satisfy f's implicit equation: their resultants vanish at more than n m parameters.
    product = (len(f) - 1) * (len(g) - 1)
    if product > PRODUCT_MAX:
        return
    fx, fy, fw = (power(f, k, Fraction(0)) for k in range(3))
    n = max(i for i in range(len(f)) if fx[i] or fy[i] or fw[i])  # the true degree
    for i in range(product + 1):
        x, y = value(g, s0 + (s1 - s0) * Fraction(i, product + 1))
        p, q = (integers([a - c * w for a, w in zip(b[: n + 1], fw)])[0] for b, c in ((fx, x), (fy, y)))
        rows = [[0] * j + p[::-1] + [0] * (n - 1 - j) for j in range(n)]
        rows += [[0] * j + q[::-1] + [0] * (n - 1 - j) for j in range(n)]
        assert determinant(rows) == 0, f"g leaves f's curve at step {i}"


def check_expected(line):
    if "expected" in line:
        expected, planted = line["expected"], line.get("planted", [])
        assert expected["count"] == len(planted) == len(expected["params"]), "count"
        assert expected["exact"] == [[a["t"], a["s"]] for a in planted], "exact"
        assert expected["params"] == [[float(Fraction(a["t"])), float(Fraction(a["s"]))] for a in planted], "params"


def check_gap(line):
    """Near tangent: the gap undone, it is a contact of order 2."""
    if "gap" not in line:
        return
    f, g, gap = points(line["f"]), points(line["g"]), Fraction(line["gap"])
    t, s = map(Fraction, line["contact"])
    assert abs(gap).numerator == 1 and 5 <= gap.denominator.bit_length() - 1 <= 100, f"gap {gap}"
    (x, y), (a, b) = value(f, t), value(g, s)
    assert sorted([abs(a - x), abs(b - y)]) == [0, abs(gap)], "the gap is not where it is said"
    g = [(p[0] - (a - x) * p[2], p[1] - (b - y) * p[2], p[2]) for p in g]
    assert has_multiplicity(f, g, t, s, 2), "contact before the gap was opened"


CHECKS = [check_doubles, check_planted, check_overlap, check_expected, check_gap]


def check_lines(text, name, n, m, count):
    lines = [json.loads(one) for one in text.splitlines()]
    assert len(lines) == count, f"{len(lines)} lines"
    assert len({one["id"] for one in lines}) == count, "ids repeat"
    for index, line in enumerate(lines):
        try:
            assert line["id"] == f"{name}-{n}x{m}-7-{index}", "id"
            assert (line["f"]["degree"], line["g"]["degree"]) == (n, m), "degrees"
            for check in CHECKS:
                check(line)
        except AssertionError as wrong:
            raise AssertionError(f"{line['id']}: {wrong}") from None


# ---- the tests ------------------------------------------------------------------------------------------------


def families():
    listed = generate("--list").stdout.splitlines()
    for one in listed:
        name = one.split()[0]
        if name != "glyphs":
            yield name
            if " weights " in one:
                yield name + "_rational"


def family_holds(name):
    made = 0
    for degrees in DEGREES:
        n, m = (int(a) for a in (degrees.split("x") * 2)[:2])
        count = 4 if n * m > 40 else COUNT
        answer = generate(name, "--degree", degrees, "--count", count, "--seed", 7)
        if answer.returncode == 64:
            assert degrees in answer.stderr or f"{n}x{m}" in answer.stderr, answer.stderr
            continue
        assert answer.returncode == 0, answer.stderr
        check_lines(answer.stdout, name, n, m, count)
        again = generate(name, "--degree", degrees, "--count", 1, "--seed", 7, "--first", count - 1)
        assert again.stdout == answer.stdout.splitlines(True)[-1], "not the same case when made alone"
        made += 1
    assert made, "no degrees at all"


def seeds_differ():
    assert generate("random", "--seed", 1).stdout != generate("random", "--seed", 2).stdout


def bytes_are_these():
    """The same everywhere: a line as it was when this was written."""
    line = json.loads(generate("nice", "--degree", "3x2", "--seed", 5).stdout)
    assert line["f"]["points"] == NICE_F, line["f"]["points"]
    assert line["planted"] == NICE_PLANTED, line["planted"]


def sweep_keeps_parameters():
    for index in range(20):
        seen = {json.dumps(json.loads(one)["planted"]) for one in generate(
            "degree_sweep", "--degree", "2,3,5,9,14,21,27,31,32,32x31,17x29", "--first", index).stdout.splitlines()}
        assert len(seen) == 1, f"case {index}: {seen}"


def gaps_of_both_signs():
    lines = [json.loads(a) for a in generate("near_tangent", "--degree", 3, "--count", 92).stdout.splitlines()]
    exponents = [Fraction(a["gap"]).denominator.bit_length() - 1 for a in lines]
    assert sorted(exponents) == sorted(2 * list(range(5, 51)))
    one = json.loads(generate("near_tangent", "--degree", 8, "--gap", 50).stdout)
    assert abs(Fraction(one["gap"])) == Fraction(1, 2**50)


def gaps_beyond_doubles():
    """Lines without doubles, the gap exact; pairs that meet and pairs that do not, with weights too."""
    for name in ("near_tangent", "near_tangent_rational"):
        lines = [json.loads(a) for a in generate(name, "--degree", "3,5", "--gap", "51-100", "--count", 20, "--first",
                                                 90).stdout.splitlines()]
        assert len(lines) == 40
        for index, line in enumerate(lines):
            assert Fraction(line["gap"]).denominator == 2**(51 + (90 + index % 20) // 2 % 50), line["id"]
            assert "f64" not in line["f"] and "w64" not in line["g"], line["id"]
            rounded = any(Fraction(a) != Fraction(float(Fraction(a))) for p in line["g"]["points"] for a in p)
            assert rounded or Fraction(line["gap"]).denominator < 2**60, line["id"]
            check_gap(line)
    assert generate("near_tangent", "--gap", "50-49").returncode == 64


def glyphs_are_integers():
    answer = generate("glyphs", "--count", 200, "--seed", 3)
    if answer.returncode == 2 and "not installed" in answer.stderr:
        return answer.stderr.strip()
    assert answer.returncode == 0, answer.stderr
    degrees = set()
    for line in map(json.loads, answer.stdout.splitlines()):
        check_doubles(line)
        curves = [line["f"]["f64"], line["g"]["f64"]]
        assert all(isinstance(a, int) for curve in curves for p in curve for a in p), line["id"]
        for axis in (0, 1):
            ranges = [(min(p[axis] for p in c), max(p[axis] for p in c)) for c in curves]
            assert max(a[0] for a in ranges) <= min(a[1] for a in ranges), f"{line['id']}: boxes apart"
        degrees.add(tuple(sorted((line["f"]["degree"], line["g"]["degree"]))))
    assert degrees == {(1, 2), (1, 3), (2, 2), (2, 3), (3, 3)}, degrees
    assert generate("glyphs", "--count", 1, "--seed", 3, "--first", 199).stdout == answer.stdout.splitlines(True)[-1]
    return None


def mistakes_are_told():
    for status, words, arguments in [(64, "no family", ["nothing"]), (64, "--degree", ["random", "--degree", "33"]),
                                     (64, "from degrees", ["contact_4", "--degree", "2"]),
                                     (64, "no rational variant", ["nine", "--weights"]),
                                     (64, "--count", ["random", "--count", "-1"]),
                                     (64, "--gap", ["near_tangent", "--gap", "101"]),
                                     (64, "which family", []),
                                     (2, "not installed", ["glyphs", "--fonts", "DejaVu Sans,Nobody's Font"])]:
        answer = generate(*arguments)
        assert answer.returncode == status and words in answer.stderr, (arguments, answer)
        assert answer.stdout == ""


def check_against_truth(line, truth):
    expected = truth["expected"]
    found = {tuple(a): m for a, m in zip(expected["exact"], expected["mult"])}
    for a in line.get("planted", []):
        assert found.get((a["t"], a["s"]), 0) in (a["mult"], None), f"{a} in {found}"
    if "expected" in line:
        assert line["expected"]["count"] == expected["count"], f"count {expected['count']}"
    if "planted_count" in line:
        assert expected["mult"] == [1] * line["planted_count"], f"{expected['mult']}"
    if "planted_overlap" in line:
        assert [float(Fraction(a)) for a in line["planted_overlap"]] in expected["overlap"], f"{expected['overlap']}"
    assert line.get("class", truth["class"]) == truth["class"], f"class {truth['class']}"


def quick_list_agrees_with_truth():
    """Three cases of each line of datasets/families.txt, degree product up to 25."""
    text = ""
    for row in (ROOT / "datasets/families.txt").read_text().splitlines():
        if row and not row.startswith("#"):
            name, degrees, count, seed = row.split()
            small = [a for a in degrees.split(",") if a != "-" and max(map(int, a.split("x"))) <= 5]
            made = generate(name, *(["--degree", ",".join(small)] if small else []), "--count", min(int(count), 3),
                            "--seed", seed)
            if made.returncode == 2 and "not installed" in made.stderr:
                continue
            assert made.returncode == 0, made.stderr
            text += made.stdout
    answer = subprocess.run([TRUTH, "--quiet", "-"], input=text, capture_output=True, text=True)
    assert answer.returncode == 0, answer.stderr
    for line, truth in zip(text.splitlines(), answer.stdout.splitlines(), strict=True):
        line, truth = json.loads(line), json.loads(truth)
        try:
            check_against_truth(line, truth)
        except AssertionError as wrong:
            raise AssertionError(f"{line['id']}: {wrong}") from None


def published_is_true():
    answer = subprocess.run([TRUTH, "--quiet", "--compare", str(ROOT / "datasets/published.jsonl")],
                            capture_output=True, text=True)
    assert answer.returncode == 0, answer.stdout + answer.stderr


NICE_F = [["1/16", "1/2"], ["11/128", "175/256"], ["15/256", "191/256"], ["-59/512", "449/512"]]
NICE_PLANTED = [{"t": "3/4", "s": "13/32", "mult": 1}]

if __name__ == "__main__":
    tests = [(f"family {name}", lambda name=name: family_holds(name)) for name in families()]
    tests += [(test.__name__, test) for test in (seeds_differ, bytes_are_these, sweep_keeps_parameters,
                                                 gaps_of_both_signs, gaps_beyond_doubles, glyphs_are_integers,
                                                 mistakes_are_told, quick_list_agrees_with_truth, published_is_true)]
    only = sys.argv[1:]
    run_tests([one for one in tests if not only or any(word in one[0] for word in only)])
