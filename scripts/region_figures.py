#!/usr/bin/python3
"""Draws results/figures/ of regions of control points, from `fatline region` and the curves themselves.

region_envelope  the worked example of Karousos: envelope (S+ dashed, S- solid), corner lines, the region; near and far
region_inside    the curve and its curvature with the free point inside
region_outside   the same with it outside
region_points    the regions of all control points of one curve at once
region_zones     the plane by the number of inflections that the curve has with its free point there
region_interval  the region against the interval
Each as SVG and PDF.
"""

import json
import subprocess
import sys
from fractions import Fraction

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import ListedColormap  # noqa: E402

from convergence_figures import save  # noqa: E402
from figures import BLUE, GREY, HUES, ORANGE  # noqa: E402
from tables import ROOT  # noqa: E402

PROGRAM = ROOT / "build/double/fatline-region"
EXAMPLE = {"id": "karousos", "degree": 5, "knots": ["0"] * 6 + ["1/4", "1/2"] + ["1"] * 6, "free": 2, "sign": -1,
           "points": [[-12, 3], [-7, 16], [0, 0], [7, 15], [17, 18], [13, 5], [1, 1], [8, 8]]}
INSIDE, OUTSIDE = (3, 22), (1, 13)
QUARTIC = {"id": "quartic", "degree": 4, "free": 2, "sign": -1, "points": [[0, 0], [1, 3], [4, 4], [7, 3], [9, 0]]}
SPLINE = {"id": "spline", "degree": 3, "knots": [0] * 4 + ["1/4", "1/2", "3/4"] + [1] * 4, "free": 0, "sign": -1,
          "points": [[0, 0], [0, 3], [2, 6], [6, 7], [10, 6], [12, 3], [12, 0]]}


def solve(line, *options):
    done = subprocess.run([PROGRAM, *options], input=json.dumps(line), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"region_figures: {done.stderr.strip()}")
    return [json.loads(row) for row in done.stdout.splitlines()]


def knots_of(line):
    n = line["degree"]
    return np.array([float(Fraction(k)) for k in line.get("knots") or [0] * (n + 1) + [1] * (n + 1)])


def basis(knots, degree, t):
    """Values of all B-splines at each t inside, by Cox and de Boor; the last t belongs to the last span."""
    inside = (knots[:-1] <= t[:, None]) & (t[:, None] < knots[1:])
    last = np.flatnonzero(knots < knots[-1])[-1]
    inside[t >= knots[-1]] = np.arange(len(knots) - 1) == last
    values = inside.astype(float)
    for n in range(1, degree + 1):
        with np.errstate(divide="ignore", invalid="ignore"):
            up = np.nan_to_num((t[:, None] - knots[: -n - 1]) / (knots[n:-1] - knots[: -n - 1]), posinf=0, neginf=0)
            down = np.nan_to_num((knots[n + 1:] - t[:, None]) / (knots[n + 1:] - knots[1:-n]), posinf=0, neginf=0)
        values = up * values[:, :-1] + down * values[:, 1:]
    return values


def derivative(knots, degree, points):
    """Control points and knots of the derivative."""
    with np.errstate(divide="ignore", invalid="ignore"):
        factor = np.nan_to_num(degree / (knots[degree + 1:-1] - knots[1:-degree - 1]), posinf=0, neginf=0)
    return knots[1:-1], factor.reshape(-1, *[1] * (points.ndim - 1)) * np.diff(points, axis=0)


def derivatives(line, points, t, order):
    knots, degree, out = knots_of(line), line["degree"], []
    for _ in range(order + 1):
        out.append(basis(knots, degree, t) @ points)
        knots, points = derivative(knots, degree, points)
        degree -= 1
    return out


def split(line, t):
    """(N, s) of F = d N + s, each with two derivatives, for the free control point of a polynomial curve."""
    points, free = np.array(line["points"], float), line["free"]
    alone = np.zeros(len(points))
    alone[free] = 1
    points[free] = 0
    return derivatives(line, alone, t, 2), derivatives(line, points, t, 2)


