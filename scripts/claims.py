#!/usr/bin/python3
"""Measures the claims of scripts/claims.toml, writes results/claims.md and compares the verdicts with the committed ones.

    scripts/claims.py [ID ...] [--short] [--list]

Without ids all claims are measured and results/claims.md is written; with ids (globs) those only, and they are printed;
with --short those that the file names for it, as a table, tables/claims_short of the results.  Rows as measured are kept in
results/raw/claims/, those of --short in build/claims/.  Exit status: 0, 1 if a verdict differs from the committed one, 2 if a
command failed.
"""

import argparse
import fnmatch
import json
import math
import os
import statistics
import sys
import time
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from workers import algorithms, run, run_all

ROOT = Path(__file__).resolve().parent.parent
TABLE = Path("results/claims.md")
RAW = Path("results/raw/claims")
SHORT = Path("build/claims")
WORKERS = 2
MOST_PART = 0.9   # of the values must be as claimed
LEAST_PART = 0.75  # of the rows must have a value
LINEAR_MOST = 1.1


@dataclass
class Claim:
    id: str
    statement: str
    source: str
    command: str
    kind: str
    value: float
    verdict: str
    rules: dict
    short: bool = False
    rows: list = field(default_factory=list)
    seconds: float = 0.0

    def __str__(self):
        return self.id


@dataclass
class Measured:
    verdict: str
    text: str       # the value with its range
    n: int          # values
    of: int         # rows that might have had one


def number_text(value):
    if math.isfinite(value) and value != round(value) and abs(3 * value - round(3 * value)) < 1e-6:
        return f"{round(3 * value)}/3"
    return f"{value:g}"


def read_claims(names):
    """Every claim of the file, one a name in its values; those about what is not in the registry are left out.  Last,
    rows that figures need."""
    claims, left_out = [], []
    with open(ROOT / "scripts/claims.toml", "rb") as stream:
        entries = tomllib.load(stream)
    for entry in entries["claim"]:
        values = entry.get("values", {"": entry.get("value", math.nan)})
        for name, value in values.items():
            def fill(text):
                return text.replace("{a}", name).replace("{e}", number_text(value))
            claim = Claim(fill(entry["id"]), fill(entry["statement"]), entry["source"], fill(entry["command"]),
                          entry["kind"], value, entry.get("verdicts", {}).get(name, entry["verdict"]), entry,
                          name in entry.get("short", []) if name else entry.get("short", False))
            known = not name or name in names or "needs_command" in entry
            (claims if known else left_out).append(claim)
    seen = set()
    for claim in claims:
        if claim.id in seen:
            sys.exit(f"scripts/claims.toml: {claim.id}: twice")
        seen.add(claim.id)
    rows = [Claim(r["id"], "", "", r["command"], "rows", math.nan, "", r) for r in entries["rows"]]
    return claims, left_out, rows


# ---- verdicts ----

def in_range(values, format_spec):
    if not values:
        return "-"
    middle, lo, hi = statistics.median(values), min(values), max(values)
    return f"{middle:{format_spec}} [{lo:{format_spec}}, {hi:{format_spec}}]"


def judge_values(values, of, claimed, within, format_spec=".3f"):
    """holds: nearly all values are within the tolerance; fails: the median is not, and no value is."""
    good = [abs(v - claimed) <= within for v in values]
    verdict = "inconclusive"
    if values and len(values) >= LEAST_PART * of and sum(good) >= MOST_PART * len(good):
        verdict = "holds"
    elif values and not any(good):
        verdict = "fails"
    return Measured(verdict, in_range(values, format_spec), len(values), of)


def judge_order(claim):
    rows = [r for r in claim.rows if "law" in r and r.get("multiplicity") == claim.rules["mu"]]
    values = [r["per_round"] for r in rows if r["law"] in ("superlinear", "linear") and r["per_round"] is not None]
    return judge_values(values, len(rows), claim.value, claim.rules["within"] * claim.value)


def judge_clips(claim):
    rows = [r for r in claim.rows if "law" in r and r.get("multiplicity") == claim.rules["mu"]]
    return judge_values([r["clips"] for r in rows if r["clips"]], len(rows), claim.value, 0, "g")


