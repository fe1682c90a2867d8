#!/usr/bin/python3
"""`fatline paths`: rows, readers, mistakes in the input, times.  Prints TAP."""

import json
import tempfile
from pathlib import Path

import runner
from runner import at_each_precision, number, run_tests

FIELDS = {"segments", "t", "s", "standing"}


def fatline(precision, *options, text=None):
    return runner.fatline("paths", *options, text=text, precision=precision)


def rows(done):
    return [json.loads(line) for line in runner.expect(done, 0).splitlines()]


def of_text(precision, a, b=None, *options):
    """Rows of the texts of one or two files."""
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for name, text in (("a", a), ("b", b)):
            if text is not None:
                files.append(Path(folder, name))
                files[-1].write_text(text)
        return rows(fatline(precision, "--quiet", *options, *files))


def without_ids(answer):
    return [{k: v for k, v in row.items() if k not in ("id", "ids")} for row in answer]


def random_walks(precision):
    """The same rows each time, and from the paths as they were printed; sorted, with all fields."""
    size = ["--random", "60" if precision == "double" else "12", "--seed", "7"]
    first = rows(fatline(precision, *size))
    assert first and first == rows(fatline(precision, *size))
    assert all(FIELDS <= row.keys() and len(row["ids"]) == 2 and row["standing"] == "UNIQUE" for row in first)
    keys = [(row["segments"][0][0], number(row["t"][0])) for row in first]
    assert keys == sorted(keys)
    printed = fatline(precision, "--print", *size).stdout.splitlines()
    assert len(printed) == 2 and without_ids(of_text(precision, *printed)) == without_ids(first)
    alone = rows(fatline(precision, "--self", *size))
    assert alone == of_text(precision, printed[0]) and all(row["id"] == alone[0]["id"] for row in alone)
    assert fatline(precision, *size).stderr.count("\n") == 1 and not fatline(precision, "-q", *size).stderr


FORMS = [  # each group is one path in several forms
    ["M 0 0 L 4 0 4 4 H 0 Z", "M0,0L4,0L4,4L0,4L0,0", "m0 0 4 0 0 4h-4z", "M0 0H4V4h-4v-4",
     "M0-0 4 .0e3,4,4.0E+0 0 4 0-0", " m 0 , 0 l 4 0 v 4 H 0 V 0\n"],
    ["M1 2C1.5 3 2.25 3.5 3 3S4.5 1 5 2", "m1,2c.5 1 1.25 1.5 2 1c.75-.5 1.5-2 2-1", "M1 2c.5 1 1.25 1.5 2 1S4.5 1 5 2"],
    ["M1 2Q2 5 3 2T5 2T7 3", "m1 2q1 3 2 0t2 0 2 1", "M1 2Q2 5 3 2 4-1 5 2Q6 5 7 3"],
    ["M0 0A5 5 0 0 1 5 5", "m0 0a5,5 0 015 5", "M0 0a-5-5 0 0 1 5 5"],
    ["M0 0L1 1M2 2L3 3", "m0 0 1 1m1 1l1 1"],
]


def forms(precision):
    """Absolute, relative, implicit: the same segments bit for bit."""
    for group in FORMS:
        printed = []
        for form in group:
            done = fatline(precision, "--print", "-", text=json.dumps({"id": "p", "d": form}) + "\n")
            assert done.returncode == 0, (form, done.stderr)
            plain = fatline(precision, "--print", "-", text=form)
            assert json.loads(plain.stdout)["segments"] == json.loads(done.stdout)["segments"], form
            printed.append(json.loads(done.stdout)["segments"])
        assert all(p == printed[0] for p in printed), (group, printed)


def point(segment, t):
    points, weights = (segment["points"], segment["weights"]) if isinstance(segment, dict) else (segment, [1] * len(segment))
    level = [[number(w) * number(x), number(w) * number(y), number(w)] for (x, y), w in zip(points, weights)]
    while len(level) > 1:
        level = [[(1 - t) * a + t * b for a, b in zip(p, q)] for p, q in zip(level, level[1:])]
    x, y, w = level[0]
    return x / w, y / w


def arcs(precision):
    """Every kind of arc lies on its circle, on the side that the flags ask for; circles cross where they must."""
    for large in (0, 1):
        for sweep in (0, 1):
            text = f"M3 4A5 5 30 {large} {sweep} 3 -4"
            segments = json.loads(fatline(precision, "--print", "-", text=text).stdout)["segments"]
            centre = 0 if large == sweep else 6
            # by growing angles from (3, 4) to (3, -4): on the left, whichever the centre
            for segment in segments:
                for k in range(9):
                    x, y = point(segment, k / 8)
                    assert abs((x - centre) ** 2 + y * y - 25) < 1e-12, (text, x, y)
            middle = max((point(segment, k / 8) for segment in segments for k in range(9)), key=lambda p: abs(p[0] - 3))
            assert (middle[0] < 3) == bool(sweep), (text, middle)
    circle = "M{0} 0A5 5 0 0 1 {1} 0A5 5 0 0 1 {0} 0Z"
    left, right = circle.format(5, -5), circle.format(11, 1)
    answer = of_text(precision, left, right)
    segments = json.loads(fatline(precision, "--print", "-", text=left).stdout)["segments"]
    assert [row["standing"] for row in answer] == ["UNIQUE", "UNIQUE"], answer
    found = sorted(point(segments[row["segments"][0][0]], number(row["t"][0])) for row in answer)
    assert all(abs(x - 3) < 1e-9 and abs(abs(y) - 4) < 1e-9 for x, y in found), found
    assert of_text(precision, left) == []


