#!/usr/bin/python3
"""The command `fatline`, its `list` and `solve`: what they print, where they complain, how they end.  Prints TAP."""

import os
import signal
import subprocess
import tempfile
from pathlib import Path

from runner import FATLINE, PRECISIONS, expect, fatline, number, rows, run_tests

LINE = ["-f", "0,0 1,1", "-g", "0,1 1,0"]
CASE = '{"id":"%s","f":{"points":[[0,0],[1,1]]},"g":{"points":[[0,1],[1,0]]}}'


def test_help_and_version():
    assert expect(fatline("--version"), 0) == "fatline 0.1\n"
    shown = expect(fatline("--help"), 0)
    assert all(command in shown for command in ("list", "generate", "truth", "solve", "check", "time"))
    for command in ("list", "solve"):
        assert f"Usage: fatline {command}" in expect(fatline(command, "--help"), 0)
        assert expect(fatline(command, "--version"), 0) == "fatline 0.1\n"


FULL = "/dev/full"
SHORT = [["--help"], ["--version"], ["list"], ["list", "--json"], ["list", "--help"], ["solve", *LINE], ["solve", "--human", *LINE],
         ["roots", "-d", 2], ["generate", "nice", "-c", 2], ["generate", "--list"], ["region", "--random", 2]]
OF_CASES = [["solve"], ["truth"], ["check", "--truth", "-q"], ["check", "--truth", "--rows", "-q"], ["trace", "-a", "subdivision"],
            ["repeat", "-a", "certified", "-"], ["time", "--rows", "--rounds", 5, "--seconds", 0.1, "-a", "certified", "--unchecked"],
            ["time", "--human", "--rounds", 5, "--seconds", 0.1, "-a", "certified", "--unchecked"]]


def test_a_full_disk_is_said():
    """Once, with the command and the reason, whatever the command."""
    for command in SHORT + OF_CASES:
        with open(FULL, "w") as full:
            ended = subprocess.run([FATLINE, *map(str, command)], input=CASE % "one" + "\n", stdout=full, stderr=subprocess.PIPE,
                                   text=True, timeout=120)
        name = "fatline" if command[0].startswith("--") else f"fatline {command[0]}"
        said = f"{name}: standard output: No space left on device\n"
        assert ended.returncode == 2 and ended.stderr.count("standard output") == 1 and said in ended.stderr, (command, ended)
    for command in OF_CASES[:1] + OF_CASES[3:4] + OF_CASES[6:7]:
        expect(fatline(*command, "-o", FULL, text=CASE % "one"), 2, FULL)


def test_a_broken_pipe_is_not_said():
    for command in SHORT + OF_CASES:
        for ignored in (False, True):
            read, write = os.pipe()
            os.close(read)
            ended = subprocess.run([FATLINE, *map(str, command)], input=CASE % "one" + "\n", stdout=write, stderr=subprocess.PIPE,
                                   text=True, timeout=120, restore_signals=not ignored)
            os.close(write)
            assert ended.returncode == -signal.SIGPIPE and "output" not in ended.stderr, (command, ignored, ended)


def test_wrong_usage():
    expect(fatline(), 64, "no command")
    expect(fatline("slove"), 64, "did you mean solve?")
    expect(fatline("--precision", "octo", "list"), 64, "double, quad or multi")
    expect(fatline("list", "no_such"), 64, "there are subdivision")
    for wrong in (["--tolerance", "0"], ["--tolerance", "x"], ["--max-steps", "0"], ["--room", "1x"],
                  ["--timeout", "-1"], ["-f", "0,0 1,1"], ["-a", "no_such"], [*LINE, "file"],
                  ["-f", "0,0 1", "-g", "0,1 1,0"], ["-f", "0,0 1,2,3,4", "-g", "0,1 1,0"], ["--no-such-option"]):
        expect(fatline("solve", *wrong), 64)


def test_a_program_not_built():
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "fatline"
        copy.write_bytes(Path(FATLINE).read_bytes())
        copy.chmod(0o755)
        ended = subprocess.run([copy, "--precision", "quad", "solve"], capture_output=True, text=True)
        expect(ended, 2, "make build/quad/fatline-solve")
        ended = subprocess.run([copy, "--precision", "quad", "truth"], capture_output=True, text=True)
        expect(ended, 2, "make build/double/fatline-truth")


def test_list():
    for precision in PRECISIONS:
        listed = rows(expect(fatline("list", "--json", precision=precision), 0))
        names = [row["algorithm"] for row in listed]
        assert len(set(names)) == len(names) > 0 and sum(row["default"] for row in listed) == 1
        assert all(row["precision"] == precision and row["summary"] and row["reference"] for row in listed)
        table = expect(fatline("list", precision=precision), 0)
        assert all(name in table for name in names)
        some = rows(expect(fatline("list", "--json", "subdivision*", "all", precision=precision), 0))
        assert sorted(row["algorithm"] for row in some) == sorted(names)


