#!/usr/bin/env node
// The adapters of the JavaScript libraries, one process for all of them.  The requests and answers are those of
// program.h; NAME is one of the solvers below, or NAME_polished, which takes two Newton steps on each root.
// A request `version` names its solver: "NAME version".
'use strict';
const fs = require('fs');

const PIXELS = 512;  // a unit, for a library whose threshold is half a pixel
const NEWTON_STEPS = 2;
const NEWTON_LONGEST = 1 / 256;
const SAMPLES = 64;
const WARM = 4e8;  // nanoseconds

// ---- curves: arrays of points [x, y] ----

function pointAt(curve, t) {
    let p = curve.map(([x, y]) => [x, y]);
    const n = p.length - 1;
    for (let r = n; r > 1; r--)
        for (let i = 0; i < r; i++)
            p[i] = [p[i][0] + t * (p[i + 1][0] - p[i][0]), p[i][1] + t * (p[i + 1][1] - p[i][1])];
    const d = [p[1][0] - p[0][0], p[1][1] - p[0][1]];
    return {x: p[0][0] + t * d[0], y: p[0][1] + t * d[1], dx: n * d[0], dy: n * d[1]};
}

function newtonStep(f, g, root) {
    const p = pointAt(f, root[0]), q = pointAt(g, root[1]);
    const x = q.x - p.x, y = q.y - p.y, determinant = q.dx * p.dy - p.dx * q.dy;
    const dt = (q.dx * y - q.dy * x) / determinant, ds = (p.dx * y - p.dy * x) / determinant;
    if (!(Math.abs(dt) <= NEWTON_LONGEST && Math.abs(ds) <= NEWTON_LONGEST))
        return false;
    root[0] += dt;
    root[1] += ds;
    return true;
}

function polish(f, g, roots) {
    for (const root of roots)
        for (let k = 0; k < NEWTON_STEPS && newtonStep(f, g, root); k++);
}

// The parameter of the point of the curve nearest to p: the best of many, then Gauss and Newton's step.
function nearest(curve, p) {
    const distance = (t) => {
        const q = pointAt(curve, t);
        return (q.x - p.x) ** 2 + (q.y - p.y) ** 2;
    };
    let best = 0;
    for (let i = 1; i <= SAMPLES; i++)
        if (distance(i / SAMPLES) < distance(best))
            best = i / SAMPLES;
    for (let k = 0; k < 20; k++) {
        const q = pointAt(curve, best), square = q.dx * q.dx + q.dy * q.dy;
        const next = Math.min(1, Math.max(0, best - ((q.x - p.x) * q.dx + (q.y - p.y) * q.dy) / square));
        if (!(distance(next) < distance(best)))
            break;
        best = next;
    }
    return best;
}

function elevate(curve) {
    const n = curve.length - 1, out = [curve[0]];
    for (let i = 1; i <= n; i++)
        out.push([0, 1].map((k) => (i * curve[i - 1][k] + (n + 1 - i) * curve[i][k]) / (n + 1)));
    out.push(curve[n]);
    return out;
}

// ---- the libraries ----
// Each: the package, load() -> {takes(n, m), solve(f, g) -> anything, read(f, g, that) -> {roots, overlaps, coincident}}.
// Only solve is timed, which makes the library's own curves; reading what is said is not the library's work.

function loadPaper() {
    const paper = require('paper/dist/paper-core.js');
    paper.setup(new paper.Size(1, 1));
    const cubic = (c) => {
        while (c.length < 4)
            c = elevate(c);
        return new paper.Curve(...c.flat());
    };
    return {
        takes: (n, m) => n <= 3 && m <= 3,
        solve: (f, g) => cubic(f).getIntersections(cubic(g)),
        read(f, g, found) {
            const ends = found.filter((l) => l.hasOverlap()).map((l) => [l.time, l.intersection.time]);
            const roots = found.filter((l) => !l.hasOverlap()).map((l) => [l.time, l.intersection.time]);
            if (ends.length !== 2)
                return {roots: roots.concat(ends), overlaps: [], coincident: 0};
            ends.sort((a, b) => a[0] - b[0]);
            return {roots, overlaps: [[ends[0][0], ends[1][0], ends[0][1], ends[1][1]]], coincident: 0};
        },
    };
}

function loadFlo() {
    const flo = require('flo-bezier3');
    return {
        takes: (n, m) => n <= 3 && m <= 3,
        solve(f, g) {
            const ofG = flo.bezierBezierIntersectionImplicit(f, g);
            return ofG && ofG.length ? flo.getOtherTs(f, g, ofG) : ofG;
        },
        read(f, g, found) {
            if (!found)
                return {roots: [], overlaps: [], coincident: 1};
            const middle = (x) => (x.ri.tS + x.ri.tE) / 2;
            return {roots: found.filter((p) => p).map((p) => [middle(p[0]), middle(p[1])]), overlaps: [], coincident: 0};
        },
    };
}

function loadKld() {
    const {Intersection, Point2D} = require('kld-intersections');
    const points = (c) => c.map((p) => new Point2D(p[0], p[1]));
    return {
        takes: (n, m) => n >= 2 && n <= 3 && m >= 2 && m <= 3,
        solve(f, g) {
            const first = f.length <= g.length ? f : g, second = first === f ? g : f;
            const name = `intersectBezier${first.length - 1}Bezier${second.length - 1}`;
            return Intersection[name](...points(first), ...points(second)).points;
        },
        read: (f, g, found) => ({roots: found.map((p) => [nearest(f, p), nearest(g, p)]), overlaps: [], coincident: 0}),
    };
}

