#!/usr/bin/python3
"""The layers of CONTRIBUTING.md, "Who may include whom", and the format of the sources.  Prints TAP."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCES = sorted(p.relative_to(ROOT) for folder in ("algorithms", "harness", "tests")
                 for p in (ROOT / folder).rglob("*") if p.suffix in (".c", ".h", ".hpp", ".cc"))
PURE = [p for p in SOURCES if p.parts[0] == "algorithms" and "peers" not in p.parts]

CLANG_FORMAT = 14  # Debian 12's

SYSTEM_HEADERS = {"float.h", "immintrin.h", "limits.h", "math.h", "quadmath.h", "stdbool.h", "stddef.h", "stdint.h", "string.h"}
SYSTEM_HEADERS_OF = {"algorithms/core/real_multi.hpp": {"mpfr.h", "gmp.h", "cmath", "cstddef", "cstdint", "cstring",
                                                        "cfloat", "climits", "compare", "concepts", "type_traits"}}
FORBIDDEN_CALLS = re.compile(r"\b(malloc|calloc|realloc|free|alloca|aligned_alloc|printf|fprintf|puts|fopen|fwrite"
                             r"|abort|exit|time|clock|clock_gettime|getenv|rand|random)\s*\(")
# What each folder of algorithms/ may include, as folders and files of algorithms/.
MAY_INCLUDE = {
    "core": ("core/",),
    "intersect": ("core/", "bezier.h", "batch.h", "crossings.h"),
    "curvature": ("core/", "curvature/", "bezier.h", "region.h", "list.h"),
    "library": ("core/", "library/", "bezier.h", "batch.h", "path.h", "region.h", "fatline.h"),
    "paths": ("core/", "paths/", "bezier.h", "batch.h", "path.h"),
    "": ("core/", "bezier.h", "batch.h", "region.h", "list.h", "crossings.h"),
}
# The loop of the cell algorithms belongs to core/ though it speaks of problems and crossings.
MAY_INCLUDE_OF = {"algorithms/core/cells." + suffix: ("core/", "bezier.h", "crossings.h") for suffix in "ch"}


def code(path):
    """The text without comments; strings emptied."""
    text = re.sub(r"/\*.*?\*/", lambda m: "\n" * m.group().count("\n"), (ROOT / path).read_text(), flags=re.S)
    return re.sub(r"//.*", "", text)


def includes(path, form):
    return re.findall(r'^\s*#\s*include\s*' + form, code(path), flags=re.M)


def system_headers():
    for path in PURE:
        allowed = SYSTEM_HEADERS | SYSTEM_HEADERS_OF.get(str(path), set())
        for header in includes(path, r"<([^>]+)>"):
            if header not in allowed:
                yield f"{path}: includes <{header}>; algorithms/ may include {', '.join(sorted(allowed))}"


def calls():
    for path in PURE:
        for number, line in enumerate(code(path).split("\n"), 1):
            match = FORBIDDEN_CALLS.search(re.sub(r'"(\\.|[^"\\])*"', '""', line))
            if match:
                yield f"{path}:{number}: calls {match.group(1)}; algorithms/ neither allocate nor do input or output"


def layers():
    top = ROOT / "algorithms"
    for path in PURE:
        folder = path.parts[1] if len(path.parts) > 2 else ""
        allowed = MAY_INCLUDE_OF.get(str(path), MAY_INCLUDE[folder])
        if len(path.parts) > 3:  # an algorithm of several files
            allowed += ("/".join(path.parts[1:-1]) + "/",)
        for header in includes(path, r'"([^"]+)"'):
            target = (ROOT / path.parent / header).resolve()
            inside = str(target.relative_to(top)) if target.is_relative_to(top) else str(target)
            own = target.parent == (ROOT / path).parent and target.stem == path.stem
            if not own and not any(inside == a or (a.endswith("/") and inside.startswith(a)) for a in allowed):
                yield f"{path}: includes {inside}; its layer may include {', '.join(allowed)}"


def no_source_included():
    for path in SOURCES:
        for header in includes(path, r'["<]([^">]+)[">]'):
            if header.endswith(".c"):
                yield f"{path}: includes the source {header}"


def harness_knows_no_algorithm():
    names = re.findall(r"^\s*INTERSECTOR\((\w+)\)", (ROOT / "algorithms/list.h").read_text(), flags=re.M)
    if not names:
        yield "algorithms/list.h: no INTERSECTOR(name) found"
    for path in SOURCES:
        if path.parts[0] == "harness" and "region" not in str(path):  # the word, of regions, is another
            for name in names:
                if f'"{name}"' in code(path):
                    yield f'{path}: knows "{name}" by name'


def clang_format():
    if not shutil.which("clang-format"):
        return "clang-format is not installed"
    version = subprocess.run(["clang-format", "--version"], capture_output=True, text=True).stdout
    if f" {CLANG_FORMAT}." not in version:
        return f"each version writes something else, and this is not {CLANG_FORMAT}: {version.strip()}"
    done = subprocess.run(["clang-format", "--dry-run", *map(str, SOURCES)], cwd=ROOT, capture_output=True, text=True)
    return sorted({line.split(":")[0] + ": not as clang-format writes it (make format)"
                   for line in done.stderr.splitlines() if "[-Wclang-format-violations]" in line})


def main():
    checks = [system_headers, calls, layers, no_source_included, harness_knows_no_algorithm, clang_format]
    failed = 0
    for number, check in enumerate(checks, 1):
        complaints = check()
        if isinstance(complaints, str):
            print(f"ok {number} - {check.__name__} # SKIP {complaints}")
            continue
        complaints = list(complaints)
        print(f"{'not ok' if complaints else 'ok'} {number} - {check.__name__}")
        for complaint in complaints:
            print("# " + complaint)
        failed += bool(complaints)
    print(f"1..{len(checks)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
