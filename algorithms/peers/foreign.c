/* Adapters in this process: shared objects that are opened when they are first asked for (peer.h). */
#include "foreign.h"

#include <dlfcn.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "foreign_answer.h"
#include "foreign_files.h"
#include "newton.h"

enum { LIBRARIES = 8 };

struct library {
    const char *file; /* NULL: none */
    enum peer_outcome (*intersect)(const struct peer_curve *, const struct peer_curve *, struct peer_roots *);
    const char *(*version)(void);
    char absent[PATH_MAX + 512];
};

static struct library libraries[LIBRARIES];

static void open_library(const struct foreign *x, struct library *l)
{
    char path[PATH_MAX];
    void *handle = NULL;

    l->file = x->file;
    if (!foreign_path(x->file, path)) {
        snprintf(l->absent, sizeof l->absent, "not built; it needs %s", x->needs);
        return;
    }
    handle = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (handle) {
        *(void **)&l->intersect = dlsym(handle, "peer_intersect");
        *(void **)&l->version = dlsym(handle, "peer_version");
    }
    if (!l->intersect || !l->version) {
        snprintf(l->absent, sizeof l->absent, "cannot be loaded: %s", dlerror());
    }
}

/* Each file is opened once, found or not. */
static const struct library *library_of(const struct foreign *x)
{
    struct library *l = libraries;
    while (l->file && strcmp(l->file, x->file)) {
        l++;
    }
    if (!l->file) {
        open_library(x, l);
    }
    return l;
}

static const char *absent(const struct foreign *x)
{
    const struct library *l = library_of(x);
    return l->absent[0] ? l->absent : NULL;
}

static const char *version(const struct foreign *x)
{
    return absent(x) ? NULL : library_of(x)->version();
}

enum outcome foreign_intersect(const struct problem *p, struct workspace *w, struct crossings *out)
{
    const struct foreign *x = w->plan->foreign;
    const struct library *l = library_of(x);
    double number[2][3 * DEGREE_MAX + 3];
    struct peer_curve f, g;
    struct peer_roots roots;

    if (l->absent[0]) {
        return UNSUPPORTED;
    }
    foreign_curve(&p->f, number[0], &f);
    foreign_curve(&p->g, number[1], &g);
    roots.count = roots.overlaps = roots.coincident = 0;
    enum peer_outcome outcome = l->intersect(&f, &g, &roots);
    if (x->polished && outcome == PEER_SOLVED) {
        newton_polish(&f, &g, &roots);
    }
    return foreign_answer(p, outcome, &roots, out);
}

const struct foreign_kind foreign_shared_object = {true, version, absent, NULL, NULL, NULL, NULL, NULL};
