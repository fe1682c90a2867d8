#!/usr/bin/python3
"""Makes results/tables/ (Markdown, CSV, LaTeX) from the rows in results/raw/, and prints the short one."""

import argparse
import json
import os
import sys
import textwrap
from collections import Counter
from pathlib import Path

import pandas as pd

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / os.environ.get("FATLINE_RESULTS", "results")  # the main job's quick run keeps its own
RAW = RESULTS / "raw"
TABLES = RESULTS / "tables"
FIGURES = RESULTS / "figures"
MASS = ROOT / "build/mass"  # too many rows to keep
VERDICTS = {"RIGHT": "right", "WRONG": "wrong", "STOPPED": "stopped", "NOT_TAKEN": "not_taken",
            "UNJUDGED": "unjudged", "BROKEN": "broken"}
COUNTS = ["missed", "extra", "duplicate", "merged", "undecided"]
SUMS = ["pairs", *VERDICTS.values(), "expected", "found", *COUNTS]
KEY = ["family", "degrees", "algorithm", "precision"]
TEXTS = [*KEY, "judge"]  # columns to the left
PRECISIONS = ["double", "quad", "multi"]
FLOOR = "floor"  # the yardstick, which every timing has


def label(family, degrees):
    return family if degrees == "-" else f"{family}-{degrees}"


def families():
    """(name, degrees, count, seed) for each family and pair of degrees of datasets/families.txt; degrees are
    "-" where a family has none."""
    found = []
    for number, line in enumerate(open(ROOT / "datasets/families.txt"), 1):
        fields = line.split("#")[0].split()
        if not fields:
            continue
        if len(fields) != 4 or not fields[2].isdigit():
            sys.exit(f"datasets/families.txt:{number}: expected NAME DEGREES COUNT SEED, found: {line.strip()}")
        for degrees in fields[1].split(","):
            both = degrees if "x" in degrees or degrees == "-" else f"{degrees}x{degrees}"
            found.append((fields[0], both, int(fields[2]), fields[3]))
    return found


def read_rows(kind):
    """All rows of the raw files KIND-PRECISION-FAMILY[-DEGREES].jsonl; environment lines are left out."""
    rows = []
    for path in sorted(RAW.glob(f"{kind}-*.jsonl")):
        family, degrees = (path.stem.split("-") + ["-"])[2:4]
        for number, line in enumerate(open(path), 1):
            try:
                row = json.loads(line)
            except ValueError as reason:
                sys.exit(f"{path.relative_to(ROOT)}:{number}: not a row of JSON: {reason}")
            if "environment" not in row:
                rows.append({**row, "family": family, "degrees": degrees})
    return pd.DataFrame(rows)


def in_order(table, orders):
    """Sorted as the families and algorithms are listed, not by name."""
    for column, order in orders.items():
        known = [x for x in order if x in set(table[column])]
        rest = [x for x in dict.fromkeys(table[column]) if x not in known]
        table[column] = pd.Categorical(table[column], known + sorted(rest), ordered=True)
    table = table.sort_values(list(orders)).reset_index(drop=True)
    return table.astype({column: str for column in orders})


def algorithm_order():
    """The order of the raw rows, which is that of the registry; those of double name every algorithm."""
    for path in sorted(RAW.glob("check-double-*.jsonl")):
        rows = map(json.loads, open(path))
        return list(dict.fromkeys(row["algorithm"] for row in rows if "algorithm" in row))
    return []


def orders():
    listed = families()
    return {"precision": PRECISIONS, "family": list(dict.fromkeys(f[0] for f in listed)),
            "degrees": sorted({f[1] for f in listed}, key=lambda d: [int(n) for n in d.split("x") if n != "-"]),
            "algorithm": algorithm_order()}


def checks():
    """A row a family, pair of degrees, algorithm and precision: how many pairs got which verdict, what was missed
    or extra.  Ambiguous pairs are counted, but not judged."""
    rows = read_rows("check")
    if rows.empty:
        return rows
    rows["ambiguous"] = rows["ambiguous"].astype(bool)
    judged = rows[~rows.ambiguous]
    groups = judged.groupby(KEY, sort=False)
    table = groups.size().rename("pairs").to_frame()
    for verdict, name in VERDICTS.items():
        table[name] = (judged.verdict == verdict).groupby([judged[k] for k in KEY], sort=False).sum()
    table = table.join(groups[["expected", "found", *COUNTS]].sum())
    table["max_error"] = judged[judged.verdict == "RIGHT"].groupby(KEY)["max_error"].max()
    table["ambiguous"] = rows.groupby(KEY)["ambiguous"].sum()
    return in_order(table.reset_index(), orders())