def envelope(line, t):
    n, s = split(line, t)
    with np.errstate(divide="ignore", invalid="ignore"):
        return -s[1] / n[1][:, None]


def line_at(line, t):
    """A, B, C of the half-plane at t, for the sign of the line."""
    n, s = split(line, np.array([t]))
    w, v = (np.array([-s[k][0, 0], -s[k][0, 1], n[k][0]]) for k in (1, 2))
    a = np.cross(w, v) * line["sign"]
    return a / np.hypot(a[0], a[1])


def with_point(line, d):
    points = [list(p) for p in line["points"]]
    points[line["free"]] = list(d)
    return dict(line, points=points)


def boundary(line, answer, reach=1e4):
    """The region's boundary as a polygon; ends at infinity are far away along their lines."""
    out = []
    for edge in answer["edges"]:
        if edge["type"] == "arc":
            out.extend(arc(line, edge, reach))
            continue
        a, b, c = edge["line"]
        foot, along = np.array([-a * c, -b * c]), np.array([b, -a])
        start, end = edge["from"], edge["to"]
        known = np.array(start or end or foot)
        out.append(np.array(start) if start else known - reach * along)
        out.append(np.array(end) if end else known + reach * along)
    return np.array(out)


def arc(line, edge, reach):
    t = np.linspace(edge["t0"], edge["t1"], 402)[1:-1]
    t = edge["t0"] + (edge["t1"] - edge["t0"]) * (1 - np.cos(np.pi * (t - t[0]) / (t[-1] - t[0]))) / 2
    points = envelope(line, t)
    return points[np.isfinite(points).all(axis=1) & (np.abs(points) < reach).all(axis=1)]


def draw_line(axes, l, **style):
    a, b, c = l
    foot, along = np.array([-a * c, -b * c]), np.array([b, -a]) / np.hypot(a, b)
    axes.plot(*np.array([foot - 1e3 * along, foot + 1e3 * along]).T, **style)


def segments(answer):
    """(t0, t1, type) of the envelope's segments."""
    marks = answer["breaks"]
    for here, there in zip(marks, marks[1:]):
        if "type" in here and there["t"] > here["t"]:
            yield here["t"], there["t"], here["type"]


def draw_envelope(axes, line, answer, box):
    for t0, t1, kind in segments(answer):
        points = envelope(line, t0 + (t1 - t0) * np.linspace(1e-5, 1 - 1e-5, 4000))
        far = (points < [box[0] - 200, box[2] - 200]) | (points > [box[1] + 200, box[3] + 200])
        points[far.any(axis=1)] = np.nan
        axes.plot(*points.T, color=ORANGE if kind == "S+" else BLUE, ls="--" if kind == "S+" else "-", lw=1.3)
    for t in [b["t"] for b in answer["breaks"] if b["why"] in ("end", "M")]:
        if line["free"] < 3 and t == 0 or 0 < t < 1:
            draw_line(axes, line_at(line, t), color=GREY, lw=0.7)


def draw_allowed(axes, line, answer, box):
    """What the lines of each S+ segment allow, and darker what all of them do."""
    x, y = np.meshgrid(np.linspace(box[0], box[1], 400), np.linspace(box[2], box[3], 400))
    shade = np.zeros(x.shape)
    allowed, before = None, "S-"
    for t0, t1, kind in [*segments(answer), (1, 1, "S-")]:
        if before == "S+" and kind != "S+":
            shade += 0.12 * allowed
        if before != "S+":
            allowed = np.ones(x.shape, bool)
        before = kind
        for t in t0 + (t1 - t0) * np.linspace(1e-4, 1 - 1e-4, 300 if kind == "S+" else 0):
            a, b, c = line_at(line, t)
            allowed &= a * x + b * y + c > 0
    axes.imshow(1 - shade, origin="lower", extent=box, cmap="gray", vmin=0, vmax=1, interpolation="bilinear", zorder=-1)


