#!/usr/bin/python3
"""Draws results/figures/: widths, cost and orders from the rows in results/raw/claims/, and steps, one solved example.

widths   bits of the box after each round, with lines of the claimed slope
cost     steps against the tolerance by order of contact
orders   order per round by method and class of solution
steps    hybrid clipping of degree 2 on a pair of quartics: fat line, band and clip, step by step
Each as SVG and PDF.
"""

import json
import statistics
import sys
from fractions import Fraction

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from figures import BLUE, FIGURES, GREEN, GREY, ORANGE, bezier  # noqa: E402
from tables import ROOT  # noqa: E402

RAW = ROOT / "results/raw/claims"
COLORS = {"bezier_clipping": GREY, "hybrid_clipping_1": "#cc79a7", "hybrid_clipping_2": ORANGE,
          "hybrid_clipping_3": BLUE, "subdivision": "#999999", "gap_clipping_3": GREEN, "gap_clipping_5": "#005b41"}


def rows_of(name):
    path = RAW / f"{name}.jsonl"
    if not path.exists():
        print(f"figures: there is no {path.relative_to(ROOT)}: make claims", file=sys.stderr)
        return []
    return [row for row in map(json.loads, open(path)) if "environment" not in row]


def save(figure, name):
    FIGURES.mkdir(parents=True, exist_ok=True)
    figure.savefig(FIGURES / f"{name}.svg", metadata={"Date": None, "Creator": None})
    figure.savefig(FIGURES / f"{name}.pdf", metadata={"CreationDate": None, "Creator": None})
    plt.close(figure)
    print(f"results/figures/{name}.svg and .pdf")


def draw_widths():
    rows = [r for r in rows_of("widths") if r["event"] == "shrunk"]
    if not rows:
        return
    claimed = {"bezier_clipping": 2, "hybrid_clipping_1": 2, "hybrid_clipping_2": 3, "hybrid_clipping_3": 4,
               "gap_clipping_5": 6}
    figure, axes = plt.subplots(figsize=(7, 4.2))
    for name in dict.fromkeys(r["algorithm"] for r in rows):
        ends = {}
        for r in rows:
            if r["algorithm"] == name and r["round"] > 0:
                ends.setdefault(r["round"], -(r["log2_t"] + r["log2_s"]) / 2)
        rounds, bits = zip(*((k, b) for k, b in sorted(ends.items()) if b < 1900))
        axes.plot(rounds, bits, "o", color=COLORS.get(name), ms=5, label=f"{name}, order {claimed[name]}")
        line = np.linspace(1, rounds[-1], 50)
        axes.plot(line, bits[-1] * float(claimed[name]) ** (line - rounds[-1]), "-", lw=0.9, color=COLORS.get(name))
    axes.set_yscale("log", base=2)
    axes.set_xlabel("round")
    axes.set_ylabel("bits of the widths, $-\\frac{1}{2}\\log_2(ts)$")
    axes.grid(lw=0.3)
    axes.legend(fontsize=8, frameon=False)
    figure.tight_layout()
    save(figure, "widths")


def draw_cost():
    rows = [r for r in rows_of("cost-gap") if "steps" in r and r["outcome"] in ("SOLVED", "OUT_OF_ROOM")]
    if not rows:
        return
    ids = list(dict.fromkeys(r["id"] for r in rows))
    titles = ["contact 2", "contact 3", "contact 4"]
    laws = {r["id"] + r["algorithm"]: r for r in rows_of("cost-gap") if "exponent" in r}
    figure, panels = plt.subplots(1, len(ids), figsize=(11, 3.8), sharey=True)
    for axes, case, title in zip(panels, ids, titles):
        for name in dict.fromkeys(r["algorithm"] for r in rows):
            points = [(-r["log2_eps"], r["steps"]) for r in rows if r["id"] == case and r["algorithm"] == name]
            law = laws[case + name]
            what = f"$\\epsilon^{{-{law['exponent']:.2f}}}$" if law["law"] == "power" else "log"
            axes.plot(*zip(*points), "o-", ms=3, lw=0.9, color=COLORS.get(name), label=f"{name}: {what}")
        axes.set_yscale("log")
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("$\\log_2(1/\\epsilon)$")
        axes.grid(lw=0.3)
        axes.legend(fontsize=7, frameon=False, loc="upper left")
    panels[0].set_ylabel("steps")
    figure.tight_layout()
    save(figure, "cost")