def test_two_curves_in_one_line():
    for precision in PRECISIONS:
        row, = rows(expect(fatline("solve", *LINE, "--tolerance", "1e-10", precision=precision), 0))
        assert (row["outcome"], row["precision"], row["id"]) == ("SOLVED", precision, "own")
        assert len(row["crossings"]) == 1
        assert row["crossings"][0]["point"] == [0.5, 0.5]
        for parameter in "ts":
            lo, hi = map(number, row["crossings"][0][parameter])
            assert lo <= 0.5 <= hi and hi - lo <= 1e-10
        shown = expect(fatline("solve", "--human", *LINE, precision=precision), 0)
        assert "SOLVED" in shown and "(0.5, 0.5)" in shown
    away = ["-f", "0,0 1,1", "-g", "5,5 6,7"]
    assert "no intersection" in expect(fatline("solve", "--human", *away), 0)
    # the weights 1, 1, 2 make a quarter of the unit circle; it meets x = y at (sqrt 1/2, sqrt 1/2), s = sqrt 1/2
    row, = rows(expect(fatline("solve", "-f", "1,0,1 1,1,1 0,1,2", "-g", "0,0;1,1"), 0))
    lo, hi = row["crossings"][0]["s"]
    assert lo <= 0.7071067811865476 <= hi + 1e-16 and hi - lo <= 1e-12, row
    assert all(abs(x - 0.7071067811865476) < 1e-12 for x in row["crossings"][0]["point"]), row
    domain = CASE.replace("[1,1]]", '[3,3]],"domain":[-2,4]', 1) % "d"  # f(t) = ((t + 2) / 2, (t + 2) / 2)
    row, = rows(expect(fatline("solve", text=domain), 0))
    assert all(abs(x - 0.5) < 1e-12 for x in row["crossings"][0]["point"]), row


def test_misspelt_fields():
    """In a curve an error; beside the curves a note, once, if it looks like one of ours; others are the user's own."""
    good = CASE % "a"
    expect(fatline("solve", text=good.replace("points", "piont", 1)), 65, "stdin:1: f.piont: unknown, expected points")
    for word, meant in (("expectd", "expected"), ("claas", "class"), ("expetced", "expected"), ("nearr", "near")):
        line = good[:-1] + f',"{word}":3}}\n'
        told = fatline("solve", "--quiet", text=line + line)
        assert len(rows(expect(told, 0))) == 2
        assert told.stderr == f"stdin:1: {word}: a field that is not read; is {meant} meant?\n", told.stderr
    own = good[:-1] + ',"flags":[],"author":1,"expected_by":2}'
    assert fatline("solve", "--quiet", text=own).stderr == ""
    mark = "\ufeff"
    assert rows(fatline("solve", text=mark + good)) == rows(fatline("solve", text=good)) != []


def test_roots():
    measured = rows(expect(fatline("roots", "--rows", "--degree", "4,8", "--accuracy", "7,14,20"), 0))
    assert len(measured) == 4 * 2 * 3 * (1 + 3)  # kinds, degrees, finders; an order and three accuracies
    for finder in ("hull", "quadratic", "cubic"):
        clips = [row["clips"] for row in measured if row["finder"] == finder and row["row"] == "cost"
                 and (row["roots"], row["degree"]) == ("double", 8)]
        assert len(clips) == 3 and clips == sorted(clips) and clips[-1] > 1
    linear, = (row for row in measured if row["row"] == "order" and row["finder"] == "hull"
               and (row["roots"], row["degree"]) == ("double", 8))
    assert linear["law"] == "linear" and abs(linear["per_clip"] - 1) < 0.05
    assert all(row["law"] == "too_few" and row["per_clip"] is None for row in measured
               if row["row"] == "order" and row["points"] < 2)
    assert "quadratic" in expect(fatline("roots", "--degree", "2", "--finder", "quadratic"), 0)
    for wrong in (["--finder", "newton"], ["--degree", "0"], ["--degree", "33"], ["--accuracy", "7,,8"], ["file"]):
        expect(fatline("roots", *wrong), 64)


def test_bad_lines():
    lines = [CASE % "a", "", "{}", CASE % "b", '{"id":"c","f":{"points":[[0,0]]}}', CASE % "d"]
    text = "\n".join(lines)
    stopped = fatline("solve", text=text)
    assert [row["id"] for row in rows(expect(stopped, 65, "stdin:3: id: missing"))] == ["a"]
    gone_on = fatline("solve", "--keep-going", "-", text=text)
    assert [row["id"] for row in rows(expect(gone_on, 65, "stdin:3: id: missing"))] == ["a", "b", "d"]
    assert "stdin:5: f.points: 1 point" in gone_on.stderr
    expect(fatline("solve", "-f", "0,0 x,1", "-g", "0,1 1,0"), 65, "command line:1: f.points[1][0]: \"x\"")
    expect(fatline("solve", "/no/such/file"), 2, "/no/such/file: No such file")
    expect(fatline("solve", *LINE, "--output", "/dev/full"), 2, "cannot be written")