def masses():
    """A row a judge, pair of degrees and algorithm: random pairs whose answers the judge found afresh."""
    rows = []
    for path in sorted(MASS.glob("check-*.jsonl")):
        _, judge, degrees = path.stem.split("-")
        sums = {}
        for row in map(json.loads, open(path)):
            if "verdict" in row:
                counts = sums.setdefault(row["algorithm"], Counter())
                counts.update({"pairs": 1, VERDICTS[row["verdict"]]: 1, "expected": row["expected"] or 0,
                               **{what: row[what] for what in ("found", *COUNTS)}})
        rows += [{"judge": judge, "degrees": degrees, "algorithm": algorithm,
                  **{column: counts[column] for column in SUMS}} for algorithm, counts in sums.items()]
    return pd.DataFrame(rows)


def times():
    """A row a family, pair of degrees, algorithm and precision that was timed."""
    rows = read_rows("time")
    if rows.empty or "ns_median" not in rows:
        return pd.DataFrame()
    rows = rows[rows.pairs > 0].drop(columns=["samples", "run"], errors="ignore")
    return in_order(rows.reset_index(drop=True), orders())


def by_family(checked, timed):
    """The main table."""
    if not timed.empty:
        columns = [c for c in ("ns_median", "ns_lo", "ns_hi", "ns_max", "steps", "ratio", "ratio_lo", "ratio_hi",
                               "floor_ratio")
                   if c in timed]
        timed = timed.set_index(KEY)[["pairs", *columns]].rename(columns={"pairs": "timed_pairs"})
        checked = checked.join(timed, on=KEY)
    return checked


def summed(checked, columns):
    sums = [c for c in (*SUMS, "ambiguous") if c in checked]
    return checked.groupby(columns, sort=False)[sums].sum().reset_index()


def cell(row):
    """Of the matrix: the time in microseconds, or why there is none."""
    if row.pairs == row.not_taken:
        return "-"
    if row.missed:
        return f"{row.missed} miss"
    if row.extra:
        return f"{row.extra} extra"
    wrong = row.wrong + row.stopped + row.not_taken
    if pd.isna(row.get("ns_median")):
        return f"{wrong} not" if wrong else "right"
    return significant(row.ns_median / 1000) + ("*" if wrong else "")


def matrix(main, precision):
    """Families and degrees by algorithms."""
    rows = main[main.precision == precision].copy()
    rows["cell"] = rows.apply(cell, axis=1)
    places = list(dict.fromkeys(zip(rows.family, rows.degrees)))
    wide = rows.pivot(index=["family", "degrees"], columns="algorithm", values="cell")
    wide = wide.reindex(index=places, columns=list(dict.fromkeys(rows.algorithm)))
    if "floor_ratio" in rows:
        wide[FLOOR] = (rows.ns_median / rows.floor_ratio / 1000).groupby([rows.family, rows.degrees]).median().map(
            lambda us: "" if pd.isna(us) else significant(us))
    return wide.fillna("").reset_index()


def counts_matrix(main, precision):
    """Families by algorithms, all degrees together: right/missed/extra."""
    rows = summed(main[main.precision == precision], ["family", "algorithm"])
    rows["cell"] = [f"{r.right}/{r.missed}/{r.extra}" for r in rows.itertuples()]
    wide = rows.pivot(index="family", columns="algorithm", values="cell")
    wide = wide.reindex(index=list(dict.fromkeys(rows.family)), columns=list(dict.fromkeys(rows.algorithm)))
    pairs = rows.groupby("family", sort=False).pairs.max()
    wide.insert(0, "pairs", pairs.reindex(wide.index))
    return wide.reset_index()


def short(wide):
    """Of each family the rows that terminals and figures get: cubics, or the first degrees."""
    rows = [group[group.degrees == ("3x3" if (group.degrees == "3x3").any() else group.degrees.iloc[0])]
            for _, group in wide.groupby("family", sort=False)]
    return pd.concat(rows)


COUNTS_TITLE = "Pairs right / solutions missed / extra"
COUNTS_LEGEND = "Pairs that are not right without a miss or an extra stopped early, merged, or were not taken"
MATRIX_LEGEND = (
    "median time of a pair in microseconds. *: some pairs stopped early, merged or not taken, which are not timed; "
    "N miss: N solutions missed; N extra: N claimed where there is none; N not: N pairs not right and none timed; "
    "right: right but not timed; -: not taken at all; floor: the yardstick, which is told three digits of every root")


def significant(value, digits=3):
    """12345 -> 12300, 0.012345 -> 0.0123, without an exponent."""
    if value == 0:
        return "0"
    decimals = max(0, digits - 1 - int(f"{abs(value):e}".split("e")[1]))
    return f"{float(f'{value:.{digits - 1}e}'):.{decimals}f}"


def shown(table):
    """Numbers as people read them: times in microseconds, three digits."""
    table = table.copy()
    for column in [c for c in table if c.startswith("ns_")]:
        table[column] = [("" if pd.isna(v) else significant(v / 1000)) for v in table[column]]
        table = table.rename(columns={column: column.replace("ns_", "us_")})
    for column in table.select_dtypes("float"):
        small = column == "max_error"
        table[column] = [("" if pd.isna(v) else f"{v:.1e}" if small else significant(v)) for v in table[column]]
    return table.astype(str)


