#!/usr/bin/python3
"""`fatline time` and the files that `time` and `check` write: the yardstick, who takes part, interruption and what comes
after it, filters, estimates, instruction counts.  Prints TAP."""

import json
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from runner import FATLINE, fatline, run_tests
from runner import rows as rows_of

QUICK = ["--rounds", 5, "--seconds", 0.05]
TIMING = ("ns_", "ratio", "floor_ratio", "samples", "passes", "outliers", "run", "worst_id")


def proved(folder, family="random", count=30, degree=3, seed=3):
    made = fatline("generate", family, "--degree", degree, "--count", count, "--seed", seed).stdout
    path = Path(folder) / f"{family}.jsonl"
    path.write_text(fatline("truth", text=made).stdout)
    return path


def without_timing(row):
    return {key: value for key, value in row.items() if not key.startswith(TIMING)}


def key(row):
    return row.get("family", row.get("id")), row["algorithm"], row["precision"], row.get("protocol", "")


def test_floor_is_in_every_timing():
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder)
        found = {row["algorithm"]: row for row in rows_of(fatline("time", "--rows", *QUICK, path).stdout)}
        assert found["floor"]["floor_ratio"] == 1 and found["floor"]["pairs"] > 0
        assert "right" not in found["floor"]  # nobody judges it
        for name, row in found.items():
            if name != "floor" and row["pairs"]:
                assert row["floor_ratio"] > 1 and row["floor_ratio_lo"] <= row["floor_ratio"] <= row["floor_ratio_hi"], row
        assert "from floor" in fatline("time", "--human", *QUICK, path).stdout
        alone = rows_of(fatline("time", "--rows", "--no-floor", *QUICK, "-a", "bezier_clipping", path).stdout)
        assert len(alone) == 1 and "floor_ratio" not in alone[0]


def test_floor_is_there_once():
    """Also as the baseline."""
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder)
        command = ["time", *QUICK, "-a", "bezier_clipping", "--baseline", "floor"]
        rows = {name: [row for row in rows_of(fatline(*command, "--rows", path).stdout) if row["algorithm"] == name]
                for name in ("floor", "bezier_clipping")}
        assert [len(found) for found in rows.values()] == [1, 1], rows
        assert rows["floor"][0]["ratio"] == 1 and rows["bezier_clipping"][0]["ratio"] > 1, rows
        table = fatline(*command, "--human", path).stdout
        assert sum(line.startswith("floor ") for line in table.splitlines()) == 1, table
        for named in ("floor", "floor,bezier_clipping"):
            names = [row["algorithm"] for row in rows_of(fatline("time", *QUICK, "--rows", "-a", named, "-b", "floor", path).stdout)]
            assert sorted(names) == sorted(named.split(",")), names


def test_floor_reaches_full_precision():
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder, "nine", 4)
        for precision, error in (("double", 1e-13), ("quad", 1e-17), ("multi", 1e-17)):
            found = rows_of(fatline("check", "--rows", "--points", "1e-4", "-a", "floor", path, precision=precision).stdout)
            # the truth is compared in doubles
            assert found and all(row["verdict"] == "RIGHT" and row["max_error"] <= max(error, 3e-16) for row in found), found
        solved = fatline("solve", "-a", "floor", path, precision="quad")
        assert solved.returncode == 0 and "SOLVED" in solved.stdout


def test_environment_and_samples():
    with tempfile.TemporaryDirectory() as folder:
        text = fatline("time", "--rows", *QUICK, "--seed", 7, "--pin", "auto", proved(folder, count=5)).stdout
        environment = json.loads(text.splitlines()[0])["environment"]
        for field in ("cpu", "kernel", "compiler", "flags", "libraries", "commit", "dirty", "governor", "load", "seed",
                      "arguments", "noise_floor"):
            assert field in environment, field
        assert environment["seed"] == 7 and environment["libraries"]["files"]
        for row in rows_of(text):
            if row["pairs"]:
                assert len(row["samples"]) == 5 and row["ns_min"] == min(row["samples"]) and row["worst_id"]


