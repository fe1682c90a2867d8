#!/usr/bin/python3
"""What every command does with nothing to work on, with options that need others, and with lines that are wrong: one rule
for all.  Prints TAP."""

import json
import os
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from runner import FATLINE, ROOT, expect, fatline, rows, run_tests

CASE = '{"id":"%s","class":"transversal","f":{"points":[[0,0],[1,1]]},"g":{"points":[[0,1],[1,0]]}}\n'
LINE = CASE % "one"
TAKES_CASES = ("solve", "check", "time", "truth", "trace", "order", "cost", "lemma")
OF_ONE = ["-a", "bezier_clipping"]
PARABOLA = '{"id":"p","points":[[0,0],[1,2],[2,0]],"free":1%s}\n'


def of_one(command):
    return [] if command == "truth" else OF_ONE


def test_no_case_on_standard_input():
    for command in TAKES_CASES:
        for text in ("", "\n \n"):
            ended = fatline(command, *of_one(command), text=text)
            expect(ended, 65, f"fatline {command}: no case in standard input\n")
            assert ended.stderr.count("\n") == 1, ended.stderr
    expect(fatline("region", text="\n"), 65, "fatline region: no case in standard input")
    expect(fatline("paths", "-", text=""), 65, "fatline paths: no path in standard input")
    expect(fatline("paths", "-", text="<svg></svg>"), 65, "no path in standard input")
    expect(fatline("check", "--dry-run", text=""), 65, "no case in standard input")
    expect(fatline("time", "--dry-run", text=""), 65, "no case in standard input")


def test_no_case_in_files():
    with tempfile.TemporaryDirectory() as folder:
        empty, full = Path(folder) / "empty.jsonl", Path(folder) / "full.jsonl"
        empty.write_text("")
        full.write_text(LINE)
        for command in TAKES_CASES:
            expect(fatline(command, *of_one(command), empty, empty), 65, f"no case in {empty}, {empty}\n")
        expect(fatline("region", empty), 65, f"no case in {empty}")
        expect(fatline("paths", empty), 65, f"no path in {empty}")
        expect(fatline("doctor", empty), 65, f"no case in {empty}")
        expect(fatline("repeat", *OF_ONE, empty), 65, f"no case in {empty}")
        expect(fatline("compare", "--builds", ROOT / "build", ROOT / "build", *OF_ONE, empty), 65, f"no case in {empty}")
        assert rows(expect(fatline("solve", empty, full), 0))  # one that is empty beside one that is not
        output = Path(folder) / "rows.jsonl"
        expect(fatline("check", *OF_ONE, "-o", output, full), 0)
        expect(fatline("check", *OF_ONE, "-o", output, full, "--resume"), 0)  # nothing left to do is no mistake


def test_nothing_selected():
    text = LINE + CASE % "two"
    for command in TAKES_CASES:
        for options, told in ((["--id", "x*"], "--id 'x*'"), (["--filter", "^x"], "--filter '^x'"),
                              (["--class", "tangent", "--id", "o*"], "--class 'tangent', --id 'o*'")):
            ended = fatline(command, *of_one(command), *options, text=text)
            expect(ended, 65, f"fatline {command}: no case in standard input with {told}\n")
        expect(fatline(command, *of_one(command), "--filter", "(", text=text), 64, "--filter")
    for options in (["--id", "t*"], ["--filter", "w"], ["--class", "transversal", "--id", "two"]):
        row, = rows(expect(fatline("solve", *options, text=text), 0))
        assert row["id"] == "two"
        line, = expect(fatline("truth", *options, text=text), 0).splitlines()
        assert json.loads(line)["id"] == "two"
        assert {row["id"] for row in rows(expect(fatline("trace", "--rows", *OF_ONE, *options, text=text), 0))} == {"two"}
        assert "1 cases" in expect(fatline("check", "--dry-run", *options, text=text), 0)
    expect(fatline("order", *OF_ONE, "--solution", 3, text=LINE), 65, "one: no solution 3, there are 1")