def markdown(table, title, note):
    head = [str(c) for c in table.columns]
    lines = [f"# {title}", "", note, "",
             "| " + " | ".join(head) + " |",
             "|" + "|".join(" --- " if c in TEXTS else " ---: " for c in head) + "|"]
    lines += ["| " + " | ".join(map(str, row)) + " |" for row in table.values.tolist()]
    return "\n".join(lines) + "\n"


def latex(table, caption):
    styler = table.rename(columns=lambda c: str(c).replace("_", r"\_")).replace("_", r"\_", regex=True).style
    form = "".join("l" if c in TEXTS else "r" for c in table.columns)
    return styler.hide(axis="index").to_latex(hrules=True, column_format=form, caption=caption)


def write(table, name, title, source, legend=""):
    note = f"{legend[:1].upper()}{legend[1:]}. " if legend else ""
    TABLES.mkdir(parents=True, exist_ok=True)
    table.to_csv(TABLES / f"{name}.csv", index=False)
    pretty = shown(table)
    (TABLES / f"{name}.md").write_text(markdown(
        pretty, title, f"{note}From {source}; the columns are explained in `results/README.md`."))
    (TABLES / f"{name}.tex").write_text(latex(pretty, f"{title}. {note}".strip()))


def aligned(table):
    """The table as lines of text for a terminal."""
    rows = [[str(c) for c in table.columns], *table.values.tolist()]
    widths = [max(len(str(row[i])) for row in rows) for i in range(len(rows[0]))]
    names = [i for i, c in enumerate(table.columns) if c in TEXTS]
    return "\n".join("  ".join(str(v).ljust(w) if i in names else str(v).rjust(w)
                               for i, (v, w) in enumerate(zip(row, widths))).rstrip() for row in rows)


def fold(text):
    return "\n".join(textwrap.wrap(text, 110))


def numbered(table):
    """The matrix with the algorithms' numbers as heads, so that it fits a terminal, and what they stand for."""
    names = [c for c in table.columns if c not in ("family", "degrees", "pairs")]
    heads = {name: f"[{i}]" for i, name in enumerate(names, 1)}
    legend = fold("  ".join(f"{heads[name]}\u00a0{name}" for name in names))
    return table.rename(columns=heads), legend.replace("\u00a0", " ")


def is_timed(main, precision):
    return "ns_median" in main and main[main.precision == precision].ns_median.notna().any()


def print_summary(main):
    for precision in dict.fromkeys(main.precision):
        rows = summed(main[main.precision == precision], ["algorithm"])
        columns = ["algorithm", *SUMS]
        counts, legend = numbered(counts_matrix(main, precision))
        print(f"\n{precision}, all families together: pairs and their verdicts; solutions\n")
        print(aligned(shown(rows[columns])))
        about = fold(f"{precision}, by family: {COUNTS_TITLE.lower()}. {COUNTS_LEGEND}.")
        print(f"\n{about}\n{legend}\n\n{aligned(shown(counts))}")
        if is_timed(main, precision):
            table, _ = numbered(short(matrix(main, precision)))
            about = fold(f"{precision}, by family, cubics where there are: {MATRIX_LEGEND}")
            print(f"\n{about}\n\n{aligned(table)}")


def print_masses(many):
    for judge in dict.fromkeys(many.judge):
        rows = many[many.judge == judge]
        degrees = list(dict.fromkeys(rows.degrees))
        print(f"\ndouble, random pairs of degrees {degrees[0]} to {degrees[-1]}, answers found afresh, judge {judge}\n")
        print(aligned(shown(summed(rows, ["algorithm"]))))


def make(quiet=False):
    """Writes all tables; returns the main one."""
    main = by_family(checks(), times())
    if main.empty:
        sys.exit(f"tables: there are no rows in {RAW}; make reproduce measures them")
    for path in [*TABLES.glob("counts-*"), *TABLES.glob("times-*")]:
        path.unlink()
    raw = "`results/raw/check-*`"
    write(main, "families", "Every algorithm on every family", f"{raw} and `results/raw/time-*`")
    write(summed(main, ["precision", "algorithm"]), "algorithms", "Every algorithm, all families together", raw)
    for precision in dict.fromkeys(main.precision):
        write(counts_matrix(main, precision), f"counts-{precision}", f"{COUNTS_TITLE}, {precision}", raw, COUNTS_LEGEND)
        if is_timed(main, precision):
            write(matrix(main, precision), f"times-{precision}", f"Time by family and algorithm, {precision}",
                  "`families.csv`", MATRIX_LEGEND)
    many = masses()
    if not many.empty:
        title = "Random pairs whose answers were found afresh"
        legend = "Judges: krawczyk, Krawczyk's test at binary128; exact, algebra"
        write(many, "masses", title, "`build/mass/`", legend)
    if not quiet:
        if not many.empty:
            print_masses(many)
        print_summary(main)
    return main


if __name__ == "__main__":
    argparse.ArgumentParser(description=__doc__).parse_args()
    make()