def finish(axes, box):
    axes.set_aspect("equal")
    axes.set_xlim(box[0], box[1])
    axes.set_ylim(box[2], box[3])
    axes.grid(alpha=0.2)


def legend(axes, *entries):
    for label, style in entries:
        axes.plot([], [], label=label, **style)
    axes.legend(fontsize=8, loc="best")


def draw_region_envelope():
    answer, = solve(EXAMPLE)
    figure, axes = plt.subplots(1, 2, figsize=(11, 5.2))
    boxes = (-40, 60, -30, 70), (-12, 24, 10, 42)
    draw_allowed(axes[0], EXAMPLE, answer, boxes[0])
    for ax, box in zip(axes, boxes):
        ax.fill(*boundary(EXAMPLE, answer).T, color="0.55", zorder=0)
        draw_envelope(ax, EXAMPLE, answer, box)
        finish(ax, box)
    for name, (x, y) in zip("CBA", answer["vertices"]):
        axes[1].plot(x, y, "k.")
        axes[1].annotate(name, (x, y), (5, 5), textcoords="offset points")
    legend(axes[0], ("S+ of the envelope", dict(color=ORANGE, ls="--")), ("S- of the envelope", dict(color=BLUE)),
           ("tangents at t = 0 and where M changes its sign", dict(color=GREY, lw=0.7)),
           ("region of $d_2$: curvature < 0", dict(color="0.55", lw=6)),
           ("allowed by the lines of one S+ segment, of both", dict(color="0.8", lw=6)))
    axes[0].set_title("the envelope of all lines")
    axes[1].set_title(f"the region, area {answer['area']:.6g}")
    figure.tight_layout()
    save(figure, "region_envelope")


def curvature(line, t):
    _, d, dd = derivatives(line, np.array(line["points"], float), t, 2)
    return (d[:, 0] * dd[:, 1] - d[:, 1] * dd[:, 0]) / np.hypot(d[:, 0], d[:, 1]) ** 3


def draw_position(name, d, words):
    line = with_point(EXAMPLE, d)
    answer, = solve(line)
    t = np.linspace(0, 1, 2000)
    points, values = np.array(line["points"], float), curvature(line, t)
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.6))
    axes[0].fill(*boundary(line, answer).T, color="0.85", zorder=0)
    axes[0].plot(*points.T, "o-", color=GREY, lw=0.8, ms=3)
    axes[0].plot(*derivatives(line, points, t, 0)[0].T, color=BLUE)
    axes[0].plot(*d, "o", color=ORANGE, label=f"$d_2$ = {d}, {words}")
    axes[0].legend(fontsize=8, loc="upper right")
    finish(axes[0], (-14, 24, -2, 40))
    axes[1].axhline(0, color=GREY, lw=0.8)
    axes[1].plot(t, values, color=BLUE)
    axes[1].fill_between(t, 0, values, where=values > 0, color=ORANGE, alpha=0.5)
    axes[1].set_xlabel("t")
    axes[1].set_title("curvature", fontsize=10)
    axes[1].set_ylim(max(-2, values.min() * 1.05), max(0.1, min(2, values.max() * 1.1)))
    axes[1].grid(alpha=0.2)
    figure.tight_layout()
    save(figure, name)