NEEDS = [
    ("paths --random 3 --print --tolerance 1e-3", "--print does not go with --tolerance"),
    ("paths --random 3 --print --max-steps 9", "--print does not go with --max-steps"),
    ("paths --seed 1 a", "--seed needs --random"), ("paths --random 3 --rounds 9", "--rounds needs --time"),
    ("region --seed 1", "--seed needs --random"), ("region --degree 3-9", "--degree needs --random"),
    ("region --rows", "--rows needs --check"), ("region --check --at 0,0", "--at does not go with --check"),
    ("region --time --at 0,0", "--at does not go with"), ("region --random 2 --all-points", "--random does not go with"),
    ("region --random 2 -m all", "--random does not go with --method"), ("region --random 2 a", "--random does not go with files"),
    ("region --random 2 --max-steps 3", "--random does not go with"), ("region --random 2 --at 0,0", "--random does not go with"),
    ("solve --timeout 3", "--timeout needs"), ("solve -x cat --max-steps 4", "--max-steps beside --external needs --algorithm"),
    ("solve -x cat --room 4", "--room beside --external needs --algorithm"), ("solve -x cat --decide", "--decide beside --external"),
    ("solve -f 0,0;1,1 -g 0,1;1,0 --id x", "-f and -g does not go with --class, --id and --filter"),
    ("solve -f 0,0;1,1 -g 0,1;1,0 --keep-going", "does not go with --keep-going"),
    ("check --timeout 3", "--timeout needs"), ("check -x cat --strict", "--strict beside --external needs --algorithm"),
    ("check --resume", "--resume needs --output"), ("check -o x --resume --dry-run", "--resume does not go with --dry-run"),
    ("time --single --family-by class", "--single does not go with --family-by"),
    ("time --human --rows", "--human does not go with --rows"), ("time --human -o x", "--human does not go with --output"),
    ("time --unchecked --points 1e-4", "--unchecked does not go with --points"),
    ("time -x cat --max-steps 4", "--max-steps beside --external"), ("time -x cat --count instructions", "--count beside --external"),
    ("time -o x --resume --dry-run", "--resume does not go with --dry-run"),
    ("time --baseline certified_batch", "certified_batch takes part with --batch only"),
    ("time --baseline certified_batch_avx2", "certified_batch_avx2 takes part with --batch=VARIANT only"),
    ("time --baseline no_such", "no algorithm no_such"), ("time --baseline bezier_clipping,subdivision", "no algorithm"),
    ("truth --within 1e-3", "--within needs --compare"), ("truth --compare --timing", "--compare does not go with --timing"),
    ("order --protocol boxes --bits 40", "--bits needs"), ("cost --from 9 --to 8", "--from 9 is beyond --to 8"),
    ("generate random --fonts x", "--fonts needs the family glyphs"), ("generate random --letters x", "--letters needs"),
    ("generate glyphs --degree 3", "glyphs does not go with --degree"), ("generate glyphs -w", "glyphs does not go with --weights"),
    ("generate glyphs --gap 9", "glyphs does not go with --gap"), ("generate random --gap 9", "--gap belongs to near_tangent"),
    ("generate random --list", "--list goes alone"),
    ("compare -a certified a b", "--algorithm needs --builds"), ("compare --tolerance 1 a b", "--tolerance needs --builds"),
    ("compare --rounds 5 a b", "--rounds needs --builds"), ("compare --generations 5 a b", "--generations needs --builds"),
    ("compare --reference x --builds a b c", "--reference does not go with --builds"),
    ("compare --instructions --builds a b c", "--instructions does not go with --builds"),
    ("compare --instructions --reference x a b", "--reference does not go with --instructions"),
    ("compare --noise-floor x a b", "--noise-floor"), ("compare --builds a b -", "not standard input"),
]


