#!/usr/bin/python3
"""Regions of control points: random families judged, and the time of a region against degree and spans.

Random families of degree 3 to 9 (Bezier, B-spline, each with and without weights), from a seed: both methods, each
against a dense sample of half-planes and against the other.  Times: curves that bend one way, at every degree and
number of spans, and random ones by what bounds their region.  Rows in results/raw/regions-time-double.jsonl and
regions-time_random-double.jsonl (those of the judgements, which are many, in build/regions/), tables in
results/tables/region_*.  Status 1 if something is wrong, or less than 99 percent of what
region_carriers found are certified.
"""

import argparse
import json
import math
import random
import subprocess
import sys

import pandas as pd

import tables

PROGRAM = tables.ROOT / "build/double/fatline-region"
ROWS = tables.ROOT / "build/regions"
SEED = 1
QUICK, FULL = 1000, 10000
DEGREES, SPANS, FAMILIES = range(3, 10), (1, 2, 4, 8, 16), 4
TIMED = 300  # random families
ROUND, RANDOM = "regions-time-double.jsonl", "regions-time_random-double.jsonl"
CERTIFIED = 0.99
KINDS = {(False, False): "Bezier", (False, True): "rational Bezier", (True, False): "B-spline", (True, True): "NURBS"}


def run(lines, options):
    done = subprocess.run([PROGRAM, *options], input=lines, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"regions: {' '.join(options)}: {done.stderr.strip()}")
    return done.stdout


def judge(count):
    """One row a kind of curve and method; the rows behind it."""
    lines = run("", ["--random", str(count), "--seed", str(SEED)])
    text = run(lines, ["--check", "--rows", "--method", "all"])
    ROWS.mkdir(parents=True, exist_ok=True)
    (ROWS / "random.jsonl").write_text(text)
    kinds = {}
    for line in map(json.loads, lines.splitlines()):
        kinds[line["id"]] = KINDS[bool(line.get("knots")), bool(line.get("weights"))]
    rows = pd.DataFrame([row for row in map(json.loads, text.splitlines()) if "environment" not in row])
    rows["curve"] = rows["id"].map(kinds)
    found = []
    for (curve, method), part in rows.groupby(["curve", "method"], sort=False):
        found.append({"curve": curve, "method": method, "families": len(part),
                      "empty": sum(part["kind"] == "empty"), "bounded": sum(part["kind"] == "bounded"),
                      "unbounded": sum(part["kind"].isin(["unbounded", "plane"])),
                      "wrong": sum(part["verdict"] != "RIGHT"), "certified": sum(part["certified"])})
    return pd.DataFrame(found).sort_values(["method", "curve"]), rows


def line_of(degree, spans, rational, index):
    """A curve along three quarters of a circle, its points a little off it; the point in the middle is free."""
    draw = random.Random(f"{degree} {spans} {rational} {index}")
    count = degree + spans
    points = []
    for i in range(count):
        angle = 1.5 * math.pi * i / (count - 1)
        radius = 100 + draw.uniform(-1, 1) * min(4, 40 / count)
        points.append([round(radius * math.cos(angle), 3), round(radius * math.sin(angle), 3)])
    knots = [0] * (degree + 1) + [f"{i}/{spans}" for i in range(1, spans)] + [1] * (degree + 1)
    line = {"id": f"round-{degree}-{spans}-{'w' if rational else 'p'}-{index}", "degree": degree, "knots": knots,
            "points": points, "free": count // 2, "sign": 1}
    if rational:
        line["weights"] = [draw.choice(["1", "1", "3/2", "2/3"]) for _ in range(count)]
    return json.dumps(line)


def measure():
    lines = [line_of(degree, spans, rational, index) for degree in DEGREES for spans in SPANS
             for rational in (False, True) for index in range(FAMILIES)]
    random_lines = run("", ["--random", str(TIMED), "--seed", str(SEED)])
    tables.RAW.mkdir(parents=True, exist_ok=True)
    for name, text in ((ROUND, "\n".join(lines)), (RANDOM, random_lines)):
        (tables.RAW / name).write_text(run(text, ["--time", "--method", "all"]))


def read(name):
    rows = pd.DataFrame([row for row in map(json.loads, open(tables.RAW / name)) if "environment" not in row])
    rows["curve"] = rows["rational"].map({False: "polynomial", True: "rational"})
    return rows


def random_table():
    """Medians by what the exact method found to bound the region, which decides what it costs."""
    rows = read(RANDOM)
    exact = rows[rows["method"] == "region_carriers"].set_index("id")
    bounded_by = exact.apply(lambda row: "empty" if row["kind"] == "empty" else "arcs" if row["arcs"] else "lines",
                             axis=1)
    rows["by"] = rows["id"].map(bounded_by)
    wide = rows.pivot_table(index=["curve", "method"], columns="by", values="ns", aggfunc=["count", "median"])
    table = pd.DataFrame(index=wide.index)
    for by in ("empty", "lines", "arcs"):
        table[f"families_{by}"] = wide["count", by]
        table[by] = wide["median", by] / 1000
    return table.reset_index()


def time_table():
    rows = read(ROUND)
    rows["spans"] = rows["id"].str.split("-").str[2].astype(int)
    wide = rows.pivot_table(index=["curve", "degree", "method"], columns="spans", values="ns", aggfunc="median") / 1000
    wide.columns = [f"spans_{n}" for n in wide.columns]
    return wide.reset_index()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--full", action="store_true", help=f"{FULL} random families instead of {QUICK}")
    parser.add_argument("--tables", action="store_true", help="only the tables of times, from the rows that are there")
    options = parser.parse_args()
    if not PROGRAM.exists():
        sys.exit("regions: build/double/fatline-region is not built; run make")
    status = 0
    if not options.tables:
        count = FULL if options.full else QUICK
        table, rows = judge(count)
        tables.write(table, "region_random", "Random families: right, and certified",
                     f"`scripts/regions.py{' --full' if options.full else ''}`, seed {SEED}")
        for row in rows[rows["verdict"] != "RIGHT"].itertuples():
            print(f"regions: {row.id} {row.method}: {row.why}", file=sys.stderr)
        exact = rows[rows["method"] == "region_carriers"]
        share = exact["certified"].mean()
        wrong = sum(rows["verdict"] != "RIGHT")
        print(f"{count} random families, both methods: {wrong} wrong; region_carriers certified {100 * share:.2f} %")
        status = int(wrong > 0 or share < CERTIFIED)
        measure()
    table = time_table()
    tables.write(table, "region_times", "Time of a region, microseconds", f"`results/raw/{ROUND}`",
                 "medians, one thread")
    print(tables.aligned(tables.shown(table)))
    table = random_table()
    tables.write(table, "region_times_random", "Time of a random region, microseconds", f"`results/raw/{RANDOM}`",
                 "medians over degrees 3 to 9, one thread")
    print(tables.aligned(tables.shown(table)))
    return status


if __name__ == "__main__":
    sys.exit(main())