def test_filter_single_and_dry_run():
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder, count=12)
        found = rows_of(fatline("time", "--rows", "--single", "--filter", "-[123]$", *QUICK, "-a", "bezier_clipping",
                                path).stdout)
        assert {row["protocol"] for row in found} == {"single"}
        assert sorted({row["family"] for row in found}) == [f"random-3x3-3-{i}" for i in (1, 2, 3)], found
        dry = fatline("time", "--dry-run", "-a", "all", path)
        assert dry.returncode == 0 and "1 families" in dry.stdout and " s" in dry.stdout and "{" not in dry.stdout
        checked = rows_of(fatline("check", "--rows", "--filter", "-[123]$", "-a", "bezier_clipping", path).stdout)
        assert len(checked) == 3
        assert "12 cases, 1 algorithms" in fatline("check", "--dry-run", "-a", "bezier_clipping", path).stdout


def test_wrong_usage():
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder, count=2)
        for wrong in (["--resume"], ["--count", "cycles"], ["--points", "0"], ["--pin", "x"]):
            assert fatline("time", *wrong, path).returncode == 64, wrong
        assert fatline("time", "--filter", "(", path).returncode == 64
        assert fatline("check", "--filter", "(", path).returncode == 64
        assert fatline("check", "--resume", path).returncode == 64


def interrupted(command, output, least):
    """Starts the command, and kills it when `output` has some rows.  Returns how many whole rows there were."""
    process = subprocess.Popen([FATLINE, *map(str, command)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline and process.poll() is None:
        if output.exists() and output.read_text().count("\n") > least:
            break
        time.sleep(0.005)
    process.send_signal(signal.SIGKILL)
    process.wait()
    return output.read_text().count("\n") - 1


def check_resumed(command, folder, least):
    """The rows of a run that was killed and resumed against those of one that was not."""
    whole, parts = Path(folder) / "rows.jsonl", Path(folder) / "kept.jsonl"
    command = [*command, "-o", whole]
    assert fatline(*command).returncode in (0, 1)
    expected = rows_of(whole.read_text())
    whole.unlink()
    kept = interrupted(command, whole, least)
    assert 0 < kept < len(expected), f"killed too late for the test: {kept} of {len(expected)} rows"
    with open(whole, "a") as torn:
        torn.write('{"family":"torn","algor')
    resumed = fatline(*command, "--resume")
    assert resumed.returncode in (0, 1), resumed.stderr
    found = rows_of(whole.read_text())
    assert sorted(map(key, found)) == sorted(map(key, expected))
    assert len(set(map(key, found))) == len(found), "a key twice"
    assert len({row["run"] for row in found}) == 1
    by_key = {key(row): row for row in found}
    for row in expected:
        assert without_timing(by_key[key(row)]) == without_timing(row), (by_key[key(row)], row)
    shutil.copy(whole, parts)
    again = fatline(*command, "--resume")
    assert again.returncode in (0, 1) and whole.read_text() == parts.read_text(), "a complete file changed"
    other = fatline(*command, "--tolerance", "1e-7", "--resume")
    assert other.returncode == 64 and whole.read_text() == parts.read_text(), other.stderr
    assert "begun without --tolerance" in other.stderr, other.stderr


def test_only_runs_are_resumed():
    """A file that is not one of ours is left as it is, however it begins; an empty one, and one that ends in its first line,
    are begun."""
    with tempfile.TemporaryDirectory() as folder:
        path, output = proved(folder, count=2), Path(folder) / "rows.jsonl"
        for command in (["check", "-a", "bezier_clipping"], ["time", "--rows", *QUICK, "-a", "bezier_clipping"]):
            for text in ("my notes\n", "my notes", '{"id":1}\n', '{"id":1}', "[1]\n", "\n\nnotes\n"):
                output.write_text(text)
                ended = fatline(*command, "--resume", "-o", output, path)
                assert ended.returncode == 65 and f"{output}:1: environment: missing" in ended.stderr, (text, ended.stderr)
                assert output.read_text() == text, text
            for text in ("", '{"environment":{"sch'):
                output.write_text(text)
                assert fatline(*command, "--resume", "-o", output, path).returncode == 0, text
                whole = output.read_text()
                assert rows_of(whole)
            begun = whole.splitlines(keepends=True)
            output.write_text(begun[0] + "notes in between\n" + "".join(begun[1:]))
            before = output.read_text()
            ended = fatline(*command, "--resume", "-o", output, path)
            assert ended.returncode == 65 and f"{output}:2: not JSON" in ended.stderr and output.read_text() == before, ended


def test_options_that_change_no_result():
    with tempfile.TemporaryDirectory() as folder:
        path, output = proved(folder, count=4), Path(folder) / "rows.jsonl"
        begin = ["check", "-j", 2, "-o", output, "-a", "bezier_clipping", path]
        assert fatline(*begin).returncode == 0
        whole = output.read_text()
        for same in (["-q", "-a", "bezier_clipping"], ["--jobs=3", "--quiet", "-a", "bezier_clipping"], ["-qj3", "-a", "bezier_clipping"],
                     ["--job", 1, "-qa", "bezier_clipping"]):
            ended = fatline("check", "--resume", *same, "--output", output, path)
            assert ended.returncode == 0 and output.read_text() == whole, (same, ended.stderr)
        for other, told in ((["-a", "bezier_clipping", "--strict"], "begun without --strict"),
                            (["-a", "hybrid_clipping_2"], "begun with -a bezier_clipping where -a hybrid_clipping_2 stands now"),
                            ([], "begun with -a, which is missing now")):
            ended = fatline("check", "--resume", *other, "-o", output, path)
            assert ended.returncode == 64 and told in ended.stderr, ended.stderr
            assert output.read_text() == whole
        ended = fatline("time", "--resume", "--rows", "-a", "bezier_clipping", "-o", output, path)
        assert ended.returncode == 64 and "begun by fatline check" in ended.stderr, ended.stderr


def test_time_resumes_after_a_kill():
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder, count=40)
        check_resumed(["time", "--rows", "--single", "--rounds", 5, "--seconds", 0, "-a",
                       "bezier_clipping,hybrid_clipping_2,implicitization", path], folder, 20)


def test_check_resumes_after_a_kill():
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder, count=600)
        check_resumed(["check", "--rows", "-j", 2, "-a", "bezier_clipping,hybrid_clipping_2,resultant_eigen", path], folder,
                      60)


