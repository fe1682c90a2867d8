#!/usr/bin/python3
"""Draws results/figures/: clip.svg, how one clip works, and time.svg, made from results/raw/."""

import argparse
import sys
from math import comb

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from scipy.spatial import ConvexHull  # noqa: E402

import tables  # noqa: E402

FIGURES = tables.FIGURES
BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#666666"
HUES = [BLUE, ORANGE, GREEN, "#cc79a7", "#56b4e9", "#e69f00"]
MARKERS = "oDs^"

F = np.array([[0.9, -0.3], [0.6, 2.2], [2.6, 0.9], [3.3, 3.6]])
G = np.array([[0.1, 2.5], [1.4, 1.35], [2.7, 2.35], [4.4, 1.0]])


def bezier(points, t):
    n = len(points) - 1
    basis = np.array([comb(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)])
    return basis.T @ points


def signed_distances(points, line):
    """From the line through the first and the last point of `line`."""
    along = line[-1] - line[0]
    normal = np.array([-along[1], along[0]]) / np.hypot(*along)
    return (points - line[0]) @ normal, normal


def fat_line(points):
    """Bounds of the cubic's distances from its chord: 3/4 or 4/9 of those of the inner control points
    (Sederberg and Nishita 1990), and the chord's normal."""
    (_, one, two, _), normal = signed_distances(points, points)
    factor = 3 / 4 if one * two > 0 else 4 / 9
    return factor * min(0, one, two), factor * max(0, one, two), normal


def hull_meet(polygon, lo, hi):
    """Where the convex polygon (ordered) meets the strip lo <= y <= hi: the range of x."""
    found = [p[0] for p in polygon if lo <= p[1] <= hi]
    for p, q in zip(polygon, np.roll(polygon, -1, axis=0)):
        for level in (lo, hi):
            if (p[1] - level) * (q[1] - level) < 0:
                found.append(p[0] + (level - p[1]) / (q[1] - p[1]) * (q[0] - p[0]))
    return min(found), max(found)


def draw_curves(axes, lo, hi, normal, clip):
    along = (G[-1] - G[0]) * 0.16
    ends = np.array([G[0] - along, G[-1] + along])
    strip = np.vstack([ends + lo * normal, (ends + hi * normal)[::-1]])
    axes.fill(*strip.T, color=ORANGE, alpha=0.14, lw=0)
    axes.plot(*ends.T, color=ORANGE, lw=0.8, ls=(0, (5, 4)))
    t = np.linspace(0, 1, 400)
    for points, color, name, place in [(F, BLUE, "$f$", (0.98, -0.42)), (G, ORANGE, "$g$", (4.46, 0.72))]:
        axes.plot(*points.T, color=color, lw=0.7, alpha=0.5, marker="o", ms=4, mec=color, mfc="white")
        axes.plot(*bezier(points, t).T, color=color, lw=1.8)
        axes.text(*place, name, color=color, fontsize=14)
    axes.plot(*bezier(F, np.linspace(*clip, 200)).T, color=GREEN, lw=5, alpha=0.65, solid_capstyle="butt")
    axes.text(3.55, 2.3, "fat line of $g$", color=ORANGE, ha="left", fontsize=11)
    axes.set_aspect("equal")
    axes.set_axis_off()