def draw_region_points():
    points = np.array(SPLINE["points"], float)
    figure, axes = plt.subplots(figsize=(8, 5.4))
    for i, answer in enumerate(solve(SPLINE, "--all-points")):
        color = (HUES + [GREY])[i % 7]
        if answer["edges"]:
            outline = boundary(dict(SPLINE, free=i), answer)
            axes.fill(*outline.T, color=color, alpha=0.18, lw=0)
            axes.plot(*np.vstack([outline, outline[:1]]).T, color=color, lw=1)
        axes.plot(*points[i], "o", color=color)
        axes.annotate(f"$d_{i}$", points[i], (5, 5), textcoords="offset points")
    axes.plot(*points.T, color=GREY, lw=0.7, zorder=1)
    axes.plot(*derivatives(SPLINE, points, np.linspace(0, 1, 800), 0)[0].T, color="k", lw=1.6)
    finish(axes, (-5, 17, -3, 13))
    axes.set_title("where each control point alone may go: curvature stays negative", fontsize=10)
    figure.tight_layout()
    save(figure, "region_points")


def draw_region_zones():
    box, cells = (-9, 18, -9, 13), 500
    x, y = np.meshgrid(np.linspace(box[0], box[1], cells), np.linspace(box[2], box[3], cells))
    t = np.linspace(0, 1, 600)
    n, s = split(QUARTIC, t)
    changes = np.zeros(x.shape, int)
    last = None
    for k in range(len(t)):
        w, v = ([-s[j][k, 0], -s[j][k, 1], n[j][k]] for j in (1, 2))
        a, b, c = np.cross(w, v)
        now = a * x + b * y + c > 0
        changes += 0 if last is None else now != last
        last = now
    figure, axes = plt.subplots(figsize=(7, 5.6))
    colors = ListedColormap(["#f7f7f7", "#c6dbef", "#6baed6", "#2171b5", "#08306b"])
    image = axes.imshow(changes, origin="lower", extent=box, cmap=colors, vmin=-0.5, vmax=4.5, interpolation="nearest")
    figure.colorbar(image, ax=axes, ticks=range(5), label="inflections of the curve")
    for sign, style in ((-1, "-"), (1, "--")):
        answer, = solve(dict(QUARTIC, sign=sign))
        if answer["edges"]:
            outline = boundary(QUARTIC, answer)
            axes.plot(*np.vstack([outline, outline[:1]]).T, color=ORANGE, lw=1.6, ls=style,
                      label=f"region, curvature {'<' if sign < 0 else '>'} 0")
    fixed = np.delete(np.array(QUARTIC["points"]), QUARTIC["free"], axis=0)
    axes.plot(*fixed.T, "ko", ms=4, label="fixed control points")
    axes.legend(fontsize=8, loc="lower left")
    finish(axes, box)
    axes.grid(False)
    axes.set_title("a quartic with its middle control point anywhere", fontsize=10)
    figure.tight_layout()
    save(figure, "region_zones")


def draw_region_interval():
    figure, axes = plt.subplots(figsize=(7, 5.6))
    ends = ["1/10", "3/20", "1/5", "1/4", "3/10", "1"]
    shades = plt.get_cmap("viridis")(np.linspace(0.9, 0.1, len(ends)))
    for end, color in zip(ends, shades):
        line = dict(EXAMPLE, interval=["0", end])
        answer, = solve(line)
        outline = boundary(line, answer)
        if len(outline):
            axes.fill(*outline.T, color=color, alpha=0.35, lw=0)
            axes.plot(*np.vstack([outline, outline[:1]]).T, color=color, lw=1.3, label=f"[0, {end}]")
    finish(axes, (-30, 40, -5, 60))
    axes.legend(title="interval", fontsize=8)
    axes.set_title("the longer the interval the smaller the region", fontsize=10)
    figure.tight_layout()
    save(figure, "region_interval")


def main():
    plt.rcParams.update({"svg.hashsalt": "fatline", "svg.fonttype": "path", "font.size": 10, "mathtext.fontset": "cm"})
    if not PROGRAM.exists():
        sys.exit("region_figures: build/double/fatline-region is not built; run make")
    draw_region_envelope()
    draw_position("region_inside", INSIDE, "inside")
    draw_position("region_outside", OUTSIDE, "outside")
    draw_region_points()
    draw_region_zones()
    draw_region_interval()


if __name__ == "__main__":
    main()