CLASSES = {"crossing": ("crossing", 1), "tangency": ("contact 2", 2), "contact-3": ("contact 3", 3),
           "contact-4": ("contact 4", 4), "cusp": ("cusp crossed", 2), "cusp-along": ("cusp along", 3)}


def order_of(family, method):
    """The median order of a method in a class: None if it was not measured; 1: linear."""
    multiplicity = CLASSES[family][1]
    for name, linear in ((f"{family}-{method}", False), (f"{family}-linear-{method}", True)):
        path = RAW / f"{name}.jsonl"
        if path.exists():
            values = [r["per_round"] for r in rows_of(name)
                      if r.get("multiplicity") == multiplicity and r["per_round"] is not None]
            return (statistics.median(values), linear) if values else None
    return None


def draw_orders():
    methods = ["bezier_clipping", *(f"hybrid_clipping_{k}" for k in (1, 2, 3)), *(f"gap_clipping_{k}" for k in (2, 3, 4, 5)),
               *(f"pair_clipping_{k}" for k in (1, 2, 3))]
    found = {(m, c): order_of(c, m) for m in methods for c in CLASSES}
    if not any(found.values()):
        return
    figure, axes = plt.subplots(figsize=(7.5, 4.2))
    picture = np.array([[found[m, c][0] if found[m, c] else np.nan for c in CLASSES] for m in methods])
    axes.imshow(picture, cmap="YlGnBu", vmin=0.8, vmax=6, aspect="auto")
    for i, m in enumerate(methods):
        for j, c in enumerate(CLASSES):
            if found[m, c]:
                value, linear = found[m, c]
                fraction = Fraction(value).limit_denominator(4)
                text = "linear" if linear else f"{value:.2f}"
                if not linear and abs(value - float(fraction)) > 0.03 * value:
                    text += " !"
                axes.text(j, i, text, ha="center", va="center", fontsize=8, color="white" if value > 3.5 else "black")
    axes.set_xticks(range(len(CLASSES)), [label for label, _ in CLASSES.values()], fontsize=8)
    axes.set_yticks(range(len(methods)), methods, fontsize=8)
    axes.set_title("order per round, median over pairs (blank: no claim)", fontsize=9)
    figure.tight_layout()
    save(figure, "orders")


# ---- one example ----

EXAMPLE_F = np.array([[0.0, 0.2], [0.8, 1.5], [1.7, 1.1], [2.5, 1.9], [3.4, 3.0]])
EXAMPLE_G = np.array([[0.2, 2.9], [0.9, 2.2], [1.9, 1.9], [2.7, 0.9], [3.3, 0.2]])


def restrict(points, lo, hi):
    """Control points of the arc over [lo, hi], by interpolation at equidistant parameters."""
    n = len(points) - 1
    t = np.linspace(0, 1, n + 1)
    basis = np.array([[bezier(np.eye(n + 1)[:, i:i + 1], np.array([u]))[0, 0] for i in range(n + 1)] for u in t])
    return np.linalg.solve(basis, bezier(points, lo + (hi - lo) * t))


def fat_line(points):
    along = points[-1] - points[0]
    normal = np.array([-along[1], along[0]]) / np.hypot(*along)
    distance = (points - points[0]) @ normal
    return points[0], normal, min(0, distance.min()), max(0, distance.max())


def reduce_to_degree_2(points):
    """Best L2 approximation of degree 2, as values on a fine grid, and the largest distance of control points."""
    t, weights = np.polynomial.legendre.leggauss(12)
    t = (t + 1) / 2
    basis = np.vander(t, 3)
    scaled = basis * np.sqrt(weights)[:, None]
    coefficient, *_ = np.linalg.lstsq(scaled, bezier(points, t) * np.sqrt(weights)[:, None], rcond=None)
    grid = np.linspace(0, 1, 2001)
    approximation = np.vander(grid, 3) @ coefficient
    n = len(points) - 1
    nodes = np.linspace(0, 1, n + 1)
    rest = restrict_values(bezier(points, nodes) - np.vander(nodes, 3) @ coefficient)
    return grid, approximation, np.hypot(*rest.T).max()


