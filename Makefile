# Every command there is; `make help` lists them.
#
# One source tree, three precisions: build/double, build/quad and build/multi hold objects and programs of one
# precision each; build/P/watched holds the same algorithms with their observers compiled in; build/common
# holds what does not depend on the precision.

CC       = gcc
CXX      = g++
PYTHON   = /usr/bin/python3
WARN     = -Wall -Wextra -Wno-missing-field-initializers
OPT      = -O2
FP       = -ffp-contract=off
CFLAGS   = -std=c11 -D_GNU_SOURCE $(OPT) $(FP) $(WARN) -g -MMD -MP
CXXFLAGS = -std=c++20 -x c++ $(OPT) $(FP) $(WARN) -Wno-sign-compare -g -MMD -MP
FLINT_INCLUDE = -I/usr/include/flint
PRECISIONS = double quad multi

.DEFAULT_GOAL := all
.SECONDARY:
.DELETE_ON_ERROR:

# ---- what is built from what ---------------------------------------------------------------------------------

COMMON_MODULES = case case_fields case_expected number random json_text selection memory options interrupt row progress resume \
                 standard_output path_file path_xml \
                 exact exact_poly exact_roots exact_system exact_multiplicity exact_resultant exact_isolation \
                 exact_algebraic exact_component exact_meeting exact_ends exact_overlap exact_facts exact_parameter \
                 exact_answer exact_apart truth_compare known_solutions \
                 referee referee_truth referee_place referee_pair referee_krawczyk referee_cells \
                 statistics noise regression order_estimate close_up cost_law \
                 region_case region_random
REAL_MODULES   = real_text problem place case_set algorithms_named guard external solving solve_options \
                 judge judge_points judge_strict decide judge_groups judge_curves judge_overlaps answer answer_table \
                 check_options check_case check_table check_estimate check_worker \
                 clock instructions time_worker contestant compare_builds compare_files timing batch_set \
                 timing_work timing_rows time_family time_options \
                 planted_roots measuring path order_measure lemma_reduction lemma_cut \
                 region_problem region_answer region_check region_check_expected region_check_sample \
                 region_check_agree region_sample region_options region_time \
                 path_set path_random path_svg path_arc path_read path_write path_job path_rows path_options path_boxes \
                 path_timing

ALGORITHMS       := $(wildcard algorithms/*.c algorithms/core/*.c algorithms/intersect/*.c algorithms/intersect/*/*.c algorithms/curvature/*.c algorithms/paths/*.c)
ALGORITHMS_double := $(ALGORITHMS) $(wildcard algorithms/peers/*.c)
ALGORITHMS_quad  := $(ALGORITHMS)
ALGORITHMS_multi := $(ALGORITHMS)

# Programs that work with reals are built for each precision; the others once, in build/double.
PROGRAMS_REAL = list solve check time repeat doctor compare passes roots region paths
PROGRAMS_ONCE = generate truth
# These watch the algorithms at work.
PROGRAMS_WATCHED = trace order cost lemma
GENERATE_MODULES = draft draft_facts draft_contact family family_parts family_local family_write family_random \
                   family_crossing family_scale family_many family_contact family_degenerate family_overlap \
                   family_circle family_adverse outline glyphs

LIBS_double = -llapacke -llapack -lblas
LIBS_quad   = -lquadmath
LIBS_multi  =
LIBS        = -lflint-arb -lflint -lmpfr -lgmp -ljansson -lquadmath -lm
FREETYPE_CFLAGS := $(shell pkg-config --cflags freetype2 fontconfig 2>/dev/null)
FREETYPE_LIBS   = -lfontconfig -lfreetype

# ---- rules per precision -------------------------------------------------------------------------------------

COMPILE_double = $(CC) $(CFLAGS)
COMPILE_quad   = $(CC) $(CFLAGS) -DFATLINE_QUAD
COMPILE_multi  = $(CXX) $(CXXFLAGS) -DFATLINE_MULTI
LINK_double = $(CC)
LINK_quad   = $(CC)
LINK_multi  = $(CXX)

# A module of the harness is named without its folder.
module_objects = $(patsubst %.c,build/$(1)/%.o,$(foreach M,$(2),$(wildcard harness/*/$(M).c)))
common_objects := $(call module_objects,common,$(COMMON_MODULES))
algorithm_objects = $(patsubst %.c,build/$(1)/%.o,$(ALGORITHMS_$(1)))
watched_objects   = $(patsubst %.c,build/$(1)/watched/%.o,$(ALGORITHMS_$(1)))
real_objects      = $(call module_objects,$(1),$(REAL_MODULES))

