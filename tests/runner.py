"""What the tests written in Python share: calls of `fatline`, and a runner that prints TAP."""

import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FATLINE = os.environ.get("FATLINE", str(ROOT / "build/fatline"))
PRECISIONS = ["double", "quad", "multi"]
CASES = Path(os.environ.get("FATLINE_CASES", ROOT.parent / "shared" / "cases"))  # verified cases, where they are


class Skipped(Exception):
    """Raised by a test that cannot be done here, with the reason."""


def fatline(*arguments, text=None, precision=None, timeout=300, env=None):
    """The finished process."""
    chosen = ["--precision", precision] if precision else []
    return subprocess.run([FATLINE, *chosen, *map(str, arguments)], input=text, capture_output=True, text=True,
                          timeout=timeout, env={**os.environ, **(env or {})})


def expect(ended, status, told=""):
    """Its standard output, if it ended so and said so."""
    said = f"{' '.join(map(str, ended.args[1:]))}: status {ended.returncode}: {ended.stdout[-1000:]}{ended.stderr[-1000:]}"
    assert ended.returncode == status, f"{said}: expected status {status}"
    assert told in ended.stdout + ended.stderr, f"{said}: expected {told!r}"
    return ended.stdout


def rows(text):
    """The rows of a text, or of what a process wrote, without the line on the circumstances."""
    lines = getattr(text, "stdout", text).splitlines()
    return [row for row in map(json.loads, lines) if "environment" not in row]


def number(a):
    """A number of JSON; a C hex float at the higher precisions."""
    return float.fromhex(a) if isinstance(a, str) else float(a)


def at_each_precision(*tests):
    return [(f"{test.__name__} {p}", lambda test=test, p=p: test(p)) for test in tests for p in PRECISIONS]


def run_tests(tests):
    """tests: pairs of name and function, or a module's globals(), of which test_* are taken.  A text that a test returns
    is why it was skipped; an exception of any kind is a failure.  Ends the program."""
    if isinstance(tests, dict):
        tests = [(name, test) for name, test in tests.items() if name.startswith("test_")]
    failed = 0
    os.chdir(ROOT)
    print(f"1..{len(tests)}")
    for count, (name, test) in enumerate(tests, 1):
        try:
            skipped = test()
            print(f"ok {count} - {name}" + (f" # SKIP {skipped}" if skipped else ""), flush=True)
        except Skipped as reason:
            print(f"ok {count} - {name} # SKIP {reason}", flush=True)
        except Exception as reason:  # noqa: BLE001: a test that ends in any other way has failed
            failed += 1
            told = f"{type(reason).__name__}: {reason}"[:2000].replace("\n", "\n# ")
            print(f"not ok {count} - {name}\n# {told}", flush=True)
    sys.exit(1 if failed else 0)
