#!/usr/bin/python3
"""The library as somebody else meets it: installed, described, compiled against, run, removed.  Prints TAP.

What README.md says to type is typed, with another $HOME."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap
from pathlib import Path

from runner import ROOT, run_tests

HEADER = ROOT / "algorithms/fatline.h"
# All that the library may ask of others: these functions of libc and libm, and of libgcc what it knows of the processor, and
# how it counts bits.  None allocates, prints or keeps a state.
MAY_CALL = {"_GLOBAL_OFFSET_TABLE_", "__cpu_model", "__popcountdi2", "memcpy", "memmove", "memset", "memcmp", "strcmp", "frexp", "ldexp", "sqrt", "atan2",
            "tan", "sin", "cos", "fabs", "fma", "fmax", "fmin", "cbrt", "acos", "exp2", "log2", "pow", "floor", "ceil"}
COMPILERS = {"gcc": ["gcc"], "clang": ["clang"], "g++": ["g++", "-x", "c++"], "clang++": ["clang++", "-x", "c++"]}
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]


def run(*command, cwd=ROOT, env=None, status=0):
    outer = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    ended = subprocess.run([str(c) for c in command], cwd=cwd, env={**outer, **(env or {})}, capture_output=True,
                           text=True, timeout=300)
    assert ended.returncode == status, f"{command}: status {ended.returncode}: {ended.stdout[-500:]}{ended.stderr[-1500:]}"
    return ended.stdout


def section(title="The library"):
    text = (ROOT / "README.md").read_text()
    return re.search(rf"^## {title}$(.*?)^## ", text, flags=re.M | re.S).group(1)


def example(title="The library"):
    return re.search(r"^```c\n(.*?)^```$", section(title), flags=re.M | re.S).group(1)


def indented():
    """The indented blocks of the section: how to install, how to compile, what is printed."""
    prose = re.sub(r"^```c\n.*?^```$", "", section(), flags=re.M | re.S)
    blocks = re.findall(r"(?:^    .*\n)+", prose, flags=re.M)
    return [re.sub(r"^    ", "", block, flags=re.M) for block in blocks]


def declared():
    text = re.sub(r"/\*.*?\*/", "", HEADER.read_text(), flags=re.S)
    return sorted(set(re.findall(r"^FATLINE_API [^;(]*?\b(fatline_\w+)\(", text, flags=re.M)))


def version():
    return re.search(r'define FATLINE_VERSION "(.*)"', HEADER.read_text()).group(1)


def what_readme_says(home):
    """Installs into $HOME/.local, compiles and runs the example, all word for word."""
    install, compile_and_run, printed = indented()
    (home / "example.c").write_text(example())
    run("sh", "-ec", install, env={"HOME": home, "DESTDIR": ""})
    shown = run("sh", "-ec", compile_and_run, cwd=home, env={"HOME": home})
    assert shown == printed, shown


# A star of five straight cubics crosses itself in five points.
STAR = """#include <fatline.h>
#include <stdio.h>
#include <stdlib.h>
int main(void)
{
    static const double x[] = {0, 12, -19, 19, -12, 0}, y[] = {20, -16, 6, 6, -16, 20};
    static double points[8 * 5];
    int count = 5;
    for (int i = 0; i < 8 * 5; i++) {
        const double *c = i % 2 ? y : x;
        points[i] = c[i / 8] + (c[i / 8 + 1] - c[i / 8]) * (i % 8 / 2) / 3;
    }
    @example@
    printf("%d records\\n", a.count);
    for (int i = 0; i < a.count; i++)
        printf("%d %d %s\\n", a.crossing[i].a.first, a.crossing[i].b.first, fatline_standing_text(a.crossing[i].standing));
}
"""
STAR_RECORDS = "5 records\n0 2 unique\n0 3 unique\n1 3 unique\n1 4 unique\n2 4 unique\n"


def paths_of_readme(home):
    """The lines of the section on paths, in a program: with points of five cubics."""
    prefix = home / ".local"
    (home / "star.c").write_text(STAR.replace("    @example@\n", textwrap.indent(example("Paths"), "    ")))
    run("gcc", *STRICT, f"-I{prefix}/include", home / "star.c", prefix / "lib/libfatline.a", "-lm", "-o", home / "star")
    assert run(home / "star") == STAR_RECORDS, run(home / "star")


def files_and_removal(home):
    """With DESTDIR: just these files, no path of the stage in any; and none left after uninstall."""
    stage = home / "stage"
    places = ["DESTDIR=" + str(stage), "PREFIX=/opt/f"]
    run("make", "install", *places)
    found = {str(p.relative_to(stage / "opt/f")) for p in stage.rglob("*") if not p.is_dir()}
    assert found == {"include/fatline.h", "lib/libfatline.a", f"lib/libfatline.so.{version()}", "lib/libfatline.so.0",
                     "lib/libfatline.so", "lib/pkgconfig/fatline.pc", "share/man/man3/fatline.3"}, found
    package = (stage / "opt/f/lib/pkgconfig/fatline.pc").read_text()
    assert str(stage) not in package and f"Version: {version()}" in package and "prefix=/opt/f" in package, package
    run("make", "uninstall", *places)
    assert not [p for p in stage.rglob("*") if not p.is_dir()]


def every_compiler(home):
    """The header alone, in the oldest C and C++ it promises; the example, shared and static."""
    prefix = home / ".local"
    environment = {"PKG_CONFIG_PATH": str(prefix / "lib/pkgconfig"), "LD_LIBRARY_PATH": str(prefix / "lib")}
    (home / "alone.c").write_text("#include <fatline.h>\nint main(void) { return fatline_version()[0] == 'x'; }\n")
    tried = 0
    for name, command in COMPILERS.items():
        if not shutil.which(name):
            continue
        tried += 1
        flags = run("pkg-config", "--cflags", "fatline", env=environment).split()
        shared = run("pkg-config", "--libs", "fatline", env=environment).split()
        static = run("pkg-config", "--static", "--libs", "fatline", env=environment).split()
        standard = "-std=c++11" if "++" in name else "-std=c99"
        run(*command, standard, *STRICT, *flags, "-c", home / "alone.c", "-o", home / "alone.o")
        for libraries in (shared, ["-static", *static], [str(prefix / "lib/libfatline.a"), "-lm"]):
            language = ["-x", "none"] if "++" in name else []
            run(*command, *STRICT, *flags, home / "example.c", *language, *libraries, "-o", home / "out")
            assert run(home / "out", env=environment) == indented()[2], (name, libraries)
    assert tried > 0


def complaints(defined, undefined):
    """What is wrong with an object that defines and asks for these names."""
    return [name for name in defined if name not in declared()] + [name for name in undefined if name not in MAY_CALL]


def symbols(*nm):
    return [line.split()[-1].split("@")[0] for line in run("nm", *nm).splitlines() if line and not line.endswith(":")]


def names(home):
    """Nothing is exported but the header's functions, nothing is asked for but harmless ones, nothing is writable."""
    library = home / ".local/lib"
    shared = library / f"libfatline.so.{version()}"
    assert symbols("-D", "--defined-only", shared) == declared()
    archive = library / "libfatline.a"
    external = symbols("--defined-only", "--extern-only", archive)
    wanted = symbols("-u", archive)
    assert external == declared() and complaints(external, wanted) == [], complaints(external, wanted)
    dynamic = run("readelf", "-d", shared)
    needed = re.findall(r"NEEDED.*\[(.*)\]", dynamic)
    assert set(needed) <= {"libm.so.6", "libc.so.6"} and "[libfatline.so.0]" in dynamic, dynamic
    sections = run("readelf", "-SW", ROOT / "build/library/fatline.o")
    writable = re.findall(r"\] (\.t?(?:data|bss)\S*)\s+\S+\s+\S+\s+\S+\s+(\S+)", sections)
    assert writable, sections
    for name, size in writable:
        assert name.startswith(".data.rel.ro") or int(size, 16) == 0, f"{name} holds 0x{size} bytes: global state"