build/common/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(FLINT_INCLUDE) $(FREETYPE_CFLAGS) -DBUILD_FLAGS='"$(CFLAGS)"' -DBUILD_FLAGS_MULTI='"$(CXXFLAGS)"' -c $< -o $@

define precision_rules
build/$(1)/watched/%.o: %.c
	@mkdir -p $$(@D)
	$$(COMPILE_$(1)) -DFATLINE_WATCHED -c $$< -o $$@
build/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$$(COMPILE_$(1)) -c $$< -o $$@
build/$(1)/libalgorithms.a: $(call algorithm_objects,$(1))
	@rm -f $$@
	ar rcs $$@ $$^
build/$(1)/libwatched.a: $(call watched_objects,$(1))
	@rm -f $$@
	ar rcs $$@ $$^
build/$(1)/libharness.a: $(call real_objects,$(1)) $(common_objects)
	@rm -f $$@
	ar rcs $$@ $$^
$(PROGRAMS_REAL:%=build/$(1)/fatline-%): build/$(1)/fatline-%: build/$(1)/harness/%.o build/$(1)/libharness.a build/$(1)/libalgorithms.a
	$$(LINK_$(1)) -o $$@ $$^ $$(LIBS_$(1)) $$(LIBS)
$(PROGRAMS_WATCHED:%=build/$(1)/fatline-%): build/$(1)/fatline-%: build/$(1)/harness/%.o build/$(1)/libharness.a build/$(1)/libwatched.a
	$$(LINK_$(1)) -o $$@ $$^ $$(LIBS_$(1)) $$(LIBS)
endef
$(foreach P,$(PRECISIONS),$(eval $(call precision_rules,$(P))))

common_library = build/common/libcommon.a
$(common_library): $(common_objects)
	@rm -f $@
	ar rcs $@ $^
build/double/fatline-generate: $(call module_objects,common,$(GENERATE_MODULES))
build/double/fatline-generate: LIBS += $(FREETYPE_LIBS)
$(PROGRAMS_ONCE:%=build/double/fatline-%): build/double/fatline-%: build/common/harness/%.o $(common_library)
	@mkdir -p $(@D)
	$(CC) -o $@ $(filter %.o,$^) $(filter %.a,$^) $(LIBS)
# Measures beside lib2geom where lib2geom-dev is installed: see scripts/against_lib2geom.
build/double/against_lib2geom: scripts/against_lib2geom.cc build/double/libharness.a build/double/libalgorithms.a
	$(CXX) -std=c++17 $(OPT) $(FP) $(WARN) $(patsubst -I%,-isystem %,$(shell pkg-config --cflags 2geom)) \
	    -o $@ $^ $(shell pkg-config --libs 2geom) $(LIBS_double) $(LIBS)
build/fatline: build/common/harness/fatline.o build/common/harness/run/standard_output.o
	$(CC) -o $@ $^

programs = build/fatline $(PROGRAMS_ONCE:%=build/double/fatline-%) \
           $(foreach P,$(PRECISIONS),$(patsubst %,build/$(P)/fatline-%,$(PROGRAMS_REAL) $(PROGRAMS_WATCHED)))

include algorithms/library/library.mk

# ---- tests ---------------------------------------------------------------------------------------------------

# tests/test_X.c is built for each precision, those named here in double only.
TESTS_ONCE = test_case test_case_mistakes test_random test_row test_order test_close_up test_statistics test_clock \
             test_referee test_referee_bounds test_exact test_exact_overlap test_exact_invariance test_truth \
             test_kernels test_library test_library_batch test_library_paths test_library_paths_mistakes \
             test_region_functions
