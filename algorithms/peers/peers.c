/* The table of the peers: other people's libraries as intersectors.  What is polished takes two Newton steps
 * on each root, where the library's own accuracy stops early; as they are, their answers stand under the
 * plain name. */
#include "foreign.h"
#include "foreign_answer.h"

#define PEER_ENTRY(name, solver, what, authors, call, kind, file, licence, needs, polished)                  \
    static const struct foreign name##_foreign = {&kind, file, solver, licence, needs, polished};            \
    const struct intersector name = {#name, what, authors, {0, 0, 0, 0},   call,                             \
                                     NULL,  true, true,    &name##_foreign};

/* Of a shared object, and of a program over a pipe. */
#define SHARED(name, what, authors, file, licence, needs, polished)                                          \
    PEER_ENTRY(name, NULL, what, authors, foreign_intersect, foreign_shared_object, file, licence, needs,    \
               polished)
#define PROGRAM(name, what, authors, file, licence, needs, polished)                                         \
    PEER_ENTRY(name, #name, what, authors, foreign_program_intersect, foreign_program, file, licence, needs, \
               polished)

#define POLISHED ", then two Newton steps"

static const char lyon[] = "N. Silva and others: lyon_geom",
                  lyon_needs[] = "librust-lyon-geom-dev, cargo and rustc";
SHARED(lyon_geom, "Rust, cubics: clipping", lyon, "lyon_geom.so", "MIT OR Apache-2.0", lyon_needs, false)
SHARED(lyon_geom_polished, "Rust, cubics: clipping" POLISHED, lyon, "lyon_geom.so", "MIT OR Apache-2.0",
       lyon_needs, true)

static const char inkscape[] = "M. Mendez, N. Hurst, M. Cecchetti and others: lib2geom";
SHARED(lib2geom, "C++: Bezier clipping", inkscape, "lib2geom.so", "LGPL-2.1-only OR MPL-1.1", "lib2geom-dev",
       false)
SHARED(lib2geom_polished, "C++: Bezier clipping" POLISHED, inkscape, "lib2geom.so",
       "LGPL-2.1-only OR MPL-1.1", "lib2geom-dev", true)

SHARED(open_cascade, "C++: polygons, then iteration", "Open CASCADE Technology, Geom2dAPI_InterCurveCurve",
       "open_cascade.so", "LGPL-2.1-only WITH OCCT-exception-1.0",
       "libocct-modeling-algorithms-dev, libocct-modeling-data-dev and libocct-foundation-dev", false)

static const char sintef[] = "SINTEF: SISL, s1857";
PROGRAM(sisl, "C: subdivision and iteration", sintef, "sisl", "AGPL-3.0-only", "libsisl-dev", false)
PROGRAM(sisl_polished, "C: subdivision and iteration" POLISHED, sintef, "sisl", "AGPL-3.0-only",
        "libsisl-dev", true)

PROGRAM(cgal, "C++: exact, algebraic numbers", "I. Hanniel, R. Wein: CGAL, Arr_Bezier_curve_traits_2", "cgal",
        "GPL-3.0-or-later", "libcgal-dev", false)

static const char script[] = "javascript.js", node[] = "nodejs and npm (make peers fetches the package)";
static const char lehni[] = "J. Lehni, J. Puckey and others: paper.js";
PROGRAM(paper, "JavaScript, up to cubics: fat line clipping", lehni, script, "MIT", node, false)
PROGRAM(paper_polished, "JavaScript, up to cubics: fat line clipping" POLISHED, lehni, script, "MIT", node,
        true)

PROGRAM(flo_bezier3, "JavaScript, up to cubics: exact implicitization", "F. Steyn: flo-bezier3", script,
        "MIT", node, false)

static const char lindsey[] = "K. Lindsey: kld-intersections";
PROGRAM(kld_intersections, "JavaScript, degrees 2 and 3: resultant; points only", lindsey, script,
        "BSD-3-Clause", node, false)
PROGRAM(kld_intersections_polished, "JavaScript, degrees 2 and 3: resultant" POLISHED, lindsey, script,
        "BSD-3-Clause", node, true)

static const char pomax[] = "M. Kamermans: Bezier.js";
PROGRAM(bezier_js, "JavaScript, degrees 2 and 3: subdivision", pomax, script, "MIT", node, false)
PROGRAM(bezier_js_polished, "JavaScript, degrees 2 and 3: subdivision" POLISHED, pomax, script, "MIT", node,
        true)
