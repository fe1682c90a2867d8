#!/usr/bin/python3
"""Writes results/report.html, one page that needs no network: claims with verdicts, the main tables and figures, what they
were measured on.  It is made of claims.md, tables/*.md, figures/*.svg and the environment lines of raw/; equal input gives
the same page.  A folder without claims.md, as the main job's quick run makes, has the claims of results/.
"""

import argparse
import json
import re
import sys
import urllib.parse
from pathlib import Path

import jinja2

import tables

TEMPLATE = Path(__file__).with_name("report.html.jinja")
# Chapters: title, what it answers, tables, figures.  Tables that have many rows are folded.
CHAPTERS = [
    ("Right and wrong", "What each algorithm found, missed or made up, judged by exact truth.",
     ["algorithms", "counts-double", "counts-quad", "counts-multi", "masses"], []),
    ("Time", "Median times of a pair, of what was right; profiles over all families; growth with degree and roots.",
     ["times-double", "profile-time", "profile-steps", "growth", "pairwise"],
     ["time", "profile-time", "growth-roots", "accuracy"]),
    ("The certified algorithm", "Its speed beside two libraries, and what became of masses of pairs.",
     ["speed", "speed_gaps", "certified", "paths"], ["paths"]),
    ("Other libraries", "The same pairs, the same truth, the same rounds.", ["peers_short", "peers_quick_short", "peers", "peers_quick", "peers_contacts"],
     ["profile-pairs"]),
    ("Convergence", "Bits after each round, steps against the tolerance, orders by class of solution.", ["claims_short"],
     ["widths", "orders", "cost", "clip"]),
    ("Where a control point may go", "Regions of constant curvature sign.",
     ["region_random", "region_times", "region_times_random"],
     ["region_envelope", "region_points", "region_zones", "region_interval"]),
]
FOLDED_ROWS = 80
VERDICTS = {"holds": "✓", "fails": "✗", "inconclusive": "?"}


def cells(line):
    return [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]]


def read_table(path):
    """The first table of a Markdown file, with the title and the text above it; None if there is no file."""
    if not path.exists():
        return None
    lines = path.read_text().splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("|"))
    rows = []
    for line in lines[first + 2:]:
        if not line.startswith("|"):
            break
        rows.append(cells(line))
    head = cells(lines[first])
    if any(len(row) != len(head) for row in rows):
        sys.exit(f"{path}: a row with another number of cells than the head")
    return {"name": path.stem, "title": lines[0].lstrip("# "), "legend": " ".join(lines[1:first]).strip().replace("`", ""), "head": head,
            "rows": rows, "folded": len(rows) > FOLDED_ROWS}


def read_figure(name, figures):
    """As a data address in double quotes, coordinates to a tenth of a point."""
    path = figures / f"{name}.svg"
    if not path.exists():
        return None
    text = re.sub(r"<metadata>.*?</metadata>|<!--.*?-->", "", path.read_text(), flags=re.S)
    text = re.sub(r"(\d\.\d)\d+(?=[ \n\"])", r"\1", text)
    text = re.sub(r"\s+", " ", text).replace('"', "'")
    return {"name": name, "data": urllib.parse.quote(text, safe=" '<>=:/;,.()!?&*{}")}


def read_claims(path):
    table = read_table(path)
    if table is None:
        return []
    return [dict(zip(table["head"], row)) for row in table["rows"]]


def commands(path):
    """{id of a claim: its command}"""
    found = {}
    text = path.read_text() if path.exists() else ""
    for names, command in re.findall(r"^- (.*?):\n  `(.*?)`$", text, re.M):
        found.update({name: command for name in names.split(", ")})
    return found


def environments(raw):
    """Each kind of file with what it was measured on, the newest of it."""
    found = {}
    for path in sorted(raw.glob("*.jsonl")):
        with open(path) as rows:
            first = rows.readline()
        if '"environment"' not in first[:20]:
            continue
        e = json.loads(first)["environment"]
        kind = path.stem.split("-")[0]
        if kind not in found or e["date"] > found[kind]["date"]:
            found[kind] = e
    return found


def is_number(text):
    return text[:1] in set("-+.0123456789<>") and text != "-"


def summary(claims):
    """{verdict: how many}"""
    return {verdict: sum(c["verdict"] == verdict for c in claims) for verdict in VERDICTS}


def make(results):
    source = results / "claims.md"
    source = source if source.exists() else tables.ROOT / "results/claims.md"
    claims = read_claims(source)
    chapters = [{"title": title, "about": about,
                 "tables": [t for t in (read_table(results / f"tables/{n}.md") for n in names) if t],
                 "figures": [f for f in (read_figure(n, results / "figures") for n in figures) if f]}
                for title, about, names, figures in CHAPTERS]
    environment = jinja2.Environment(autoescape=True, trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    return environment.from_string(TEMPLATE.read_text()).render(
        claims=claims, commands=commands(source), marks=VERDICTS, summary=summary(claims), chapters=chapters,
        environments=environments(results / "raw"), is_number=is_number)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=Path, default=tables.RESULTS, help="folder with tables/, figures/, raw/ (results)")
    parser.add_argument("--output", type=Path, help="page to write (report.html in that folder)")
    arguments = parser.parse_args()
    output = arguments.output or arguments.results / "report.html"
    output.write_text(make(arguments.results.resolve()))
    print(f"{output}: {output.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
