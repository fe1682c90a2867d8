#!/usr/bin/python3
"""Compares the algorithms over all that was measured (results/raw/): performance profiles, accuracy against time, growth
with the degree and with the number of roots, and ratios of every two with intervals and corrected tests.

Tables go to results/tables/ (md, csv, tex), figures to results/figures/ (svg, pdf).  Nothing is measured here.
"""

import json
import sys
from itertools import combinations
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402
from scipy import stats  # noqa: E402

import tables  # noqa: E402

FIGURES = tables.FIGURES
EPSILON = 2.0 ** -52
RESAMPLES = 2000
LEVEL = 0.95
SEED = 1
COLORS = plt.get_cmap("tab20")
PLACE = ["family", "degrees"]


# ---- what was measured ----

def timed_rows(extra=()):
    """Rows of the clock in double, of the main job and of more files (of --single runs, say); each family and pair of
    degrees is one problem."""
    rows = tables.read_rows("time")
    more = [json.loads(line) for path in extra for line in open(path)]
    more = pd.DataFrame([row for row in more if "environment" not in row])
    if not more.empty:
        more["degrees"] = "-"
    rows = pd.concat([rows, more], ignore_index=True) if not more.empty else rows
    return rows[(rows.precision == "double") & (rows.pairs > 0)] if not rows.empty else rows


def checked_rows():
    """Rows of the judge in double; ambiguous pairs are left out."""
    rows = tables.read_rows("check")
    return rows[(rows.precision == "double") & ~rows.ambiguous.astype(bool)] if not rows.empty else rows


def algorithms_of(rows):
    return [a for a in dict.fromkeys(rows.algorithm) if a != tables.FLOOR]


# ---- performance profiles ----

def profile(costs):
    """Of a problem-by-solver table of costs (inf or NaN: not solved), for each solver the sorted ratios to the best:
    rho(tau) is the share of problems with a ratio of at most tau (Dolan and More, Math. Programming 91, 2002)."""
    costs = costs.where(np.isfinite(costs), np.inf)
    best = costs.min(axis=1)
    solvable = np.isfinite(best)
    return (costs[solvable].div(best[solvable], axis=0)).apply(np.sort), int(solvable.sum())


def share_within(sorted_costs, count, budget):
    return np.searchsorted(sorted_costs, budget, side="right") / count


def time_costs(rows):
    return rows[rows.algorithm != tables.FLOOR].pivot_table(index=PLACE, columns="algorithm", values="ns_median")


def step_costs(rows):
    """Only right answers count; points without steps have none."""
    right = rows[(rows.verdict == "RIGHT") & (rows.steps > 0)]
    return right.pivot_table(index=["family", "degrees", "id"], columns="algorithm", values="steps")


def draw_profile(costs, name, title, unit, absolute):
    """A curve an algorithm; a curve that ends low has solved few."""
    figure, axes = plt.subplots(figsize=(7, 4.2))
    if absolute:
        values, count = costs.where(np.isfinite(costs), np.inf).apply(np.sort), len(costs)
    else:
        values, count = profile(costs)
    finite = values.to_numpy()[np.isfinite(values.to_numpy())]
    reach = np.geomspace(max(finite.min(), 1e-9), finite.max() * 1.05, 400)
    for i, algorithm in enumerate(costs.columns):
        axes.step(reach, share_within(values[algorithm].to_numpy(), count, reach), where="post", lw=1.3,
                  color=COLORS(i % 20), label=algorithm)
    axes.set_xscale("log")
    axes.set_ylim(0, 1.02)
    axes.set_xlabel(unit)
    axes.set_ylabel(f"share of {count} problems")
    axes.set_title(title, fontsize=10)
    axes.grid(lw=0.3)
    axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    save(figure, name)
    return values, count


def profile_table(values, count):
    """Share of the problems within factors of the best."""
    factors = [1, 1.5, 2, 4, 10, 100]
    return pd.DataFrame([{"algorithm": a, "problems": count,
                          **{f"within_{f:g}": share_within(values[a].to_numpy(), count, f * (1 + 1e-12))
                             for f in factors}} for a in values.columns])