def judge_linear(claim):
    rows = [r for r in claim.rows if "law" in r and r.get("multiplicity") == claim.rules["mu"]]
    decided = [r for r in rows if r["law"] != "too_few"]
    values = [r["per_round"] for r in decided if r["per_round"] is not None]
    good = [r["law"] in ("linear", "stalled") and (r["per_round"] or 0) <= LINEAR_MOST for r in decided]
    verdict = "inconclusive"
    if decided and len(decided) >= LEAST_PART * len(rows) and all(good):
        verdict = "holds"
    elif decided and not any(good):
        verdict = "fails"
    return Measured(verdict, in_range(values, ".3f"), len(decided), len(rows))


def judge_cost(claim):
    rows = [r for r in claim.rows if "exponent" in r]
    long = [r for r in rows if r["law"] != "too_few" and r["log2_eps_from"] - r["log2_eps_to"] >= claim.rules["octaves"]]
    if claim.value > 0:
        return judge_values([r["exponent"] for r in long if r["exponent"] is not None], len(rows), claim.value,
                            claim.rules["within"])
    good = [r["law"] == "logarithmic" for r in long]
    verdict = "inconclusive"
    if long and len(long) >= LEAST_PART * len(rows) and sum(good) >= LEAST_PART * len(good):
        verdict = "holds"
    elif long and not any(good):
        verdict = "fails"
    slopes = in_range([r["b"] for r in long if r["law"] == "logarithmic"], ".2g")
    return Measured(verdict, f"logarithmic in {sum(good)}, {slopes} a bit", len(long), len(rows))


def case_number(row):
    return int(row["id"].rsplit("-", 1)[1])


def step_rows(claim):
    """Those with as many boxes as the claim is about; boxes_by_parity: of even cases and of odd ones."""
    rows = [r for r in claim.rows if "steps" in r and r["boxes"] <= claim.rules.get("boxes", math.inf)]
    boxes = claim.rules.get("boxes_by_parity")
    return [r for r in rows if r["boxes"] == boxes[case_number(r) % 2]] if boxes else rows


def judge_steps(claim):
    """The most steps of a case, or the median; a solve that ran out of steps counts with those it had."""
    rows = step_rows(claim)
    if not rows:
        return Measured("inconclusive", "-", 0, 0)
    most, middle = max(r["steps"] for r in rows), statistics.median(r["steps"] for r in rows)
    value = middle if claim.rules.get("statistic") == "median" else most
    above = claim.rules.get("sign") == "above"
    solved = all(r["outcome"] == "SOLVED" for r in rows)
    holds = value > claim.value if above else value <= claim.value and solved
    return Measured("holds" if holds else "fails", f"at most {most}, median {middle:g}", len(rows), len(rows))


def judge_growth(claim):
    """Median steps of the late cases less that of the early ones."""
    rows = step_rows(claim)
    early, late = ([r["steps"] for r in rows if lo <= case_number(r) <= hi]
                   for lo, hi in (claim.rules["early"], claim.rules["late"]))
    if not early or not late:
        return Measured("inconclusive", "-", 0, 0)
    a, b = statistics.median(early), statistics.median(late)
    holds = b - a > claim.value if claim.rules.get("sign") == "above" else b - a <= claim.value
    return Measured("holds" if holds else "fails", f"from {a:g} to {b:g}", len(early) + len(late), len(early) + len(late))


def judge_step_ratio(claim):
    """Steps of the first algorithm of the command over those of the second, case by case: is the median as claimed?"""
    steps = {}
    for r in claim.rows:
        if "steps" in r:
            steps.setdefault(r["id"], []).append(r["steps"])
    ratios = [a / b for a, b in steps.values()]
    holds = ratios and abs(statistics.median(ratios) - claim.value) <= claim.rules["within"] * claim.value
    return Measured("holds" if holds else "fails", in_range(ratios, ".2f"), len(ratios), len(ratios))


def judge_lost(claim):
    """What `fatline check` says of all classes, of the algorithm that ends the claim's id."""
    found = [r for r in claim.rows if "ambiguous" not in r["class"] and claim.id.endswith(r["algorithm"])][-1]  # the sum, if any
    missed = found["missed"] + found["broken"]
    return Measured("holds" if missed == 0 else "fails", f"{missed} missed, {found['wrong']} of the pairs wrong",
                    found["cases"], found["cases"])


