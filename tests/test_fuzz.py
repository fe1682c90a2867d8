#!/usr/bin/python3
"""libFuzzer with address and undefined-behaviour sanitizers on the library's entry, tests/fuzz_library.c.  Prints TAP.

It begins with a few hundred ordinary pairs, batches and paths, and those inputs that were worth keeping before (build/fuzz/corpus), and goes on for
$FUZZ_SECONDS (60).  Before that, the same program with a planted mistake has to find it.  What fails is kept in
build/fuzz/ and can be run again: build/fuzz/library FILE."""

import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from runner import ROOT, run_tests

FUZZ = ROOT / "build/fuzz"
SECONDS = int(os.environ.get("FUZZ_SECONDS", "60"))
OPTIONS = ["-len_control=0", "-max_len=1024", "-timeout=120", "-print_final_stats=1", "-seed=1"]
PLANTED_SECONDS = 60  # it takes one


def numbers(chance, count):
    """So many coordinates: small dyadic numbers."""
    return [byte for _ in range(count) for byte in (0, chance.randint(0, 255))]


def pair(chance):
    """The bytes of a pair of curves of low degree: small dyadic control points, now and then weights, or f again."""
    n, m = chance.randint(1, 4), chance.randint(1, 4)
    kinds = chance.choice([0, 0, 0, 3, 12, 15])
    like = chance.choice([0, 0, 0, 0, 192, 193, 194, 195])
    out = [0, n, m, 0, kinds, like]
    for degree, rational in ((n, kinds % 4 == 3), (m, kinds // 4 % 4 == 3)):
        for i in range(34):
            if rational and i <= degree:
                out += [0, chance.randint(1, 127)]
            if i <= degree:
                out += numbers(chance, 2)
        if like >= 192:
            break
    if like >= 194:
        out += [chance.randint(0, 2 * n + 1), *numbers(chance, 1)]
    return bytes(out + [40, 255])


def batch(chance):
    """Of eight curves with eight others, and more pairs of them."""
    out = [2, chance.choice([9, 20, 255]), 40, 255, 7, 19]
    for _ in range(16):
        degree = chance.randint(1, 3)
        out += [9 + (degree - 1 - 9) % 3 + 3 * chance.randint(0, 9), *numbers(chance, 2 * degree + 2)]
    return bytes(out + [chance.randint(0, 7) for _ in range(24)])


def paths(chance):
    """Two paths of four segments end to end, or one."""
    alone, weights = chance.randint(0, 1), chance.choice([0, 0, 2])
    out = [3, 40, 255, alone]
    for _ in range(2 - alone):
        out += [weights + chance.choice([0, 4]), 4]
        for _ in range(4):
            kind = 8 + chance.randint(0, 20)
            degree, rational = 1 + kind % 4, weights and kind % 8 >= 4
            out.append(kind)
            for _ in range(degree + 1):
                out += [0, chance.randint(1, 127)] if rational else []
                out += numbers(chance, 2)
    return bytes(out)


SEEDS = (pair, batch, paths)


def plant(folder, count, kinds=SEEDS):
    chance = random.Random(1)
    folder.mkdir(parents=True, exist_ok=True)
    for kind in kinds:
        for i in range(count):
            (folder / f"{kind.__name__}{i}").write_bytes(kind(chance))


def fuzz(program, seconds, *folders):
    """What it wrote, and its status: 0 if it found nothing."""
    command = ["nice", FUZZ / program, *OPTIONS, f"-max_total_time={seconds}", f"-artifact_prefix={FUZZ}/", *folders]
    ended = subprocess.run([str(c) for c in command], capture_output=True, text=True, errors="replace")
    return ended.stderr, ended.returncode


def planted_mistake(folder):
    """Of each kind of seeds: the very part of the program that is asked has to say so."""
    for kind, part in zip(SEEDS, ("fuzz_library.c", "fuzz_batch.h", "fuzz_paths.h")):
        plant(folder / kind.__name__, 100, (kind,))
        told, status = fuzz("planted", PLANTED_SECONDS, folder / kind.__name__)
        for left in FUZZ.glob("crash-*"):
            if left.name in told:
                left.unlink()
        found = re.search(r"(\w+\.[ch]):\d+: does not hold", told)
        assert status != 0 and found, f"a UNIQUE of {kind.__name__} that is none was not found:\n" + told[-2000:]
        assert found.group(1) == part, f"{found.group()}, expected {part}"


def library(folder):
    plant(folder / "more", 150)
    (FUZZ / "corpus").mkdir(exist_ok=True)
    told, status = fuzz("library", SECONDS, FUZZ / "corpus", folder / "more")
    figures = dict(re.findall(r"stat::(\w+):\s+(\d+)", told))
    coverage = re.findall(r"cov: (\d+)", told)
    print(f"# {figures.get('number_of_executed_units', '?')} inputs in {SECONDS} s, {coverage[-1] if coverage else '?'} "
          f"branches seen, at most {figures.get('peak_rss_mb', '?')} MB", flush=True)
    lines = [line for line in told.splitlines() if re.search("does not hold|ERROR|SUMMARY|runtime error|Test unit", line)]
    assert status == 0, "\n".join(lines) or told[-2000:]


def main():
    if not shutil.which("clang"):
        print("clang is not installed")
        sys.exit(77)
    built = subprocess.run(["make", "build/fuzz/library", "build/fuzz/planted"], cwd=ROOT, capture_output=True, text=True,
                           env={k: v for k, v in os.environ.items() if not k.startswith("MAKE")})
    if built.returncode != 0:
        print("clang does not build it: " + built.stderr.strip().splitlines()[-1])
        sys.exit(77 if "fuzzer" in built.stderr else 1)
    with tempfile.TemporaryDirectory() as folder:
        run_tests([(test.__name__, lambda test=test: test(Path(folder) / test.__name__)) for test in (planted_mistake, library)])


if __name__ == "__main__":
    main()
