# The peers: other people's intersection code, each an adapter of its own in build/peers/, built where its package is
# installed and else left out; `fatline list` names what is absent.  Nothing of this is linked into our programs: three
# are shared objects that are opened at run time, the others programs over a pipe.  `make peers` installs the packages.
ADAPTERS = algorithms/peers/adapters
PEERS    = build/peers
PEER_CFLAGS   = -std=c11 -D_GNU_SOURCE $(OPT) $(FP) $(WARN) -MMD -MP
PEER_CXXFLAGS = -std=c++17 $(OPT) $(FP) $(WARN) -DNDEBUG -MMD -MP
debian_version = $(shell dpkg-query -W -f='$${Version}' $(1) 2>/dev/null)

LYON_CRATES := /usr/share/cargo/registry
LYON_CRATE  := $(lastword $(wildcard $(LYON_CRATES)/lyon_geom-0.15.*))
ifneq ($(and $(LYON_CRATE),$(shell command -v cargo)),)
peers_found += $(PEERS)/lyon_geom.so
endif
LIB2GEOM := $(shell pkg-config --modversion 2geom 2>/dev/null)
ifneq ($(LIB2GEOM),)
peers_found += $(PEERS)/lib2geom.so
endif
ifneq ($(wildcard /usr/include/opencascade/Geom2dAPI_InterCurveCurve.hxx),)
peers_found += $(PEERS)/open_cascade.so
endif
ifneq ($(wildcard /usr/include/sisl.h),)
peers_found += $(PEERS)/sisl
endif
ifneq ($(wildcard /usr/include/CGAL/Arr_Bezier_curve_traits_2.h),)
peers_found += $(PEERS)/cgal
endif
ifneq ($(and $(shell command -v node),$(wildcard $(PEERS)/node_modules/paper)),)
peers_found += $(PEERS)/javascript.js
endif

# Debian's crates are a directory that stands for the registry; nothing is fetched.
$(PEERS)/lyon_geom.so: $(ADAPTERS)/lyon_geom/src/lib.rs $(ADAPTERS)/lyon_geom/Cargo.toml
	@mkdir -p $(PEERS)/lyon_geom/.cargo
	@cp -r $(ADAPTERS)/lyon_geom/Cargo.toml $(ADAPTERS)/lyon_geom/src $(PEERS)/lyon_geom
	@printf '[source.crates-io]\nreplace-with = "debian"\n[source.debian]\ndirectory = "%s"\n' $(LYON_CRATES) \
	    >$(PEERS)/lyon_geom/.cargo/config.toml
	cd $(PEERS)/lyon_geom && PEER_VERSION=$(LYON_CRATE:$(LYON_CRATES)/lyon_geom-%=%) cargo build --release --offline --quiet
	@cp $(PEERS)/lyon_geom/target/release/liblyon_geom.so $@

$(PEERS)/lib2geom.so: $(ADAPTERS)/lib2geom.cc
	@mkdir -p $(PEERS)
	$(CXX) $(PEER_CXXFLAGS) $(patsubst -I%,-isystem %,$(shell pkg-config --cflags 2geom)) -DPEER_VERSION='"$(LIB2GEOM)"' \
	    -fPIC -shared -o $@ $< $(shell pkg-config --libs 2geom)

$(PEERS)/open_cascade.so: $(ADAPTERS)/open_cascade.cc
	@mkdir -p $(PEERS)
	$(CXX) $(PEER_CXXFLAGS) -isystem /usr/include/opencascade -fPIC -shared -o $@ $< \
	    -lTKGeomAlgo -lTKGeomBase -lTKG2d -lTKG3d -lTKMath -lTKernel

$(PEERS)/sisl: $(ADAPTERS)/sisl.c
	@mkdir -p $(PEERS)
	$(CC) $(PEER_CFLAGS) -isystem /usr/include -DPEER_VERSION='"$(call debian_version,libsisl-dev)"' -o $@ $< -lsisl -lm

$(PEERS)/cgal: $(ADAPTERS)/cgal.cc
	@mkdir -p $(PEERS)
	$(CXX) $(PEER_CXXFLAGS) -w -o $@ $< -lgmp -lmpfr

$(PEERS)/javascript.js: $(ADAPTERS)/javascript.js
	@mkdir -p $(PEERS)
	cp $< $@

-include $(wildcard $(PEERS)/*.d)

.PHONY: peers peers-found peers-packages
peers-found: $(peers_found)
peers-packages:
	@scripts/setup peers
peers: peers-packages ## install the other libraries that we are compared with, and build their adapters
	$(AFTER_SETUP) all
	@build/fatline list peers