def judge_lemma(claim):
    rows = [r for r in claim.rows if r.get("statement") in claim.rules["statements"]]
    if "against" not in claim.rules:
        values = [r[claim.rules["field"]] for r in rows if r[claim.rules["field"]] is not None]
        return judge_values(values, len(rows), claim.value, claim.rules["within"] * claim.value)
    pairs = [(r[claim.rules["field"]], r[claim.rules["against"]]) for r in rows]
    values = [a / b for a, b in pairs if a is not None and b]
    measured = judge_values(values, len(rows), 1, claim.rules["within"], ".4f")
    measured.text += " of it"
    return measured


def judge_roots(claim):
    rows = [r for r in claim.rows if r.get("row") == "order" and r["roots"] == claim.rules["roots"]]
    values = [r["per_clip"] for r in rows if r["per_clip"] is not None]
    return judge_values(values, len(values), claim.value, claim.rules["within"] * claim.value)


def judge_ratio(claim):
    """Is field over another never below the value?"""
    rows = [r for r in claim.rows if r.get("statement") in claim.rules["statements"]]
    values = [r[claim.rules["field"]] / r[claim.rules["over"]] for r in rows if r[claim.rules["field"]] and r[claim.rules["over"]]]
    holds = values and min(values) >= claim.value
    return Measured("holds" if holds else "fails", in_range(values, ".2f"), len(values), len(rows))


JUDGES = {"growth": judge_growth, "step_ratio": judge_step_ratio, "lost": judge_lost, "ratio": judge_ratio,
          "order": judge_order, "clips": judge_clips, "linear": judge_linear, "cost": judge_cost, "steps": judge_steps,
          "lemma": judge_lemma, "roots": judge_roots}


# ---- measuring ----

@dataclass
class Job:
    """One command, and the claims that its rows are read for."""

    command: str
    name: str  # of the file of rows: the first claim with this command
    claims: list

    def __str__(self):
        return self.name


def jobs_of(chosen, everything):
    first = {}
    for claim in everything:
        first.setdefault(claim.command, claim.id)
    return [Job(command, first[command], [c for c in chosen if c.command == command])
            for command in dict.fromkeys(c.command for c in chosen)]


def check_rows(text):
    """The table of `fatline check` as rows."""
    names = ["cases", "right", "wrong", "stopped", "not_taken", "unjudged", "broken", "missed", "extra", "duplicate",
             "merged", "undecided", "steps"]
    rows, kind = [], None
    for line in text.splitlines():
        if " cases " in line:
            kind = line[:line.index(" cases ")].strip()
        elif line.strip() and kind:
            name, *values = line.split()
            rows.append({"class": kind, "algorithm": name, **{k: int(v) for k, v in zip(names, values)}})
    return rows


def measure(job, folder):
    """None, or why the command failed.  `fatline check` ends with 1 if an answer is wrong in any way."""
    begun = time.monotonic()
    ended = run(["/bin/sh", "-c", job.command], env={"PATH": f"{ROOT / 'build'}:{os.environ['PATH']}"})
    seconds = time.monotonic() - begun
    lost = any(claim.kind == "lost" for claim in job.claims)
    if ended.returncode not in ((0, 1) if lost else (0,)):
        return f"status {ended.returncode}: {ended.stderr.strip()[-500:]}"
    rows = check_rows(ended.stdout) if lost else [json.loads(line) for line in ended.stdout.splitlines()]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{job.name}.jsonl").write_text("".join(json.dumps(r) + "\n" for r in rows) if lost else ended.stdout)
    for claim in job.claims:
        claim.rows, claim.seconds = rows, seconds
    return None


def minutes(seconds):
    """Rounded up to fives, so that the table is the same on a busy machine."""
    return f"< {5 * math.ceil(max(seconds, 1) / 300)}"


