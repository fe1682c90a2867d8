#!/usr/bin/python3
"""`fatline compare`, `fatline doctor` and scripts/comparisons.py: a slowdown is found, none is called where there is none,
and what the scripts compute is right on numbers that are known.  Prints TAP."""

import json
import sys
import tempfile
from pathlib import Path

from runner import ROOT, expect, fatline, rows, run_tests

REGRESSION = 3
ENVIRONMENT = {"environment": {"noise_floor": 0.01}}
sys.path.insert(0, str(ROOT / "scripts"))


def cases(folder):
    made = fatline("generate", "random", "--degree", 3, "--count", 100, "--seed", 1).stdout
    path = Path(folder) / "cases.jsonl"
    path.write_text(fatline("truth", text=made).stdout)
    return path


def timed(folder, name, factors, samples=31, floor=0.01):
    """A file of rows: algorithms with so many times the floor's time, a little scattered."""
    lines = [{"environment": {"noise_floor": floor}}]
    for algorithm, factor in {"floor": 1.0, **factors}.items():
        times = [1000 * factor * (1 + 0.002 * ((7 * i + len(algorithm)) % 5 - 2)) for i in range(samples)]
        lines.append({"family": "f", "algorithm": algorithm, "precision": "double", "protocol": "stream", "pairs": 10,
                      "samples": times, "instructions": 5000 * factor})
    path = Path(folder) / name
    path.write_text("".join(json.dumps(line) + "\n" for line in lines))
    return path


def test_builds():
    if not (ROOT / "build/slower/double/fatline-passes").exists():
        return "build/slower is not built (make tests)"
    with tempfile.TemporaryDirectory() as folder:
        path = cases(folder)
        for second, status, change in (("slower", REGRESSION, "SLOWER"), ("", 0, "same")):
            said = expect(fatline("compare", "--rows", "--noise-floor", 0.01, "--builds", ROOT / "build",
                                   ROOT / "build" / second, "-a", "bezier_clipping", path), status)
            assert [row["change"] for row in rows(said)] == [change], said
    return None


def test_builds_that_cannot_be_compared():
    with tempfile.TemporaryDirectory() as folder:
        path = cases(folder)
        expect(fatline("compare", "--builds", ROOT / "build"), 64)
        expect(fatline("compare", path), 64, "two files")
        expect(fatline("compare", "--builds", ROOT / "build", folder, "-a", "bezier_clipping", path), 2, "fatline-passes")


def test_rows():
    with tempfile.TemporaryDirectory() as folder:
        first = timed(folder, "a.jsonl", {"one": 2.0, "two": 3.0})
        slower = timed(folder, "b.jsonl", {"one": 2.2, "two": 3.0})
        near = timed(folder, "c.jsonl", {"one": 2.02, "two": 3.0})
        unknown = timed(folder, "d.jsonl", {"one": 2.2, "two": 3.0}, floor=None)
        found = {row["algorithm"]: row for row in rows(expect(fatline("compare", "--rows", first, slower), REGRESSION))}
        assert found["one"]["change"] == "SLOWER" and abs(found["one"]["ratio"] - 1.1) < 0.01, found
        assert found["two"]["change"] == "same" and "floor" not in found
        assert {row["reference"] for row in found.values()} == {"floor"}
        assert abs(found["one"]["noise_floor"] - (1.01 * 1.01 - 1)) < 1e-12
        assert rows(expect(fatline("compare", "--rows", slower, first), 0))[0]["change"] == "faster"
        expect(fatline("compare", first, near), 0, "noise floor  2.0%")
        expect(fatline("compare", first, first), 0)
        expect(fatline("compare", first, unknown), REGRESSION, "noise floor  6.0%")


def test_rows_do_not_depend_on_the_machine():
    """All times of the second run are half as long: the machine is faster, not the algorithm."""
    with tempfile.TemporaryDirectory() as folder:
        first, second = timed(folder, "a.jsonl", {"one": 2.0}), timed(folder, "b.jsonl", {"one": 2.0})
        lines = [json.loads(line) for line in second.read_text().splitlines()]
        for row in lines[1:]:
            row["samples"] = [ns / 2 for ns in row["samples"]]
        second.write_text("".join(json.dumps(line) + "\n" for line in lines))
        expect(fatline("compare", first, second), 0, "1 compared, 0 slower")


def test_instructions_decide():
    with tempfile.TemporaryDirectory() as folder:
        first, second = timed(folder, "a.jsonl", {"one": 2.0}), timed(folder, "b.jsonl", {"one": 2.01})
        expect(fatline("compare", first, second), 0)
        said = expect(fatline("compare", "--rows", "--instructions", first, second), REGRESSION)
        assert {row["algorithm"]: row["change"] for row in rows(said)} == {"one": "SLOWER", "floor": "same"}