def names_control(home):
    """Negative control: objects of the project that are not of the library are complained about."""
    objects = ROOT / "build/double/libharness.a"
    if not objects.exists():
        return "build/double/libharness.a is not built"
    found = complaints(symbols("--defined-only", "--extern-only", objects), symbols("-u", objects))
    assert "malloc" in found and "answer_write" in found, found


def manual(home):
    """The pages are clean, name every function, and show the example of README.md."""
    page = (ROOT / "algorithms/library/fatline.3").read_text()
    missing = [name for name in declared() if f".Nm {name}" not in page or f"{name} " not in page]
    assert not missing, missing
    shown = re.search(r"^\.Bd -literal\n(#include.*?)^\.Ed$", page, flags=re.M | re.S).group(1)
    assert shown.replace("\\e", "\\") == example()
    assert indented()[2] in page
    pages = ["algorithms/library/fatline.3", "harness/fatline.1"]
    if shutil.which("mandoc"):
        assert run("mandoc", "-T", "lint", "-W", "warning", *pages) == ""
    elif shutil.which("groff"):
        ended = subprocess.run(["groff", "-mandoc", "-ww", "-z", *pages], cwd=ROOT, capture_output=True, text=True)
        assert ended.returncode == 0 and ended.stderr == "", ended.stderr
    else:
        return "neither mandoc nor groff is installed"


def commands(home):
    """`make install-commands`: the command runs from its place."""
    stage = home / "commands"
    if " -c " in run("make", "-n", "install-commands", f"PREFIX={stage}", "DESTDIR="):
        return "not all programs are built"
    run("make", "install-commands", f"PREFIX={stage}", "DESTDIR=")
    shown = run(stage / "bin/fatline", "--precision", "quad", "solve", "-f", "0,0 1,1", "-g", "0,1 1,0")
    assert '"SOLVED"' in shown, shown
    assert (stage / "share/man/man1/fatline.1").exists()
    run("make", "uninstall", f"PREFIX={stage}", "DESTDIR=")
    assert not [p for p in stage.rglob("*") if not p.is_dir()]


def main():
    tests = [what_readme_says, paths_of_readme, files_and_removal, every_compiler, names, names_control, manual, commands]
    with tempfile.TemporaryDirectory() as folder:
        run_tests([(test.__name__, lambda test=test: test(Path(folder))) for test in tests])


if __name__ == "__main__":
    main()