TESTS = $(patsubst tests/%.c,%,$(wildcard tests/test_*.c))
tests_double = $(TESTS:%=build/double/tests/%)
tests_others = $(foreach P,quad multi,$(patsubst %,build/$(P)/tests/%,$(filter-out $(TESTS_ONCE),$(TESTS))))

define test_rules
build/$(1)/tests/test_%: build/$(1)/tests/test_%.o build/$(1)/libharness.a build/$(1)/libalgorithms.a
	$$(LINK_$(1)) -o $$@ $$^ $$(LIBS_$(1)) -lcmocka $$(LIBS)
# Cases to be judged by exact algebra come from the generator.
build/$(1)/tests/test_certified build/$(1)/tests/test_batch build/$(1)/tests/test_decide build/$(1)/tests/test_strict: | build/double/fatline-generate
# The watched algorithms against the others, whose answers a program of its own prints.
build/$(1)/tests/answers: build/$(1)/tests/answers.o build/$(1)/libharness.a build/$(1)/libalgorithms.a
	$$(LINK_$(1)) -o $$@ $$^ $$(LIBS_$(1)) -lcmocka $$(LIBS)
build/$(1)/tests/test_convergence: build/$(1)/tests/test_convergence.o build/$(1)/libharness.a build/$(1)/libwatched.a
	$$(LINK_$(1)) -o $$@ $$^ $$(LIBS_$(1)) -lcmocka $$(LIBS)
build/$(1)/tests/test_watched: build/$(1)/tests/test_watched.o build/$(1)/libharness.a build/$(1)/libwatched.a \
                               | build/$(1)/tests/answers
	$$(LINK_$(1)) -o $$@ $$^ $$(LIBS_$(1)) -lcmocka $$(LIBS)
endef
$(foreach P,$(PRECISIONS),$(eval $(call test_rules,$(P))))

# A build with a planted slowdown, which `fatline compare` must find.
build/slower/double/fatline-passes: tests/planted_slowdown.c algorithms/intersect/bezier_clipping.c \
                                    build/double/harness/passes.o build/double/libharness.a build/double/libalgorithms.a
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -Dbezier_clipping=plain_bezier_clipping -c algorithms/intersect/bezier_clipping.c -o $(@D)/plain.o
	$(CC) $(CFLAGS) -c tests/planted_slowdown.c -o $(@D)/planted.o
	$(CC) -o $@ $(@D)/planted.o $(@D)/plain.o $(filter %.o %.a,$^) $(LIBS_double) $(LIBS)

-include $(shell find build -name '*.d' 2>/dev/null)

include algorithms/peers/peers.mk

# ---- commands ------------------------------------------------------------------------------------------------

# Set-up may bring the compiler and the headers that this file asks for, so the rest runs in a make of its own.
FUZZ = build/fuzz/library
JOBS ?= $(shell nproc)
AFTER_SETUP = +@$(MAKE) --no-print-directory -j$(JOBS)
CASES ?= ../shared/cases

.PHONY: all tests check check-full setup setup-build setup-check setup-reproduce reproduce figures claims peers-table \
        peers-contacts certified-masses regions paths speed comparisons report trials instructions against-lib2geom fuzz format clean help

all: $(programs) peers-found ## build everything: build/fatline and its programs

tests: $(programs) $(library) $(if $(shell command -v clang),$(FUZZ) build/fuzz/planted) peers-found build/slower/double/fatline-passes $(tests_double) $(tests_others) ## build everything and the tests

check: setup-check ## set up, build, and run all tests, at quad and multi on one case in ten (7 to 10 minutes)
	$(AFTER_SETUP) tests
	@$(PYTHON) tests/run --cases $(CASES)

check-full: setup-check ## the same with every case at every precision
	$(AFTER_SETUP) tests
	@$(PYTHON) tests/run --cases $(CASES) --full