def test_options_that_would_say_nothing():
    for words, told in NEEDS:
        ended = fatline(*words.split(), text=LINE)
        expect(ended, 64, told)
        assert not ended.stdout, words


def test_a_limit_on_another_library_is_one():
    peers = [json.loads(line) for line in fatline("list", "--json", "peers").stdout.splitlines()]
    if not peers:
        return "no other library is known here"
    expect(fatline("solve", "--timeout", 5, "-a", peers[0]["algorithm"], text=LINE), 0)
    return None


def test_interruption_has_its_status():
    """Also while waiting for the next line; what was answered before is written."""
    for command in ("solve", "truth", "trace"):
        process = subprocess.Popen([FATLINE, command, *of_one(command)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        process.stdin.write(LINE)
        process.stdin.flush()
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        shown, _ = process.communicate(input=LINE, timeout=60)
        assert process.returncode == 130 and shown, (command, process.returncode, shown)


def children(pid):
    """Of a process, as /proc has them."""
    try:
        return [int(word) for task in Path(f"/proc/{pid}/task").iterdir() for word in (task / "children").read_text().split()]
    except FileNotFoundError:
        return []


def begin_check(jobs, cases):
    """A check with an external program that never answers, and its workers when there are as many as there will be."""
    process = subprocess.Popen([FATLINE, "check", "-j", str(jobs), "-x", "sleep 1000", "--timeout", "1000"], stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    process.stdin.write("".join(CASE % f"c{i}" for i in range(cases)))
    process.stdin.close()
    process.stdin = None
    expected = min(jobs, cases, 4 * os.cpu_count())
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline and len(children(process.pid)) < expected:
        time.sleep(0.02)
    time.sleep(0.2)
    return process, children(process.pid), expected


def is_alive(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def test_precision_goes_before_the_command():
    for words, name in ((["--precision", "multi"], "multi"), (["--precision=quad"], "quad")):
        expect(fatline("solve", *words, "-f", "0,0 1,1", "-g", "0,1 1,0"), 64, f"fatline --precision {name} solve ...")


def test_nothing_to_generate():
    expect(fatline("generate", "nice", "-c", 0), 64, "--count: \"0\", expected 1 or more")


def test_workers_of_check():
    """No more than cases, nor than four for each processor; all end with the run, however it ends."""
    if not Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children").exists():
        return "no lists of children in /proc"
    for number, status, jobs, cases in ((signal.SIGTERM, 130, 100000, 1), (signal.SIGINT, 130, 100000, 100), (signal.SIGKILL, -9, 2, 5)):
        process, workers, expected = begin_check(jobs, cases)
        assert len(workers) == expected, (len(workers), expected)
        programs = [pid for worker in workers for pid in children(worker)]
        process.send_signal(number)
        _, said = process.communicate(timeout=60)
        assert process.returncode == status, (process.returncode, said)
        assert (f"--jobs: {4 * os.cpu_count()} instead of {jobs}" in said) == (cases > 4 * os.cpu_count()), said
        deadline = time.monotonic() + 10
        while time.monotonic() < deadline and any(map(is_alive, workers + programs)):
            time.sleep(0.02)
        assert not any(map(is_alive, workers + programs)), (number, workers, programs)
    return None


def test_bad_data_to_compare():
    """Said once; the status is that of bad data."""
    with tempfile.TemporaryDirectory() as folder:
        bad, rows_bad = Path(folder) / "bad.jsonl", Path(folder) / "rows.jsonl"
        bad.write_text(LINE + '{"id":"b"}\n')
        ended = fatline("compare", "--builds", ROOT / "build", ROOT / "build", bad)
        expect(ended, 65, f"{bad}:2: f: missing")
        assert ended.stderr.count("\n") == 1 and not ended.stdout, ended
        for text, told in (("{", "rows.jsonl:1: line: not JSON"), (LINE, "rows.jsonl:1: row: no family and algorithm"),
                           ("7\n", "rows.jsonl:1: row: no family"), ('{"environment":{}}\n[]\n', "rows.jsonl:2: row:")):
            rows_bad.write_text(text)
            ended = fatline("compare", rows_bad, rows_bad)
            expect(ended, 65, told)
            assert ended.stderr.count("\n") == 1 and not ended.stdout, ended
        expect(fatline("compare", rows_bad, Path(folder) / "none"), 65)
        rows_bad.write_text("")
        expect(fatline("compare", rows_bad, Path(folder) / "none"), 2, "none: No such file")
        expect(fatline("compare", rows_bad, rows_bad), 1, "0 compared")


def test_batch_is_a_baseline():
    made = fatline("generate", "random", "--count", 20, "--seed", 3).stdout
    text = fatline("truth", text=made).stdout
    quick = ["--rows", "--rounds", 5, "--seconds", 0.05, "-a", "certified,bezier_clipping"]
    for variant, name in (("--batch", "certified_batch"), ("--batch=portable", "certified_batch_portable")):
        found = {row["algorithm"]: row for row in rows(expect(fatline("time", *quick, variant, "-b", name, text=text), 0))}
        assert found[name]["ratio"] == 1 and found["certified"]["baseline"] == name, found
        assert found["bezier_clipping"]["ratio"] > found["certified"]["ratio"] > 0, found
    expect(fatline("time", *quick, "-x", f"{FATLINE} solve", "-b", "another", text=text), 64, "is called another")
    found = rows(expect(fatline("time", *quick, "-x", f"{FATLINE} solve", "-b", "fatline", text=text), 0))
    assert {row["algorithm"] for row in found if "ratio" in row} == {"fatline"}


def test_lemma_prints_no_nan():
    made = fatline("generate", "nice", "--degree", "3x2", "--count", 1, "--seed", 1).stdout
    shown = expect(fatline("lemma", "-q", "-a", "bezier_clipping,hybrid_clipping_2_arc", text=made), 0)
    assert "nan" not in shown and "inf" not in shown and " - " in shown, shown
    text = expect(fatline("lemma", "-q", "--rows", "-a", "bezier_clipping,hybrid_clipping_2_arc", text=made), 0)
    assert "NaN" not in text and '"scalar_constant": null' in text.replace('":null', '": null'), text
    for command in ("order", "cost"):
        shown = expect(fatline(command, "-q", "-a", "bezier_clipping", text=made), 0)
        assert "nan" not in shown and "inf" not in shown, shown


def test_unknown_fields():
    path = '{"id":"p","segments":[[[0,0],[1,1]]]%s}\n'
    expect(fatline("paths", "-", text=path % ',"note":"x"'), 0)
    expect(fatline("paths", "-", text=path % "" + path % ',"closed":true'), 65, "stdin:2: closed: unknown, expected id, ")
    inner = '{"id":"p","segments":[{"points":[[0,0],[1,1]]%s}]}\n'
    expect(fatline("paths", "-", text=inner % ',"degree":1'), 0)
    expect(fatline("paths", "-", text=inner % ',"wieghts":[1,2]'), 65, "stdin:1: segments[0].wieghts: unknown, expected ")
    for field in ("kind", "strict_nonempty", "vertices"):
        value = {"kind": '"unbounded"', "strict_nonempty": "true", "vertices": "[]"}[field]
        expect(fatline("region", text=PARABOLA % f',"expected":{{"{field}":{value}}}'), 0)
    for wrong, told in (('{"knid":"empty"}', "stdin:1: expected.knid: unknown, expected "),
                        ("7", "stdin:1: expected: an integer, expected an object")):
        for options in ([], ["--check"]):
            expect(fatline("region", *options, text=PARABOLA % f',"expected":{wrong}'), 65, told)


if __name__ == "__main__":
    run_tests(globals())
