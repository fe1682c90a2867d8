#!/usr/bin/python3
"""Other people's libraries as intersectors: those that are installed answer as they should, those that are not are named,
and whatever crashes, hangs or exhausts its stack is an answer in bounded time.  Prints TAP."""

import os
import subprocess
import tempfile
import time
from pathlib import Path

import runner
from runner import ROOT, rows, run_tests

REACH = "1e-4"
# What is right on clean crossings of cubics, and how exact its parameters are.
EXACT = {"lyon_geom": 1e-8, "lyon_geom_polished": 1e-13, "lib2geom": 1e-7, "lib2geom_polished": 1e-13,
         "open_cascade": 1e-11, "sisl": 1e-9, "sisl_polished": 1e-13, "cgal": 1e-13, "paper": 1e-8,
         "paper_polished": 1e-13, "flo_bezier3": 1e-13}
# Right on so many of 25: flo-bezier3 takes a pair of them for parts of one curve.
ALL_BUT = {"flo_bezier3": 22}
# How they speak of a shared arc.
OVERLAP = {"open_cascade": {"ends", "said"}, "sisl": {"ends"}, "cgal": {"said"}, "paper": {"ends"}, "flo_bezier3": {"said"}}
FAKE = """
#include "peer.h"
#include <stdlib.h>
#include <unistd.h>
static int sink(int n) { volatile char big[4096]; big[0] = (char)n; return sink(n + 1) + big[0]; }
enum peer_outcome peer_intersect(const struct peer_curve *f, const struct peer_curve *g, struct peer_roots *out)
{
    if (f->point[0] > 0.5 || g->point[0] > 0.5) { %s }
    peer_add(out, 0.5, 0.5);
    return PEER_SOLVED;
}
const char *peer_version(void) { return "fake"; }
"""
PROGRAM = """#!/usr/bin/python3
import sys, time
for line in iter(sys.stdin.readline, ""):
    word = line.split()
    if word[0] == "version": print("fake")
    elif word[1] == "solve" and any(float(x) == 0.75 for x in word[2:]): %s
    else: print("solved 0 1 0.5 0.5 0")
    sys.stdout.flush()
"""
# Two crossing segments; the second pair begins at 0.75, which the fakes take badly.
CASES = "".join('{"id":"%s","class":"transversal","f":{"points":[["%s",0],[1,1]]},"g":{"points":[["%s",1],[1,0]]},'
                '"expected":{"count":1,"params":[[0.5,0.5]],"exact":[["1/2","1/2"]],"mult":[1]}}\n' % (name, x, x)
                for name, x in (("good", "0"), ("bad", "0.75"), ("good again", "0")))


def fatline(*arguments, peers=None, **how):
    return runner.fatline(*arguments, env={"FATLINE_PEERS": str(peers)} if peers else None, **how)


def listed(peers=None):
    return {row["algorithm"]: row["foreign"] for row in rows(fatline("list", "--json", "peers", peers=peers))}


def there():
    return [name for name, about in listed().items() if not about["absent"]]


def proved(family, count, degree=3):
    made = fatline("generate", family, "--degree", degree, "--count", count, "--seed", 11).stdout
    return fatline("truth", text=made).stdout


def judged(cases, names, *options, peers=None, timeout=120):
    done = fatline("check", "--rows", "--points", REACH, "--max-steps", 2000, "-a", ",".join(names), *options,
                   text=cases, peers=peers, timeout=timeout)
    assert done.returncode in (0, 1), done.stderr
    return rows(done)


def test_everyone_is_listed():
    about = listed()
    assert len(about) == 15, about.keys()
    for name, x in about.items():
        assert x["licence"] and x["needs"]
        assert bool(x["version"]) != bool(x["absent"]), (name, x)
    assert not any(row["algorithm"] in about for row in rows(fatline("list", "--json", "all")))


def test_absent_ones_are_named():
    with tempfile.TemporaryDirectory() as empty:
        about = listed(peers=empty)
        assert all(x["needs"] in x["absent"] for x in about.values()), about
        shown = fatline("list", peers=empty)
        assert shown.returncode == 0 and shown.stdout.count("ABSENT") == len(about)
        for row in judged(CASES, ["lib2geom", "sisl", "paper"], peers=empty):
            assert row["verdict"] == "NOT_TAKEN" and row["outcome"] == "UNSUPPORTED", row


def test_clean_crossings():
    names = [name for name in EXACT if name in there()]
    if not names:
        return "no library is installed (make peers)"
    found = judged(proved("nice", 25), names)
    for name in names:
        right = [row for row in found if row["algorithm"] == name and row["verdict"] == "RIGHT"]
        assert len(right) >= ALL_BUT.get(name, 25), (name, len(right))
        assert all(row["max_error"] <= EXACT[name] for row in right), name
    return None


