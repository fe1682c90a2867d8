# libfatline: core, certified and curvature behind fatline.h, in doubles.  One object whose only global names are
# those of fatline.h; the archive and the shared object hold the same.

VERSION = $(shell sed -n 's/^.define FATLINE_VERSION "\(.*\)"/\1/p' algorithms/fatline.h)
SONAME  = libfatline.so.0
OBJCOPY = objcopy
PREFIX  = /usr/local
BINDIR  = $(PREFIX)/bin
LIBDIR  = $(PREFIX)/lib
INCLUDEDIR = $(PREFIX)/include
MANDIR  = $(PREFIX)/share/man
INSTALL = install

LIBRARY_MODULES = crossings problem workspace
LIBRARY_SOURCES = $(LIBRARY_MODULES:%=algorithms/%.c) \
    $(wildcard algorithms/core/*.c algorithms/intersect/certified/*.c algorithms/curvature/*.c algorithms/paths/*.c \
    algorithms/library/*.c)
library = build/library/libfatline.a build/library/libfatline.so.$(VERSION) build/library/fatline.pc

build/library/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -fPIC -fvisibility=hidden -c $< -o $@
build/library/fatline.o: $(LIBRARY_SOURCES:%.c=build/library/%.o)
	$(CC) -r -nostdlib -o $@ $^
	$(OBJCOPY) --localize-hidden $@
build/library/libfatline.a: build/library/fatline.o
	@rm -f $@
	ar rcs $@ $^
build/library/libfatline.so.$(VERSION): build/library/fatline.o
	$(CC) -shared -Wl,-soname,$(SONAME) -Wl,--no-undefined -Wl,-z,relro -Wl,-z,now -o $@ $^ -lm
build/library/fatline.pc: algorithms/library/fatline.pc.in algorithms/fatline.h FORCE
	@mkdir -p $(@D)
	@sed -e 's,@prefix@,$(PREFIX),' -e 's,@libdir@,$(LIBDIR),' -e 's,@includedir@,$(INCLUDEDIR),' \
	    -e 's,@version@,$(VERSION),' $< >$@
FORCE:

# The library beside the parts it is made of: its other names are its own.
$(patsubst tests/%.c,build/double/tests/%,$(wildcard tests/test_library*.c)): build/library/libfatline.a

.PHONY: FORCE library install install-commands uninstall
library: $(library) ## libfatline.a, libfatline.so and fatline.pc in build/library/ (needs gcc and libm only)

install: library ## header, libraries, fatline.pc and fatline(3) below PREFIX=/usr/local (DESTDIR=, LIBDIR=, ...)
	$(INSTALL) -d $(DESTDIR)$(INCLUDEDIR) $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(MANDIR)/man3
	$(INSTALL) -m 644 algorithms/fatline.h $(DESTDIR)$(INCLUDEDIR)/fatline.h
	$(INSTALL) -m 644 build/library/libfatline.a $(DESTDIR)$(LIBDIR)/libfatline.a
	$(INSTALL) -m 755 build/library/libfatline.so.$(VERSION) $(DESTDIR)$(LIBDIR)/libfatline.so.$(VERSION)
	ln -sf libfatline.so.$(VERSION) $(DESTDIR)$(LIBDIR)/$(SONAME)
	ln -sf $(SONAME) $(DESTDIR)$(LIBDIR)/libfatline.so
	$(INSTALL) -m 644 build/library/fatline.pc $(DESTDIR)$(LIBDIR)/pkgconfig/fatline.pc
	$(INSTALL) -m 644 algorithms/library/fatline.3 $(DESTDIR)$(MANDIR)/man3/fatline.3

# The command finds its programs beside itself: bin/fatline is a link into lib/fatline/.
install-commands: $(programs) ## the command fatline, its programs at all precisions, and fatline(1), at the same place
	$(INSTALL) -d $(DESTDIR)$(BINDIR) $(PRECISIONS:%=$(DESTDIR)$(LIBDIR)/fatline/%) $(DESTDIR)$(MANDIR)/man1
	for program in $(programs:build/%=%); do \
	    $(INSTALL) -m 755 build/$$program $(DESTDIR)$(LIBDIR)/fatline/$$program || exit 2; done
	ln -sf $(LIBDIR)/fatline/fatline $(DESTDIR)$(BINDIR)/fatline
	$(INSTALL) -m 644 harness/fatline.1 $(DESTDIR)$(MANDIR)/man1/fatline.1

uninstall: ## remove what both installed (same PREFIX and DESTDIR)
	rm -f $(DESTDIR)$(INCLUDEDIR)/fatline.h $(DESTDIR)$(LIBDIR)/libfatline.* \
	    $(DESTDIR)$(LIBDIR)/pkgconfig/fatline.pc $(DESTDIR)$(MANDIR)/man3/fatline.3 \
	    $(DESTDIR)$(BINDIR)/fatline $(DESTDIR)$(MANDIR)/man1/fatline.1
	rm -rf $(DESTDIR)$(LIBDIR)/fatline
