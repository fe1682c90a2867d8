#!/usr/bin/python3
"""The rounding bounds of straight-line code at degrees 2 and 3, machine-checked by Gappa.  Prints TAP.

A file tests/proofs/X.g states a bound as the C sources do and proves it.  Its comments tie it to them:

    # in: FILE         what follows stands in this file, but for white space
    # C: TEXT          in the code
    # says: TEXT       in a comment
    # also: A=B ...    proved again with each A replaced by its B
    # control: A B     with B instead of A, which is tighter, Gappa must not prove it

Some file named in it names X.g, or holds what it says.  S, the largest coordinate, is taken in [1, 2), as scaling by powers of two changes no
rounding; so a bound k u S is proved as k 2^-53 for all inputs up to 2.  Subnormal numbers are part of Gappa's model."""

import re
import shutil
import subprocess

from runner import ROOT, run_tests

PROOFS = sorted((ROOT / "tests/proofs").glob("*.g"))


def squeezed(text):
    return re.sub(r"\s+|^ \*", "", text, flags=re.M)


def comments(text):
    return " ".join(re.findall(r"/\*.*?\*/", text, flags=re.S)).replace(" * ", " ")


def code(text):
    return re.sub(r"/\*.*?\*/", "", text, flags=re.S)


def is_proved(text):
    ended = subprocess.run(["gappa"], input=text, capture_output=True, text=True, timeout=120)
    if "syntax error" in ended.stderr:
        raise AssertionError(ended.stderr.strip())
    return ended.returncode == 0, ended.stderr.strip()


def tied(path, text):
    """What the proof says of the sources and is not so."""
    source, named = "", False
    for word, what in re.findall(r"^# (in|C|says): (.*)$", text, flags=re.M):
        named = named or word == "says"
        if word == "in":
            source = (ROOT / what).read_text()
            named = named or path.name in source
        elif squeezed(what) not in squeezed(code(source) if word == "C" else comments(source)):
            yield f"not in the sources: {what}"
    if not named:
        yield "none of the sources names it"


def others(text, body):
    for line in re.findall(r"^# also: (.*)$", text, flags=re.M):
        by = dict(pair.split("=") for pair in line.split())
        yield re.sub(r"(?<![\w.])(" + "|".join(map(re.escape, by)) + r")(?![\w.])", lambda m: by[m.group()], body)


def complaints(path):
    text = path.read_text()
    yield from tied(path, text)
    body = re.sub(r"^#.*$", "", text, flags=re.M)
    for statement in [body, *others(text, body)]:
        proved, why = is_proved(statement)
        if not proved:
            yield f"not proved: {why}"
    controls = re.findall(r"^# control: (\S+) (\S+)$", text, flags=re.M)
    if not controls:
        yield "no control"
    for loose, tight in controls:
        if loose not in body:
            yield f"no bound {loose}"
        elif is_proved(body.replace(loose, tight))[0]:
            yield f"also proved with {tight}: the proof shows nothing"


def holds(path):
    if not shutil.which("gappa"):
        return "gappa is not installed (scripts/setup check)"
    found = list(complaints(path))
    assert not found, "\n".join(found)
    return None


if __name__ == "__main__":
    assert PROOFS
    run_tests([(path.name, lambda path=path: holds(path)) for path in PROOFS])