def svg_file(precision):
    text = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg"><!-- <path d="M0 0L4 0"/> --><path id="first" class="a>b" d="M0 0L4 4"/>
<g><path fill='none' d='M0 4L4 0'
/></g><pathology d="M0 0"/></svg>"""
    answer = of_text(precision, text, text)
    pairs = [row["ids"] for row in answer]
    assert ["first", "path2"] in pairs and ["path2", "first"] in pairs, answer


def loops(precision):
    """Two loops that join at one point: `chain` is of overlaps only, and there are none."""
    answer = of_text(precision, "M0 0C4 4 4-4 0 0C-4 4-4-4 0 0Z")
    assert len(answer) == 3 and not any("chain" in row for row in answer), answer


MISTAKES = [
    ('{"id":"p"}', "segments: missing, expected either segments or d"),
    ('{"id":"p","segments":[],"d":"M0 0"}', "d: together with segments, expected either"),
    ('{"id":7,"segments":[]}', "id: an integer, expected text"),
    ('{"segments":[]}', "id: missing, expected text"),
    ('{"id":"p","segments":3}', "segments: an integer, expected an array"),
    ('{"id":"p","segments":[[[0,0]]]}', "segments[0]: 1 point, expected 2 to 33"),
    ('{"id":"p","segments":[[[0,0],[1,1]],[[0,0],[1]]]}', "segments[1][1]: 1 entry, expected 2"),
    ('{"id":"p","segments":[[[0,0],[1,"a"]]]}', 'segments[0][1][1]: "a" is no number'),
    ('{"id":"p","segments":[[[0,0],[1,null]]]}', "segments[0][1][1]: null, expected a number"),
    ('{"id":"p","segments":[{"points":[[0,0],[1,1]],"weights":[1]}]}', "segments[0].weights: 1 entry, expected 2"),
    ('{"id":"p","segments":[{"points":[[0,0],[1,1]],"weights":[1,-1]}]}', "segments[0].weights[1]: a weight that"),
    ('{"id":"p","segments":[{"points":[[0,0],[1,1]],"domain":[0,2]}]}', "segments[0]: a domain, expected none"),
    ('{"id":"p","segments":[7]}', "segments[0]: an integer, expected"),
    ('{"id":"p","d":7}', "d: an integer, expected text"),
    ('{"id":"p","d":"L1 1"}', 'd: character 1: "L1", expected M or m first'),
    ('{"id":"p","d":"M1 1 X"}', 'd: character 6: "X", expected a command'),
    ('{"id":"p","d":"M1 1 L2"}', "d: character 8: the end, expected a number (y)"),
    ('{"id":"p","d":"M1 1C1 2 3 4 5"}', "expected a number (y)"),
    ('{"id":"p","d":"M1 1A1 1 0 2 0 5 5"}', "expected 0 or 1 (large-arc-flag)"),
    ('{"id":"p","d":"M1 1 3"}', "expected a number (y)"),
    ("[1]", "line: an array, expected an object"),
    ("{", "line: "),
    ("M1 1\nL 2 q", 'stdin:2: column 5: "q", expected a number (y)'),
    ('<svg>\n<path d="M0 0 L1"/></svg>', "stdin:2: column 17: the end, expected a number (y)"),
    ('<svg>\n<path d="M0 0 L1', "stdin:2: column 1: <path without an end"),
]


def mistakes(precision):
    for text, expected in MISTAKES:
        done = fatline(precision, "-", text="\n" + text + "\n" if text[0] in "{[" else text)
        where = "stdin:2: " if text[0] in "{[" else ""
        assert done.returncode == 65 and done.stderr.startswith(where) and expected in done.stderr and not done.stdout, (text, done.returncode, done.stderr)
    huge = fatline(precision, "-", text='{"id":"p","segments":[[[0,0],["1e9999999",0]]]}\n')
    assert huge.returncode == 65 and "segments[0][1][0]" in huge.stderr, huge.stderr


def usage(precision):
    for options in ([], ["--random", "0"], ["--random", "x"], ["a", "--random", "3"], ["a", "b", "c"], ["--self", "a"],
                    ["-", "-"], ["--random", "3", "--time", "--beside", "nobody"], ["--random", "3", "--rounds", "4"],
                    ["--random", "3", "--seed", "-1"], ["--random", "3", "--tolerance", "0"],
                    ["--random", "3", "--print", "--time"]):
        done = fatline(precision, *options)
        assert done.returncode == 64 and done.stderr, (options, done.returncode)
    assert fatline(precision, "/nowhere/at/all").returncode == 2
    assert fatline(precision, "--random", "3", "-o", "/nowhere/at/all").returncode == 2
    assert "Exit status" in fatline(precision, "--help").stdout


def times(precision):
    done = rows(fatline(precision, "--random", "20", "--time", "--rounds", "3"))
    assert "environment" in done[0] and len(done) == 2, done
    row = done[1]
    assert row["segments"] == 40 and row["samples"] == 3 and row["unsolved"] == 0, row
    assert 0 < row["ns_walk"] < row["ns_total"] and row["bytes_segment"] > 0 and row["found"] >= row["records"], row


def beside(precision):
    """Another algorithm in the same rounds, on pairs whose exact boxes meet."""
    row = rows(fatline(precision, "--random", "30", "--time", "--rounds", "3", "--beside", "bezier_clipping"))[1]
    assert row["beside_pairs"] > 0 and row["ratio_lo"] <= row["ratio"] <= row["ratio_hi"], row


if __name__ == "__main__":
    run_tests(at_each_precision(random_walks, forms, arcs, svg_file, loops, mistakes, usage, times, beside))