reproduce: setup-reproduce ## set up, build, run the main job and print its table (5 minutes; FULL=1: everything)
	$(AFTER_SETUP) all
	@$(PYTHON) scripts/reproduce $(if $(filter-out 0,$(FULL)),--full)

figures: build/double/fatline-region ## draw results/figures/ from results/raw/, and those of regions
	@$(PYTHON) scripts/figures.py
	@$(PYTHON) scripts/convergence_figures.py
	@$(PYTHON) scripts/region_figures.py

claims: all ## measure every claim of scripts/claims.toml and write results/claims.md (5 to 8 minutes)
	@$(PYTHON) scripts/claims.py

claim-%: all
	@$(PYTHON) scripts/claims.py '$*'

peers-table: all ## time and judge the other libraries that are installed beside ours (FULL=1: on all sets, 7 minutes)
	@$(PYTHON) scripts/peers $(if $(filter-out 0,$(FULL)),--full)

peers-contacts: all ## what decides whether the other libraries get a contact right (1 minute)
	@$(PYTHON) scripts/peers_contacts

certified-masses: all ## a million random pairs and 144,000 hard ones, judged (7 minutes; results/tables/certified.md)
	@$(PYTHON) scripts/certified_masses --jobs $(JOBS)

regions: build/double/fatline-region ## judge random regions and time regions (1 minute; FULL=1: 10,000 random ones)
	@$(PYTHON) scripts/regions.py $(if $(filter-out 0,$(FULL)),--full)

speed: all ## time `certified` beside its portable engine and two libraries, family by family (10 minutes, on a quiet machine)
	@$(PYTHON) scripts/speed

report: ## write results/report.html: claims, tables and figures on one page
	@$(PYTHON) scripts/report.py

comparisons: ## profiles, growth, accuracy, every two algorithms, from results/raw/
	@$(PYTHON) scripts/comparisons.py

trials: all build/slower/double/fatline-passes ## can doctor and compare be trusted here? (5 minutes)
	@scripts/compare_trials

instructions: all ## count the instructions of each algorithm under callgrind
	@scripts/instructions
	@scripts/region_instructions

paths: build/fatline build/double/fatline-paths peers-found ## time paths of 100 to 1,000,000 segments (half a minute)
	@$(PYTHON) scripts/paths

against-lib2geom: all ## time bezier_clipping beside lib2geom's clipping
	@scripts/against_lib2geom

FUZZ_SECONDS = 60
FUZZ_FLAGS = -std=c11 -D_GNU_SOURCE -O1 -g $(FP) -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
build/fuzz/%.o: %.c
	@mkdir -p $(@D)
	clang $(FUZZ_FLAGS) -MMD -MP -c $< -o $@
$(FUZZ): $(LIBRARY_SOURCES:%.c=build/fuzz/%.o) build/fuzz/tests/fuzz_library.o
	clang -fsanitize=fuzzer,address,undefined -o $@ $^ -lm
# With a planted mistake, which has to be found.
build/fuzz/tests/fuzz_planted.o: tests/fuzz_library.c
	@mkdir -p $(@D)
	clang $(FUZZ_FLAGS) -DPLANTED=1 -MMD -MP -c $< -o $@
build/fuzz/planted: $(LIBRARY_SOURCES:%.c=build/fuzz/%.o) build/fuzz/tests/fuzz_planted.o
	clang -fsanitize=fuzzer,address,undefined -o $@ $^ -lm
fuzz: $(FUZZ) build/fuzz/planted ## libFuzzer with sanitizers on the library's entry, FUZZ_SECONDS=60 (needs clang)
	@FUZZ_SECONDS=$(FUZZ_SECONDS) $(PYTHON) tests/test_fuzz.py

setup: ## install what all the commands need and is missing (Debian 12)
	@scripts/setup all
setup-build setup-check setup-reproduce: setup-%:
	@scripts/setup $*

format: ## clang-format the C sources in place
	clang-format -i $(shell git ls-files '*.c' '*.h' '*.hpp')

help: ## list these targets
	@awk -F':.*## ' '/^[a-z0-9_-]+:.*## /{printf "  make %-18s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

clean: ## remove build/
	rm -rf build