function loadBezierJs() {
    const {Bezier} = require('bezier-js');
    const pixels = (c) => c.flat().map((x) => PIXELS * x);
    return {
        takes: (n, m) => n >= 2 && n <= 3 && m >= 2 && m <= 3,
        solve: (f, g) => new Bezier(pixels(f)).intersects(new Bezier(pixels(g))),
        read: (f, g, found) => ({roots: found.map((pair) => pair.split('/').map(Number)), overlaps: [], coincident: 0}),
    };
}

const libraries = {
    paper: {module: 'paper', load: loadPaper},
    flo_bezier3: {module: 'flo-bezier3', load: loadFlo},
    kld_intersections: {module: 'kld-intersections', load: loadKld},
    bezier_js: {module: 'bezier-js', load: loadBezierJs},
};

// ---- solvers ----

const solvers = {};

function solver(name) {
    if (!solvers[name]) {
        const polished = name.endsWith('_polished');
        const library = libraries[name.replace(/_polished$/, '')];
        if (!library)
            throw new Error(`no solver ${name}`);
        solvers[name] = {...library.load(), polished, set: []};
    }
    return solvers[name];
}

function answer(s, [f, g]) {
    const said = s.read(f, g, s.solve(f, g));
    if (s.polished)
        polish(f, g, said.roots);
    return said;
}

// What is timed.
function work(s, [f, g]) {
    const found = s.solve(f, g);
    if (!s.polished)
        return found;
    const said = s.read(f, g, found);
    polish(f, g, said.roots);
    return said.roots;
}

function readPair(numbers) {
    let at = 0;
    const curve = () => {
        const degree = numbers[at++], rational = numbers[at++], points = [];
        for (let i = 0; i <= degree; i++, at += rational ? 3 : 2)
            points.push([numbers[at], numbers[at + 1]]);
        points.rational = rational;
        return points;
    };
    return [curve(), curve()];
}

function isTaken(s, [f, g]) {
    return !f.rational && !g.rational && s.takes(f.length - 1, g.length - 1);
}

function say(s, pair) {
    if (!isTaken(s, pair))
        return 'refused';
    let said;
    try {
        said = answer(s, pair);
    } catch (reason) {
        return 'failed';
    }
    const kept = said.roots.slice(0, 1024);
    return ['solved', said.coincident, said.roots.length, ...kept.flat(), said.overlaps.length,
            ...said.overlaps.flat()].join(' ');
}

let sink;

function pass(s) {
    for (const pair of s.set)
        sink = work(s, pair);
}

// CPU nanoseconds of the whole process, the compiler and the collector included.
function cpu() {
    const {user, system} = process.cpuUsage();
    return 1000 * (user + system);
}

// Until the compiler has seen enough of it.
function warm(s) {
    const start = cpu();
    while (cpu() - start < WARM)
        pass(s);
    s.warm = true;
}

function time(s, passes) {
    if (!s.warm)
        warm(s);
    const start = cpu();
    for (let k = 0; k < passes; k++)
        pass(s);
    return String(cpu() - start);
}

function each(s, passes) {
    const least = s.set.map(() => Infinity);
    for (let k = 0; k < passes; k++)
        s.set.forEach((pair, i) => {
            const start = process.hrtime.bigint();
            sink = work(s, pair);
            least[i] = Math.min(least[i], Number(process.hrtime.bigint() - start));
        });
    return least.join(' ');
}

function version(name) {
    const library = libraries[name.replace(/_polished$/, '')];
    return JSON.parse(fs.readFileSync(`${__dirname}/node_modules/${library.module}/package.json`)).version;
}

function reply(line) {
    const [name, command, ...rest] = line.split(' ');
    if (command === 'version')
        return version(name);
    const s = solver(name);
    switch (command) {
    case 'solve':
        return say(s, readPair(rest.map(Number)));
    case 'collect': {
        const pair = readPair(rest.map(Number));
        if (!isTaken(s, pair))
            return 'error refused';
        s.set.push(pair);
        return 'ok';
    }
    case 'clear':
        s.set = [];
        s.warm = false;
        return 'ok';
    case 'time':
        return time(s, Number(rest[0]));
    case 'each':
        return each(s, Number(rest[0]));
    default:
        return 'error not a request';
    }
}

function main() {
    const write = (text) => {
        for (let sent = 0; sent < text.length;) {
            sent += fs.writeSync(1, text.slice(sent));
        }
    };
    console.log = () => {};
    const chunk = Buffer.alloc(1 << 16);
    let text = '';
    for (;;) {
        const n = fs.readSync(0, chunk);
        if (n === 0)
            return;
        text += chunk.toString('latin1', 0, n);
        for (let end; (end = text.indexOf('\n')) >= 0; text = text.slice(end + 1)) {
            let said;
            try {
                said = reply(text.slice(0, end));
            } catch (reason) {
                said = `error ${String(reason).split('\n')[0]}`;
            }
            write(said + '\n');
        }
    }
}

main();