def draw_distance(axes, distances, lo, hi, clip):
    polygon = np.column_stack([np.linspace(0, 1, len(distances)), distances])
    hull = polygon[ConvexHull(polygon).vertices]
    t = np.linspace(0, 1, 400)
    axes.axhspan(lo, hi, color=ORANGE, alpha=0.14, lw=0)
    axes.fill(*hull.T, color=BLUE, alpha=0.10, lw=0)
    axes.plot(*np.vstack([hull, hull[:1]]).T, color=BLUE, lw=0.8)
    axes.plot(*polygon.T, color=BLUE, lw=0, marker="o", ms=4, mec=BLUE, mfc="white")
    axes.plot(t, bezier(distances, t), color=BLUE, lw=1.8)
    bottom = distances.min() - 0.35
    for end in clip:
        axes.plot([end, end], [bottom, hi], color=GREEN, lw=0.9, ls=(0, (2, 2)))
    axes.plot(clip, [bottom, bottom], color=GREEN, lw=5, alpha=0.65, solid_capstyle="butt")
    for end in (0, 1):
        axes.plot([end, end], [bottom - 0.06, bottom + 0.06], color=GREY, lw=0.8)
    axes.plot([0, 1], [bottom, bottom], color=GREY, lw=0.8, zorder=0)
    axes.text(0, bottom - 0.14, "0", color=GREY, ha="center", va="top")
    axes.text(1, bottom - 0.14, "1", color=GREY, ha="center", va="top")
    axes.text(sum(clip) / 2, bottom - 0.14, "what is left of $t$", color=GREEN, ha="center", va="top", fontsize=11)
    axes.text(0.78, distances.max() * 0.72, "$d(t)$ in its hull ", color=BLUE, ha="right", fontsize=11)
    axes.set_xlim(-0.05, 1.05)
    axes.set_axis_off()


def draw_clip():
    lo, hi, normal = fat_line(G)
    distances, _ = signed_distances(F, G)
    polygon = np.column_stack([np.linspace(0, 1, len(distances)), distances])
    clip = hull_meet(polygon[ConvexHull(polygon).vertices], lo, hi)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), gridspec_kw={"width_ratios": [1.25, 1]})
    draw_curves(left, lo, hi, normal, clip)
    draw_distance(right, distances, lo, hi, clip)
    figure.tight_layout()
    save(figure, "clip")


def draw_time():
    """Median time by family (cubics, where there are) and algorithm in the first precision that was timed: filled
    where every pair was right, hollow where some were not."""
    times = tables.times()
    if times.empty:
        print(f"figures: no rows of time in {tables.RAW}, so no time.svg", file=sys.stderr)
        return
    times = tables.short(times[times.precision == times.precision.iloc[0]])
    algorithms, families = list(times.algorithm.unique()), list(times.family.unique())
    figure, axes = plt.subplots(figsize=(9, 1.2 + 0.26 * len(families)))
    for index, algorithm in enumerate(algorithms):
        rows = times[times.algorithm == algorithm]
        height = np.array([families.index(name) + (index / len(algorithms) - 0.5) * 0.6 for name in rows.family])
        whole = (rows.right == rows.family_pairs - rows.left_out).to_numpy()
        color = HUES[index % len(HUES)]
        style = {"ls": "", "marker": MARKERS[index // len(HUES) % len(MARKERS)], "ms": 5, "mec": color}
        axes.plot(rows.ns_median[whole] / 1000, height[whole], mfc=color, **style)
        axes.plot(rows.ns_median[~whole] / 1000, height[~whole], mfc="white", **style)
        axes.plot([], [], mfc=color, label=algorithm, **style)
    for row in range(0, len(families), 2):
        axes.axhspan(row - 0.5, row + 0.5, color="black", alpha=0.04, lw=0)
    axes.set_xscale("log")
    axes.set_xlabel("median time of a pair, µs; hollow: of the pairs that were right, for some were not")
    axes.set_yticks(range(len(families)), families, fontsize=8)
    axes.set_ylim(len(families) - 0.5, -0.5)
    axes.grid(axis="x", lw=0.3)
    axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
    figure.tight_layout()
    save(figure, "time")


def save(figure, name):
    FIGURES.mkdir(parents=True, exist_ok=True)
    figure.savefig(FIGURES / f"{name}.svg", metadata={"Date": None, "Creator": None})
    plt.close(figure)
    print((FIGURES / f"{name}.svg").relative_to(tables.ROOT))


if __name__ == "__main__":
    argparse.ArgumentParser(description=__doc__).parse_args()
    plt.rcParams.update({"svg.hashsalt": "fatline", "svg.fonttype": "path", "font.size": 10,
                         "mathtext.fontset": "cm"})
    draw_clip()
    draw_time()