def make_profiles(timed, checked):
    for costs, what, unit in ((time_costs(timed), "time", "ns a pair"), (step_costs(checked), "steps", "steps")):
        if costs.empty:
            continue
        values, count = draw_profile(costs, f"profile-{what}", f"Performance profile, {what}",
                                     f"{what}, in multiples of the best", False)
        draw_profile(costs, f"profile-{what}-absolute", f"Absolute profile, {what}", unit, True)
        tables.write(profile_table(values, count), f"profile-{what}", f"Performance profile, {what}",
                     "`results/raw/`", "share of the problems solved within a factor of the best algorithm's cost")


# ---- accuracy against time ----

def accuracy(timed, checked):
    """A row an algorithm and family: median time, and the error of right answers over conditioning, in epsilons."""
    right = checked[(checked.verdict == "RIGHT") & checked.max_error.notna()].copy()
    if "cond" not in right:
        return pd.DataFrame()
    right = right[right.cond.notna()]
    right["error"] = right.max_error / (1 + right.cond) / EPSILON
    errors = right.groupby([*PLACE, "algorithm"], sort=False)["error"].agg(["median", "max"]).reset_index()
    times = timed[[*PLACE, "algorithm", "ns_median"]]
    return errors.merge(times, on=[*PLACE, "algorithm"]).rename(columns={"median": "error_median", "max": "error_max"})


def make_accuracy(timed, checked):
    table = accuracy(timed, checked)
    if table.empty:
        return
    figure, axes = plt.subplots(figsize=(7, 4.2))
    for i, algorithm in enumerate(algorithms_of(table)):
        rows = table[table.algorithm == algorithm]
        axes.plot(rows.ns_median / 1000, np.maximum(rows.error_median, 1e-2), "o", ms=3.5, color=COLORS(i % 20),
                  label=algorithm)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("median time of a pair, µs")
    axes.set_ylabel("parameter error / (1 + condition), epsilons")
    axes.grid(lw=0.3)
    axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
    save(figure, "accuracy")
    tables.write(table, "accuracy", "Accuracy against time", "`results/raw/`",
                 "error: largest parameter error of a right answer over 1 + condition number, in epsilons")


# ---- growth ----

def fitted_growth(x, y):
    """Exponent p of y = c x^p by least squares of the logarithms, its interval, and R squared; None below 3 points."""
    if len(set(x)) < 3:
        return None
    fit = stats.linregress(np.log(x), np.log(y))
    half = stats.t.ppf((1 + LEVEL) / 2, len(x) - 2) * fit.stderr
    return {"exponent": fit.slope, "exponent_lo": fit.slope - half, "exponent_hi": fit.slope + half,
            "r_squared": fit.rvalue ** 2, "points": len(x), "factor": float(np.exp(fit.intercept))}


def with_degree(rows):
    """Pairs of one degree in both curves."""
    square = rows[rows.degrees.str.match(r"^(\d+)x\1$")].copy()
    square["degree"] = square.degrees.str.split("x").str[0].astype(int)
    return square


def make_growth(timed):
    found = []
    by_degree = with_degree(timed)
    for family in ("random", "degree_sweep", "nice", "far"):
        rows = by_degree[by_degree.family == family]
        found += growth_of(rows, "degree", f"{family}, by degree", f"growth-{family}")
    if "roots" in timed:
        rows = with_degree(timed[timed.roots.notna() & (timed.roots > 0)])
        found += growth_of(rows[rows.degree == 3], "roots", "cubics, by number of roots", "growth-roots")
    if found:
        tables.write(pd.DataFrame(found), "growth", "Fitted growth of the time",
                     "`results/raw/time-*`", "time = factor (ns) x^exponent; 95 percent interval of the exponent")


def growth_of(rows, column, what, name):
    found, figure = [], plt.figure(figsize=(6, 4))
    axes = figure.subplots()
    for i, algorithm in enumerate(dict.fromkeys(rows.algorithm)):
        own = rows[rows.algorithm == algorithm].sort_values(column)
        fit = fitted_growth(own[column].to_numpy(float), own.ns_median.to_numpy(float))
        if not fit:
            continue
        found.append({"what": what, "algorithm": algorithm, **fit})
        axes.plot(own[column], own.ns_median / 1000, "o", ms=4, color=COLORS(i % 20),
                  label=f"{algorithm}: {fit['exponent']:.2f}")
        span = np.array([own[column].min(), own[column].max()], float)
        axes.plot(span, fit["factor"] * span ** fit["exponent"] / 1000, lw=1, color=COLORS(i % 20))
    if found:
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(column)
        axes.set_ylabel("median time of a pair, µs")
        axes.set_title(what, fontsize=10)
        axes.grid(lw=0.3)
        axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5), frameon=False)
        save(figure, name)
    plt.close(figure)
    return found