def test_exact_ones_on_contacts():
    names = [name for name in ("cgal", "flo_bezier3") if name in there()]
    if not names:
        return "neither CGAL nor flo-bezier3 is installed (make peers)"
    for row in judged(proved("tangent_same", 6), names):
        assert row["verdict"] == "RIGHT" and row["max_error"] < 1e-12, row
    return None


def test_overlaps():
    names = [name for name in OVERLAP if name in there()]
    if not names:
        return "no library that reports overlaps is installed (make peers)"
    for row in judged(proved("overlap", 6), names):
        assert row["overlap"] in OVERLAP[row["algorithm"]] | {"nothing"}, row
    for row in judged(proved("nice", 6), names):
        assert "overlap" not in row
    return None


def test_a_lost_stack_is_an_answer():
    if "kld_intersections" not in there():
        return "kld-intersections is not installed (make peers)"
    found = judged(proved("overlap", 4), ["kld_intersections"])
    assert {row["outcome"] for row in found} == {"GAVE_UP"} and {row["verdict"] for row in found} == {"BROKEN"}, found
    return None


def fakes(body, folder):
    source = Path(folder) / "fake.c"
    source.write_text(FAKE % body)
    subprocess.run(["gcc", "-O1", "-w", "-shared", "-fPIC", f"-I{ROOT}/algorithms/peers", "-o",
                    str(Path(folder) / "lib2geom.so"), str(source)], check=True)


def expect_contained(name, outcome, folder, bound):
    begun = time.monotonic()
    found = judged(CASES, [name, "bezier_clipping"], "--timeout", "1", peers=folder)
    assert time.monotonic() - begun < bound
    outcomes = {(row["id"], row["algorithm"]): (row["outcome"], row["verdict"]) for row in found}
    assert len(outcomes) == 6
    assert outcomes["bad", name] == (outcome, "BROKEN"), outcomes
    for case in ("good", "good again"):
        assert outcomes[case, name] == ("SOLVED", "RIGHT"), outcomes
    assert all(outcomes[case, "bezier_clipping"][1] == "RIGHT" for case in ("good", "bad", "good again"))


def test_crashes_and_hangs_in_process():
    for body, outcome in (("abort();", "CRASHED"), ("*(volatile int *)8 = 0;", "CRASHED"), ("return sink(0);", "CRASHED"),
                          ("for (;;) pause();", "TIMED_OUT"), ("exit(0);", "CRASHED"), ("return PEER_FAILED;", "GAVE_UP"),
                          ("return PEER_REFUSED;", None)):
        with tempfile.TemporaryDirectory() as folder:
            fakes(body, folder)
            if outcome:
                expect_contained("lib2geom", outcome, folder, 20)
            else:
                assert [row["verdict"] for row in judged(CASES, ["lib2geom"], peers=folder)].count("NOT_TAKEN") == 1


def test_crashes_and_hangs_of_programs():
    for body, outcome in (("sys.exit(3)", "CRASHED"), ("time.sleep(60)", "TIMED_OUT"), ("print('failed')", "GAVE_UP"),
                          ("print('nonsense')", "GAVE_UP")):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "sisl"
            program.write_text(PROGRAM % body)
            program.chmod(0o755)
            expect_contained("sisl", outcome, folder, 20)


def test_a_crash_while_timed_leaves_only_the_culprit_out():
    """The third call of a pair crashes: when it is judged all is well."""
    with tempfile.TemporaryDirectory() as folder:
        fakes("static int calls; if (++calls > 2) abort();", folder)
        done = fatline("time", "--rows", "--rounds", 5, "--forgive", "--points", REACH, "-a", "lib2geom,bezier_clipping",
                       text=CASES, peers=folder)
        assert done.returncode == 0, done.stderr
        found = {row["algorithm"]: row for row in rows(done)}
        assert "crashed while timed" in found["lib2geom"]["not_timed"], found["lib2geom"]
        assert found["bezier_clipping"]["pairs"] == 3 and found["floor"]["pairs"] == 3


def test_timing_protocols():
    names = [name for name in ("lib2geom_polished", "sisl_polished", "paper_polished") if name in there()]
    if not names:
        return "no library is installed (make peers)"
    done = fatline("time", "--rows", "--rounds", 5, "--seconds", 0.2, "--points", REACH, "--tolerance", "1e-9", "--forgive",
                   "-a", ",".join(names), "-b", "bezier_clipping", text=proved("nice", 10))
    assert done.returncode == 0, done.stderr
    for row in rows(done):
        assert row["protocol"] == ("inside" if row["algorithm"] in ("sisl_polished", "paper_polished") else "stream"), row
        assert row["pairs"] > 0 and row["ratio"] > 0 and row["floor_ratio"] > 0 and len(row["samples"]) == 5, row
        assert row["ns_min"] <= row["ns_q1"] <= row["ns_median"] <= row["ns_q3"], row
    return None


if __name__ == "__main__":
    run_tests(globals())
