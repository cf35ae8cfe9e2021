# make demo   derive, emit, compile, run and typeset one system into build/demo
# make test   every check, and all tests but those that take long
# Both need a Python from 3.11 on, a C compiler and nothing else; what they install goes into .venv.

VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check --quiet
DEMO := build/demo
SYSTEM := chaplygin_sleigh
CC ?= cc
CFLAGS ?= -O2
CWARN := -std=c99 -Wall -Wextra -Wpedantic -Wconversion -Werror

.DEFAULT_GOAL := help
.PHONY: help demo test slow check goldens fuzz bench atlas clean

help:
	@sed -n 's/^# \(make .*\)/\1/p' Makefile
	@echo "make check    the lints only"
	@echo "make goldens  rewrite the expected files of the tests; read the difference before you commit it"
	@echo "make fuzz     fuzz the reader, the parser and the emission; FUZZ_INPUTS and FUZZ_SPECS say how much"
	@echo "make slow     the tests that take long: long runs, long studies, more cases of many alike"
	@echo "make bench    those too, then measure nhc beside its peers and write docs/performance.md (needs valgrind, takes many minutes)"
	@echo "make atlas    run the atlas of failures, the long scenarios too, and rewrite its table in docs/stability.md"
	@echo "make clean    remove build/"

# A python3 that is on the path need not run (version managers leave such shims): each candidate is tried.
$(BIN)/python:
	@for python in $(PYTHON) python3 python3.14 python3.13 python3.12 python3.11; do \
	    if $$python -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1; then \
	        echo "making $(VENV) with $$python"; \
	        $$python -m venv $(VENV) || { rm -rf $(VENV); echo "error: $$python cannot make a virtual environment (on Debian: apt-get install python3-venv)" >&2; exit 1; }; \
	        exit 0; \
	    fi; \
	done; \
	echo "error: no Python from 3.11 on among python3 and python3.11 ... python3.14; give one with make PYTHON=/path/to/python" >&2; \
	exit 1

$(VENV)/installed: pyproject.toml | $(BIN)/python
	@echo "installing nhc into $(VENV)"
	@$(PIP) install -e .
	@touch $@

$(VENV)/installed-dev: pyproject.toml | $(BIN)/python
	@echo "installing nhc and what its tests need into $(VENV)"
	@$(PIP) install -e '.[dev]'
	@touch $@ $(VENV)/installed

$(VENV)/installed-bench: pyproject.toml | $(BIN)/python
	@echo "installing nhc and the peers it is measured against into $(VENV)"
	@$(PIP) install -e '.[sim,bench]'
	@touch $@ $(VENV)/installed

demo: $(VENV)/installed
	@command -v $(CC) >/dev/null || { echo "error: no C compiler \`$(CC)\`" >&2; exit 1; }
	@rm -rf $(DEMO)
	$(BIN)/nhc check $(SYSTEM)
	$(BIN)/nhc emit $(SYSTEM) --lang latex -o $(DEMO)
	$(BIN)/nhc emit $(SYSTEM) --lang c --driver -o $(DEMO)
	$(BIN)/nhc emit $(SYSTEM) --lang python -o $(DEMO)
	$(CC) $(CFLAGS) $(CWARN) -o $(DEMO)/$(SYSTEM) $(DEMO)/*.c -lm
	$(DEMO)/$(SYSTEM) > $(DEMO)/$(SYSTEM).csv
	@if command -v pdflatex >/dev/null; then \
	    echo "pdflatex $(SYSTEM).tex"; \
	    (cd $(DEMO) && for pass in 1 2; do pdflatex -interaction=nonstopmode -halt-on-error $(SYSTEM).tex >pdflatex.log || { tail -n 30 pdflatex.log; exit 1; }; done); \
	else \
	    echo "no pdflatex here: $(DEMO)/$(SYSTEM).tex is left to be typeset"; \
	fi
	@echo
	@echo "The sleigh's run, $(DEMO)/$(SYSTEM).csv:"
	@sed -n '1,2p;$$p' $(DEMO)/$(SYSTEM).csv
	@echo
	@echo "Everything stands in $(DEMO):"
	@ls $(DEMO)

test: check
	$(BIN)/python -m pytest -n 2 --dist worksteal -m "not slow"

slow: $(VENV)/installed-dev
	$(BIN)/python -m pytest -n 2 -m slow

check: $(VENV)/installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

goldens: $(VENV)/installed-dev
	$(BIN)/python -m pytest --update
	git --no-pager diff --stat -- tests

# a night's run: make fuzz FUZZ_INPUTS=20000000 FUZZ_SPECS=20000 FUZZ_SEED=7
FUZZ_INPUTS ?= 200000
FUZZ_SPECS ?= 300
FUZZ_SEED ?= 1
fuzz: $(VENV)/installed-dev
	$(BIN)/python -m tests.fuzz.run --inputs $(FUZZ_INPUTS) --specs $(FUZZ_SPECS) --seed $(FUZZ_SEED)

bench: $(VENV)/installed-bench slow
	@command -v valgrind >/dev/null || { echo "error: no valgrind, which counts the instructions (on Debian: apt-get install valgrind)" >&2; exit 1; }
	$(BIN)/python -m benchmarks

atlas: $(VENV)/installed-dev
	$(BIN)/python -m nhc.study.atlas docs/stability.md

clean:
	rm -rf build