def test_cases_times_algorithms():
    text = "\n".join(CASE % name for name in ("one", "two", "three"))
    answers = rows(expect(fatline("solve", "-a", "subdivision*", "--id", "t*", text=text), 0))
    names = [row["algorithm"] for row in rows(expect(fatline("list", "--json", "subdivision*"), 0))]
    assert [(row["id"], row["algorithm"]) for row in answers] == [(i, a) for i in ("two", "three") for a in names]
    with tempfile.TemporaryDirectory() as folder:
        files = [Path(folder) / name for name in ("a.jsonl", "b.jsonl")]
        for file in files:
            file.write_text(CASE % file.stem + "\n")
        out = Path(folder) / "out"
        assert expect(fatline("solve", "--output", str(out), *map(str, files)), 0) == ""
        assert [row["id"] for row in rows(out.read_text())] == ["a", "b"]


def test_limits_end_a_call():
    shown = expect(fatline("solve", "-a", "subdivision", "--max-steps", "3", *LINE), 0)
    row, = rows(shown)
    assert row["outcome"] == "OUT_OF_STEPS" and row["steps"] <= 3
    assert any(c["t"][0] <= 0.5 <= c["t"][1] and c["s"][0] <= 0.5 <= c["s"][1] for c in row["crossings"])


def test_external_programs():
    """Another fatline as the external program gives the very records of the algorithm it runs."""
    text = "\n".join(CASE % name for name in ("one", "two", "three"))
    for precision in PRECISIONS:
        other = f"{FATLINE} --precision {precision} solve -a subdivision --tolerance $FATLINE_TOLERANCE"
        here = rows(expect(fatline("solve", "-a", "subdivision", "--tolerance", "1e-7", text=text, precision=precision),
                           0))
        there = rows(expect(fatline("solve", "-x", other, "--tolerance", "1e-7", text=text, precision=precision), 0))
        for row in here:
            row["algorithm"] = "fatline"
        assert here == there
    failing = rows(expect(fatline("solve", "--external", "false", text=text), 0, "one: false: ended with status 1"))
    assert [(row["id"], row["outcome"]) for row in failing] == [(i, "CRASHED") for i in ("one", "two", "three")]
    assert all("status 1" in row["message"] for row in failing)


def test_table_of_check():
    """A part for each class, and their sum if there are several; with --strict the words broken, which count."""
    one = CASE % "one"
    two = (CASE % "two").replace("[1,0]", "[1,2]")  # parallel: of another class
    for text, heads in ((one, ["transversal"]), (one + "\n" + two, ["transversal", "none", "all classes"])):
        shown = expect(fatline("check", "-q", "--truth", "-a", "certified", text=text), 0)
        assert [line[:line.index(" cases ")].strip() for line in shown.splitlines() if " cases " in line] == heads, shown
        assert "violated" not in shown
    strict = ["check", "-q", "--truth", "--strict", "-a"]
    shown = expect(fatline(*strict, "certified", text=one + "\n" + two), 0)
    assert [line.split()[-1] for line in shown.splitlines() if line] == 3 * ["violated", "0"], shown


def test_missing_programs_are_no_answers():
    for command in ("solve", "check", "time"):
        shown = expect(fatline(command, "--external", "./no-such-program", text=CASE % "one"), 2, "no-such-program")
        assert "INVALID" not in shown and "not timed" not in shown


def test_external_programs_are_judged():
    """With no other algorithm beside them.  Not taken is what the program says it does not take; that it crashes, hangs or
    writes something else is a wrong result."""
    text = "\n".join(CASE % name for name in ("one", "two"))
    says = '''sed -u 's/.*"id":"\\([a-z]*\\)".*/{"id":"\\1","outcome":"%s"}/' '''
    for command, status, outcome, verdict in (
            (f"{FATLINE} solve --tolerance $FATLINE_TOLERANCE", 0, "SOLVED", "RIGHT"), (says % "UNSUPPORTED", 0, "UNSUPPORTED", "NOT_TAKEN"),
            (says % "INVALID", 0, "INVALID", "NOT_TAKEN"), (says % "GAVE_UP", 1, "GAVE_UP", "BROKEN"), ("false", 1, "CRASHED", "BROKEN"),
            ("kill -9 $$", 1, "CRASHED", "BROKEN"), ("true", 1, "CRASHED", "BROKEN"), ("sleep 20", 1, "TIMED_OUT", "BROKEN"),
            ("yes", 1, "GAVE_UP", "BROKEN"), (says % "FINE", 1, "GAVE_UP", "BROKEN"), ("echo {}; sleep 20", 1, "GAVE_UP", "BROKEN")):
        limit = 0.3 if outcome == "TIMED_OUT" else 20
        judged = rows(expect(fatline("check", "--rows", "--truth", "--timeout", limit, "--external", command, text=text), status))
        assert [(row["outcome"], row["verdict"]) for row in judged] == 2 * [(outcome, verdict)], (command, judged)


if __name__ == "__main__":
    run_tests(globals())