def test_who_divides():
    """The default algorithm is compared like the others; the floor divides, unless another is named."""
    with tempfile.TemporaryDirectory() as folder:
        first, slower = timed(folder, "a.jsonl", {"certified": 3.0, "one": 2.0}), timed(folder, "b.jsonl", {"certified": 3.6, "one": 2.0})
        said = expect(fatline("compare", first, slower), REGRESSION, "divided by floor, which is not compared")
        assert "2 compared, 1 slower" in said, said
        expect(fatline("compare", "--reference", "one", first, slower), REGRESSION, "divided by one, which is not compared")
        expect(fatline("compare", "--reference", "no_such", first, slower), 64, "both have floor, certified, one")
        lines = [json.loads(line) for line in slower.read_text().splitlines()]
        slower.write_text("".join(json.dumps(line) + "\n" for line in lines if line.get("algorithm") != "floor"))
        expect(fatline("compare", first, slower), 64, "floor is not timed in both files; --reference NAME")
        expect(fatline("compare", "--reference", "one", first, slower), REGRESSION, "1 compared, 1 slower")


def test_rows_without_counts():
    with tempfile.TemporaryDirectory() as folder:
        first = timed(folder, "a.jsonl", {"one": 2.0})
        lines = [json.loads(line) for line in first.read_text().splitlines()]
        second = Path(folder) / "b.jsonl"
        second.write_text("".join(json.dumps({key: row[key] for key in row if key != "instructions"}) + "\n" for row in lines))
        expect(fatline("compare", "--instructions", first, second), 65, f"{second}: instructions: in no row")


def test_doctor():
    ended = fatline("doctor", "--rows", "--forget", "--trials", 5, "--rounds", 11)
    assert ended.returncode in (0, 1), ended.stderr
    row = rows(ended.stdout)[0]
    assert row["trials"] == 5 and 0 <= row["held"] <= 5 and 0 < row["noise_floor"] < 0.5, row
    assert (ended.returncode == 0) == (row["held"] == 5)
    expect(fatline("doctor", "--trials", "none"), 64)


def scripts():
    """The module, or why it cannot be had."""
    try:
        import comparisons
        return comparisons, None
    except ImportError as reason:
        return None, f"{reason} (make reproduce installs it)"


def test_profiles():
    comparisons, why = scripts()
    if why:
        return why
    import pandas as pd
    costs = pd.DataFrame({"a": [1.0, 2.0, 4.0, None], "b": [2.0, 1.0, 4.0, None], "c": [None, 8.0, None, None]})
    values, count = comparisons.profile(costs)
    assert count == 3  # the last problem nobody solved
    share = {name: [comparisons.share_within(values[name].to_numpy(), count, f) for f in (1, 2, 8, 1e9)] for name in costs}
    assert share["a"] == [2 / 3, 1, 1, 1] and share["b"] == [2 / 3, 1, 1, 1], share
    assert share["c"] == [0, 0, 1 / 3, 1 / 3], share
    return None


def test_holm_and_growth():
    comparisons, why = scripts()
    if why:
        return why
    import numpy as np
    assert np.allclose(comparisons.holm([0.01, 0.04, 0.03, 0.005]), [0.03, 0.06, 0.06, 0.02])  # Holm's own example
    assert np.allclose(comparisons.holm([0.9, 0.8]), [1, 1])
    x = np.array([2.0, 3, 5, 8])
    fit = comparisons.fitted_growth(x, 7 * x ** 2.5)
    assert abs(fit["exponent"] - 2.5) < 1e-12 and abs(fit["factor"] - 7) < 1e-9 and fit["exponent_hi"] - 2.5 < 1e-6
    assert comparisons.fitted_growth(x[:2], x[:2]) is None
    return None


def test_pairwise():
    comparisons, why = scripts()
    if why:
        return why
    import numpy as np
    import pandas as pd
    random = np.random.default_rng(5)
    found = []
    for problem in range(20):
        base = 100 * (1 + problem) * random.uniform(0.9, 1.1, 15)
        for name, factor in (("a", 1.0), ("b", 2.0), ("c", 1.0)):
            found.append({"family": f"f{problem}", "degrees": "-", "protocol": "stream", "algorithm": name,
                          "samples": list(base * factor * random.uniform(0.98, 1.02, 15))})
    table = comparisons.pairwise(pd.DataFrame(found)).set_index(["algorithm", "to"])
    ab, ac = table.loc[("a", "b")], table.loc[("a", "c")]
    assert abs(ab.ratio - 0.5) < 0.02 and ab.ratio_lo <= ab.ratio <= ab.ratio_hi and ab.differ == "yes", ab
    assert abs(ac.ratio - 1) < 0.02 and ac.p_holm >= ac.p and ac.differ == "not shown", ac
    return None


if __name__ == "__main__":
    run_tests(globals())