# ---- every two ----

def holm(p):
    """Holm's step-down correction (Scand. J. Statistics 6, 1979): adjusted p values."""
    p = np.asarray(p, float)
    order, adjusted, running = np.argsort(p), np.empty(len(p)), 0.0
    for rank, index in enumerate(order):
        running = max(running, min(1.0, (len(p) - rank) * p[index]))
        adjusted[index] = running
    return adjusted


def log_ratios(rows, a, b):
    """One number a problem that both were timed on: the median over the rounds, which both shared, of log(a / b)."""
    first, second = (rows[rows.algorithm == x].set_index([*PLACE, "protocol"]) for x in (a, b))
    shared = first.index.intersection(second.index)
    found = []
    for place in shared:
        x, y = np.asarray(first.at[place, "samples"]), np.asarray(second.at[place, "samples"])
        if len(x) == len(y) and len(x):
            found.append(np.median(np.log(x / y)))
    return np.array(found)


def geometric_interval(logs, random):
    means = random.choice(logs, (RESAMPLES, len(logs))).mean(axis=1)
    return np.exp(np.quantile(means, [(1 - LEVEL) / 2, (1 + LEVEL) / 2]))


def pairwise(rows):
    """A row each two: geometric mean of the ratio over problems, interval, Wilcoxon's test, corrected by Holm."""
    random, found = np.random.default_rng(SEED), []
    rows = rows.drop_duplicates([*PLACE, "algorithm", "protocol"])
    for a, b in combinations(algorithms_of(rows), 2):
        logs = log_ratios(rows, a, b)
        if len(logs) < 2:
            continue
        low, high = geometric_interval(logs, random)
        p = stats.wilcoxon(logs).pvalue if np.any(logs) else 1.0
        found.append({"algorithm": a, "to": b, "problems": len(logs), "ratio": np.exp(logs.mean()), "ratio_lo": low,
                      "ratio_hi": high, "faster_on": int((logs < 0).sum()), "p": p})
    table = pd.DataFrame(found)
    if not table.empty:
        table["p_holm"] = holm(table.p)
        table["differ"] = np.where(table.p_holm < 1 - LEVEL, "yes", "not shown")
    return table


def make_pairwise(timed):
    table = pairwise(timed)
    if table.empty:
        return
    pretty = table.copy()
    for column in ("p", "p_holm"):
        pretty[column] = [f"{p:.1e}" for p in table[column]]
    tables.write(pretty, "pairwise", "Every two algorithms", "`results/raw/time-*`",
                 "ratio of times on problems that both get right, geometric mean and 95 percent bootstrap interval over "
                 "problems; p: Wilcoxon's signed-rank test; p_holm: corrected for all rows by Holm's method")


def save(figure, name):
    FIGURES.mkdir(parents=True, exist_ok=True)
    figure.savefig(FIGURES / f"{name}.svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    figure.savefig(FIGURES / f"{name}.pdf", bbox_inches="tight", metadata={"CreationDate": None, "Creator": None,
                                                                          "Producer": None})
    plt.close(figure)


def make(extra=()):
    plt.rcParams.update({"svg.hashsalt": "fatline", "svg.fonttype": "path", "font.size": 9})
    timed, checked = timed_rows(extra), checked_rows()
    if timed.empty or checked.empty:
        sys.exit(f"comparisons: there are no rows in {tables.RAW}; make reproduce measures them")
    make_profiles(timed, checked)
    make_accuracy(timed, checked)
    make_growth(timed)
    make_pairwise(timed)
    print("results/tables/: profile-*, accuracy, growth, pairwise   results/figures/: the same, and growth-*")


if __name__ == "__main__":
    make([Path(p) for p in sys.argv[1:]])