def restrict_values(values):
    """Bernstein coefficients of the polynomial with these values at equidistant parameters."""
    n = len(values) - 1
    t = np.linspace(0, 1, n + 1)
    basis = np.array([[bezier(np.eye(n + 1)[:, i:i + 1], np.array([u]))[0, 0] for i in range(n + 1)] for u in t])
    return np.linalg.solve(basis, values)


def clip(points, other):
    """Where the band of degree 2 about `points` meets the fat line of `other`: the ends, by the roots of two quadratics."""
    origin, normal, lo, hi = fat_line(other)
    grid, approximation, delta = reduce_to_degree_2(points)
    distance = np.polyfit(grid, (approximation - origin) @ normal, 2)
    ends = [0.0, 1.0]
    for level in (lo - delta, hi + delta):
        ends += [r.real for r in np.roots(distance - [0, 0, level]) if abs(r.imag) < 1e-12 and 0 < r.real < 1]
    ends.sort()
    kept = [(a, b) for a, b in zip(ends, ends[1:]) if lo - delta <= np.polyval(distance, (a + b) / 2) <= hi + delta]
    return kept[0][0], kept[-1][1], delta


def draw_step(axes, arcs, on_f, number):
    points, other = (arcs[0], arcs[1]) if on_f else (arcs[1], arcs[0])
    color, other_color = (BLUE, ORANGE) if on_f else (ORANGE, BLUE)
    lo, hi, delta = clip(points, other)
    origin, normal, low, high = fat_line(other)
    along = other[-1] - other[0]
    ends = np.array([other[0] - 0.1 * along, other[-1] + 0.1 * along])
    axes.fill(*np.vstack([ends + low * normal, (ends + high * normal)[::-1]]).T, color=other_color, alpha=0.15, lw=0)
    grid, approximation, _ = reduce_to_degree_2(points)
    tangent = np.gradient(approximation, axis=0)
    across = np.column_stack([-tangent[:, 1], tangent[:, 0]]) / np.hypot(*tangent.T)[:, None]
    axes.fill(*np.vstack([approximation + delta * across, (approximation - delta * across)[::-1]]).T, color=color,
              alpha=0.15, lw=0)
    t = np.linspace(0, 1, 300)
    axes.plot(*bezier(other, t).T, color=other_color, lw=1.4)
    axes.plot(*bezier(points, t).T, color=color, lw=1.4)
    axes.plot(*bezier(points, np.linspace(lo, hi, 100)).T, color=GREEN, lw=4, alpha=0.7, solid_capstyle="butt")
    name = "f" if on_f else "g"
    axes.set_title(f"{number}: ${name}$ keeps {100 * (hi - lo):.2g} %", fontsize=9)
    axes.set_xticks([])
    axes.set_yticks([])
    for side in axes.spines.values():
        side.set_linewidth(0.4)
    return lo, hi


def draw_steps():
    arcs = [EXAMPLE_F, EXAMPLE_G]
    figure, panels = plt.subplots(1, 4, figsize=(11, 2.9))
    for number, axes in enumerate(panels, 1):
        on_f = number % 2 == 1
        lo, hi = draw_step(axes, arcs, on_f, number)
        arcs[0 if on_f else 1] = restrict(arcs[0 if on_f else 1], lo, hi)
    figure.text(0.5, 0.01, "shaded: the fat line of one curve and the band of degree 2 about the other; green: what is kept. "
                "Each picture shows what the one before has left.", ha="center", fontsize=8, color=GREY)
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    save(figure, "steps")


if __name__ == "__main__":
    plt.rcParams.update({"svg.hashsalt": "fatline", "svg.fonttype": "path", "font.size": 10, "mathtext.fontset": "cm"})
    draw_widths()
    draw_cost()
    draw_orders()
    draw_steps()
