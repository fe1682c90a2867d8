#!/usr/bin/python3
"""Makes results/tables/ (Markdown, CSV, LaTeX) from the rows in results/raw/, and prints the short one."""

import argparse
import json
import sys
from pathlib import Path

import pandas as pd

ROOT = Path(__file__).resolve().parent.parent
RAW = ROOT / "results/raw"
TABLES = ROOT / "results/tables"
VERDICTS = {"RIGHT": "right", "WRONG": "wrong", "STOPPED": "stopped", "NOT_TAKEN": "not_taken",
            "UNJUDGED": "unjudged"}
COUNTS = ["missed", "extra", "duplicate", "merged", "undecided"]
KEY = ["family", "algorithm", "precision"]
PRECISIONS = ["double", "quad", "multi"]


def read_rows(pattern):
    """All rows of the raw files that match, each with the file's family; environment lines are left out."""
    rows = []
    for path in sorted(RAW.glob(pattern)):
        for number, line in enumerate(open(path), 1):
            try:
                row = json.loads(line)
            except ValueError as reason:
                sys.exit(f"{path.relative_to(ROOT)}:{number}: not a row of JSON: {reason}")
            if "environment" not in row:
                rows.append({**row, "family": path.stem.split("-", 2)[2]})
    return pd.DataFrame(rows)


def in_order(table, orders):
    """Sorted as the families and algorithms are listed, not by name."""
    for column, order in orders.items():
        known = [x for x in order if x in set(table[column])]
        rest = [x for x in dict.fromkeys(table[column]) if x not in known]
        table[column] = pd.Categorical(table[column], known + sorted(rest), ordered=True)
    table = table.sort_values(list(orders)).reset_index(drop=True)
    return table.astype({column: str for column in orders})


def family_order():
    """FAMILY-DEGREES in the order of datasets/families.txt."""
    names = []
    for line in open(ROOT / "datasets/families.txt"):
        fields = line.split("#")[0].split()
        if fields:
            names.append(f"{fields[0]}-{fields[1]}")
    return names


def algorithm_order():
    """The order of the raw rows, which is that of the registry; the rows of double name every algorithm."""
    for path in sorted(RAW.glob("check-double-*.jsonl")):
        rows = map(json.loads, open(path))
        return list(dict.fromkeys(row["algorithm"] for row in rows if "algorithm" in row))
    return []


def orders():
    return {"precision": PRECISIONS, "family": family_order(), "algorithm": algorithm_order()}


def checks():
    """A row a family, algorithm and precision: how many pairs got which verdict, what was missed or extra.
    Ambiguous pairs are counted, but not judged."""
    rows = read_rows("check-*.jsonl")
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


def times():
    """A row a family, algorithm and precision that was timed."""
    rows = read_rows("time-*.jsonl")
    if rows.empty or "ns_median" not in rows:
        return pd.DataFrame()
    rows = rows[rows.pairs > 0].drop(columns=["samples", "run"], errors="ignore")
    return in_order(rows.reset_index(drop=True), orders())


def by_family(checked, timed):
    """The main table."""
    if not timed.empty:
        columns = [c for c in ("ns_median", "ns_lo", "ns_hi", "ns_max", "steps", "ratio", "ratio_lo", "ratio_hi")
                   if c in timed]
        timed = timed.set_index(KEY)[["pairs", *columns]].rename(columns={"pairs": "timed_pairs"})
        checked = checked.join(timed, on=KEY)
    return checked


def by_algorithm(checked):
    sums = ["pairs", *VERDICTS.values(), "expected", "found", *COUNTS, "ambiguous"]
    table = checked.groupby(["precision", "algorithm"], sort=False)[sums].sum()
    return table.reset_index()


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
    rows = main[main.precision == precision].copy()
    rows["cell"] = rows.apply(cell, axis=1)
    names = list(dict.fromkeys(rows.algorithm))
    return rows.pivot(index="family", columns="algorithm", values="cell").reindex(
        index=list(dict.fromkeys(rows.family)), columns=names).fillna("").reset_index()