def test_forgiving():
    """Who misses a root is timed on the other pairs if it is forgiven."""
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder, count=60)
        command = ["time", "--rows", *QUICK, "-a", "control_normal_not_unit,bezier_clipping", path]
        strict = {row["algorithm"]: row for row in rows_of(fatline(*command).stdout)}["control_normal_not_unit"]
        assert strict["pairs"] == 0 and strict["missing"] > 0, strict
        forgiven = {row["algorithm"]: row for row in rows_of(fatline(*command, "--forgive").stdout)}["control_normal_not_unit"]
        assert forgiven["pairs"] > 0 and forgiven["missing"] == strict["missing"], forgiven


def test_batch():
    """As right as single calls, in rows of its own; what it does not take is said."""
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder, count=40)
        for option in ("--batch", "--batch=portable"):
            found = {row["algorithm"]: row for row in rows_of(fatline("time", "--rows", *QUICK, "-a", "certified", option,
                                                                      "-b", "certified", path).stdout)}
            row = found["certified_batch" + option[7:].replace("=", "_")]
            assert row["protocol"] == "batch" and row["right"] == 40 and row["pairs"] > 0 and row["steps"] == 0, row
            assert row["ratio"] > 0 and row["ns_max"] > 0 and found["certified"]["pairs"] == row["pairs"]
            assert "in a batch of its own" in fatline("time", "--human", *QUICK, option, path).stdout
        high = proved(folder, "nice", 4, degree=5)
        rows = rows_of(fatline("time", "--rows", *QUICK, "--batch", high).stdout)
        assert rows[0]["not_taken"] == 4 and rows[0]["pairs"] == 0, rows
    assert fatline("time", "--batch=sse", path).returncode == 64
    quad = fatline("time", "--batch=avx2", path, precision="quad")
    assert quad.returncode == 64 and "has no avx2" in quad.stderr


def test_instructions_are_counted():
    if not shutil.which("valgrind"):
        return "valgrind is not installed"
    with tempfile.TemporaryDirectory() as folder:
        path = proved(folder, count=4)
        count = [rows_of(fatline("time", "--rows", "--count", "instructions", *QUICK, "-a", "bezier_clipping", path).stdout)
                 for _ in range(2)]
        first, second = ([row for row in rows if row["algorithm"] == "bezier_clipping"][0] for rows in count)
        assert 500 < first["instructions"] < 50000
        assert abs(second["instructions"] / first["instructions"] - 1) < 1e-3, (first, second)
    return None


if __name__ == "__main__":
    run_tests(globals())