def expected(claim):
    if claim.kind == "linear":
        return "linear"
    if claim.kind == "cost" and claim.value == 0:
        return "logarithmic"
    if claim.kind in ("steps", "growth"):
        return ("> " if claim.rules.get("sign") == "above" else "<= ") + number_text(claim.value)
    if claim.kind == "lost":
        return "0 missed"
    if claim.kind == "ratio":
        return ">= " + number_text(claim.value)
    if "against" in claim.rules:
        return "theory"
    return number_text(claim.value)


def table(claims, left_out):
    def cell(text):
        return str(text).replace("|", "\\|")
    lines = ["# Claims", "",
             "Written by `make claims`; `make claim-ID` measures one again. Measured: median and range over the n rows that",
             "have a value, of how many might. holds: nine values in ten are within the tolerance of the claim (3 percent for",
             "orders, 5 in double); fails: none is; inconclusive: anything between. The data are in `scripts/claims.toml`, the",
             "rows in `results/raw/claims/`.", "",
             "| id | statement | source | expected | measured | n | minutes | verdict |",
             "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for c in claims:
        m = c.measured
        lines.append("| " + " | ".join(map(cell, [c.id, c.statement, c.source, expected(c), m.text, f"{m.n} of {m.of}",
                                                  minutes(c.seconds), m.verdict])) + " |")
    lines += ["", "## Commands", ""]
    for command in dict.fromkeys(c.command for c in claims):
        lines += [f"- {', '.join(c.id for c in claims if c.command == command)}:", f"  `{command}`"]
    if left_out:
        lines += ["", "Not measured, for the algorithm is not in the registry: " + ", ".join(c.id for c in left_out) + "."]
    return "\n".join(lines) + "\n"


def write_short(claims):
    """The table, and as text for a terminal."""
    import tables
    columns = ["claim", "expected", "measured", "n", "verdict"]
    table = tables.pd.DataFrame([[c.id, expected(c), c.measured.text, f"{c.measured.n} of {c.measured.of}",
                                  c.measured.verdict] for c in claims], columns=columns)
    tables.write(table, "claims_short", "Claims measured again", "`build/claims/`",
                 "what they say: `results/claims.md`")
    widths = [max(map(len, [name, *table[name]])) for name in columns]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip()
                     for row in [columns, *table.values.tolist()])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ids", nargs="*", metavar="ID", help="claims to be measured, or globs (all)")
    parser.add_argument("--short", action="store_true", help="those of the main job, as a table")
    parser.add_argument("--list", action="store_true", help="name the claims")
    arguments = parser.parse_args()
    os.chdir(ROOT)
    claims, left_out, rows = read_claims(algorithms("multi"))
    chosen = [c for c in claims if (c.short if arguments.short else not arguments.ids)
              or any(fnmatch.fnmatch(c.id, i) for i in arguments.ids)]
    whole = not arguments.ids and not arguments.short
    if arguments.list:
        print("\n".join(c.id for c in chosen))
        return 0
    if not chosen:
        print(f"no claim {' '.join(arguments.ids)}; scripts/claims.py --list names them", file=sys.stderr)
        return 64
    broken = 0
    everything = claims + rows
    jobs = jobs_of(everything if whole else chosen, everything)
    folder = SHORT if arguments.short else RAW
    for job, problem in run_all(jobs, lambda j: 1, "claims", WORKERS, lambda j: measure(j, folder)):
        if problem:
            broken += 1
            print(f"{job.name}: {problem}", file=sys.stderr)
    for claim in chosen:
        claim.measured = JUDGES[claim.kind](claim)
    if whole:
        for path in RAW.glob("*.jsonl"):
            if path.stem not in [j.name for j in jobs]:
                path.unlink()
    different = [c for c in chosen if c.measured.verdict != c.verdict]
    if whole:
        TABLE.write_text(table(chosen, left_out))
        print(f"{TABLE}: {len(chosen)} claims")
    elif arguments.short:
        print(write_short(chosen))
    else:
        for c in chosen:
            print(f"{c.id}: {c.statement}\n    {c.command}\n    expected {expected(c)}, measured {c.measured.text}, "
                  f"n {c.measured.n} of {c.measured.of}, {c.seconds:.1f} s: {c.measured.verdict}")
    for c in different:
        print(f"{c.id}: {c.measured.verdict}, but the committed verdict is {c.verdict}", file=sys.stderr)
    return 2 if broken else 1 if different else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