MATRIX_LEGEND = ("Median time of a pair in microseconds, at tolerance 1e-9; N miss: N solutions missed, N extra: N\n"
                 "proved where there is none; *: some pairs stopped early, merged or not taken (not timed);\n"
                 "N not: none timed, N pairs not right; right: right but not timed; -: not taken at all")


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


def markdown(table, title, source):
    head = [str(c) for c in table.columns]
    lines = [f"# {title}", "", f"From {source}; the columns are explained in `results/README.md`.", "",
             "| " + " | ".join(head) + " |",
             "|" + "|".join(" --- " if c in KEY else " ---: " for c in head) + "|"]
    lines += ["| " + " | ".join(map(str, row)) + " |" for row in table.values.tolist()]
    return "\n".join(lines) + "\n"


def latex(table, title):
    styler = table.rename(columns=lambda c: str(c).replace("_", r"\_")).replace("_", r"\_", regex=True).style
    form = "".join("l" if c in KEY else "r" for c in table.columns)
    return styler.hide(axis="index").to_latex(hrules=True, column_format=form, caption=title)


def write(table, name, title, source):
    TABLES.mkdir(parents=True, exist_ok=True)
    table.to_csv(TABLES / f"{name}.csv", index=False)
    pretty = shown(table)
    (TABLES / f"{name}.md").write_text(markdown(pretty, title, source))
    (TABLES / f"{name}.tex").write_text(latex(pretty, title))


def aligned(table):
    """The table as lines of text for a terminal."""
    rows = [[str(c) for c in table.columns], *table.values.tolist()]
    widths = [max(len(str(row[i])) for row in rows) for i in range(len(rows[0]))]
    names = [i for i, c in enumerate(table.columns) if c in KEY]
    return "\n".join("  ".join(str(v).ljust(w) if i in names else str(v).rjust(w)
                               for i, (v, w) in enumerate(zip(row, widths))).rstrip() for row in rows)


def numbered(table):
    """The matrix with the algorithms' numbers as heads, so that it fits a terminal, and what they stand for."""
    names = list(table.columns[1:])
    heads = {name: f"[{i}]" for i, name in enumerate(names, 1)}
    return table.rename(columns=heads), "  ".join(f"{heads[name]} {name}" for name in names)


def print_summary(main):
    for precision in dict.fromkeys(main.precision):
        rows = by_algorithm(main[main.precision == precision])
        columns = ["algorithm", "pairs", "right", "wrong", "stopped", "not_taken", "unjudged", "expected", "found",
                   *COUNTS]
        print(f"\n{precision}, all families together (pairs; then solutions):\n")
        print(aligned(shown(rows[columns])))
        if "ns_median" in main and main[main.precision == precision].ns_median.notna().any():
            short, legend = numbered(matrix(main, precision))
            print(f"\n{MATRIX_LEGEND}\n{legend}\n\n{aligned(short)}")


def make(quiet=False):
    """Writes all tables; returns the main one."""
    main = by_family(checks(), times())
    if main.empty:
        sys.exit("tables: there are no rows in results/raw/; make reproduce measures them")
    write(main, "families", "Every algorithm on every family", "`results/raw/check-*` and `results/raw/time-*`")
    write(by_algorithm(main), "algorithms", "Every algorithm, all families together", "`results/raw/check-*`")
    for precision in dict.fromkeys(main.precision):
        if "ns_median" in main and main[main.precision == precision].ns_median.notna().any():
            title = f"Time by family and algorithm, {precision}. " + MATRIX_LEGEND.replace("\n", " ")
            write(matrix(main, precision), f"matrix-{precision}", title, "`families.csv`")
    if not quiet:
        print_summary(main)
    return main


if __name__ == "__main__":
    argparse.ArgumentParser(description=__doc__).parse_args()
    make()
