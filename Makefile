# make paper      set up, derive, solve, print Table 2 beside the paper, draw Fig. 7 (first command of the README)
# make test       everything that CI runs (second command); make test-fast: without the slow tests, under two minutes
# make test-all   each case, fresh random examples, what only runs at night; less than an hour
# make mutate     plausible errors made in a copy, one at a time: which of them the tests do not notice
# make corpus     compare some 150,000 answers with their record, a few minutes; `python -m tests.corpus --record` writes it
# make derive     write generated/ anew and build what is compiled from it
# make check      compare generated/ with fresh derivations
# make lint       ruff, mypy, basedpyright, numpydoc, clang-format
# make figures    every figure of the paper, into output/
# make bench      the benchmarks, docs/benchmarks.md; last other tools on the same problem, each installed into an environment
#                 of its own under .venv-peers; one that does not install keeps what was last measured of it
# make validity   averaging against the equation of motion: maps, table, the ledger's verdicts on figures, and
#                 docs/validity.md, some twenty minutes
# make stress     numerical stability: worst errors searched for, counts proved; docs/stability.md and its baseline, less
#                 than twenty minutes; then make derive, as headers say the worst errors that were found
# make explorer   docs/explorer.html, the compiled solvers in a browser; the same page whenever it is made
# make dist       sdist and wheel, output/dist; the wheel twice, which has to be the same bytes
# make docs       the site, output/docs: warnings are errors
# make links      whether somebody answers at every address that the site names; needs a network

PYTHON ?= python3
BIN := .venv/bin
# pip and what it and setup.py import run a few times in all: their bytecode would be 11 MB
PIP := PYTHONDONTWRITEBYTECODE=1 $(BIN)/python -m pip --quiet --disable-pip-version-check install --constraint derivations/constraints.txt
# stamps: the package with what derives and draws; compiled from the C as it is now; what tests and benchmarks need besides
INSTALLED := .venv/installed
COMPILED := .venv/compiled
DEVELOPED := .venv/developed
# what was derived anew, before it is in generated/
DERIVED := build/derived
# whose docstrings numpydoc validates: questions and their classes
NUMPYDOC := $(addprefix src/slowflow/,oscillators/physical.py oscillators/oscillator.py answers/table.py answers/results.py answers/questions.py averaged/composed.py \
            averaged/questions.py derive.py languages.py oscillators/isolator.py sizing/tolerances.py sizing/fitting.py sizing/loops.py \
            sizing/requirements.py)
SOLVERS := $(wildcard src/slowflow/native/*.[ch] src/slowflow/native/*/*.[ch])
NATIVE := $(SOLVERS) $(wildcard generated/c/*.h generated/native/*.[ch])
PYTEST := $(BIN)/python -m pytest -n auto --dist worksteal

.PHONY: paper figures test tests test-fast test-all every-test mutate derive $(DERIVED) check lint corpus bench validity stress explorer docs links dist clean
.DELETE_ON_ERROR:
# what pip installs and what the compiler makes do not wait for each other, nor do tests for mypy
MAKEFLAGS += --jobs=2
# containers often forbid Python to keep bytecode: all that is imported, SymPy too, would be compiled anew in each of the
# some hundred processes of a test run
unexport PYTHONDONTWRITEBYTECODE

paper: derive
	$(BIN)/python -m examples.paper --out output

figures: $(INSTALLED) $(COMPILED)
	$(BIN)/python -m examples.paper --figures --out output

test: lint tests

tests: $(DEVELOPED)
	$(BIN)/slowflow info
	$(PYTEST) -m "not night"

test-fast: $(DEVELOPED)
	$(PYTEST) -m "not slow and not night"

every-test: export SLOWFLOW_TESTS = all
every-test: $(DEVELOPED)
	$(PYTEST)

test-all: lint every-test

mutate: $(DEVELOPED)
	$(BIN)/python -m tests.mutants

# Derived beside the compiler, which reads generated/; and compiled again in a make of its own, which sees what was written.
# Where nothing differs, as in a fresh clone, nothing is.
derive:
	@$(MAKE) --no-print-directory $(COMPILED) $(DERIVED)
	$(BIN)/python -m derivations --from $(DERIVED)
	@$(MAKE) --no-print-directory $(COMPILED)

$(DERIVED): $(INSTALLED)
	$(BIN)/python -m derivations --out $@

check: $(INSTALLED)
	$(BIN)/python -m derivations --check

lint: $(DEVELOPED)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/basedpyright --project pyproject.toml
	$(BIN)/python -m numpydoc lint $(NUMPYDOC)
	$(BIN)/clang-format --dry-run -Werror $(SOLVERS) $(wildcard explorer/*.[ch] tests/native/*.c)

corpus: $(DEVELOPED)
	$(BIN)/python -m tests.corpus

# without the headers their row keeps what was last measured
bench: $(DEVELOPED)
	-$(PIP) --no-compile "slowflow[bench]"
	$(BIN)/python -m benchmarks

validity: $(DEVELOPED)
	$(BIN)/python -m benchmarks.claims
	$(BIN)/python -m derivations
	$(BIN)/python -m benchmarks.validity

stress: $(DEVELOPED)
	$(BIN)/python -m benchmarks.stress

# the compiler has 90 MB: not among what tests need
explorer: $(INSTALLED) $(COMPILED)
	$(PIP) "slowflow[explorer]"
	$(BIN)/python -m explorer

docs: $(INSTALLED) $(COMPILED)
	$(PIP) "slowflow[docs]"
	$(BIN)/python -m sphinx --builder html --fail-on-warning --keep-going --jobs auto docs output/docs

links: docs
	$(BIN)/python -m sphinx --builder linkcheck --doctree-dir output/docs/.doctrees docs output/links

# the files of the wheel are dated as the last commit; both wheels are built from the sdist
dist: export SOURCE_DATE_EPOCH := $(shell git log -1 --format=%ct 2>/dev/null || echo 315619200)
dist: $(INSTALLED)
	rm -rf output/dist output/again
	$(PIP) build
	$(BIN)/python -m build --quiet --outdir output/dist
	$(BIN)/python -m build --quiet --outdir output/again
	cmp output/dist/*.whl output/again/*.whl
	@cd output/dist && sha256sum *

.venv/pyvenv.cfg:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "slowflow needs Python 3.11 or newer: make PYTHON=python3.12"; exit 1; }
	@$(PYTHON) -m venv .venv || { echo "no venv module: on Debian, apt install python3-venv"; exit 1; }
	$(PIP) --no-compile --upgrade pip setuptools numpy

# What is imported is compiled to bytecode then; all of SymPy would take longer than the derivation. The C is left to the
# next rule, which pip need not be waited for, and which leaves the processors to it and to the derivation.
$(INSTALLED): .venv/pyvenv.cfg pyproject.toml setup.py derivations/constraints.txt
	SLOWFLOW_COMPILE=later $(PIP) --no-compile --no-build-isolation --editable ".[paper]"
	@touch $@

# A failure is an error. Without a C compiler that of ziglang, 90 MB from PyPI, compiles.
CC_OF_PYTHON := import os, shlex, sysconfig; print(shlex.split(os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc")[0])
$(COMPILED): .venv/pyvenv.cfg setup.py $(NATIVE)
	@rm -f $@
	@command -v "$$($(BIN)/python -c '$(CC_OF_PYTHON)')" > /dev/null || test -n "$$CC" || \
		{ echo "no C compiler here: installing ziglang, which has one"; $(PIP) --no-compile $$(grep -o 'ziglang==[0-9.]*' pyproject.toml); }
	nice $(BIN)/python -B setup.py --quiet build_ext --inplace
	@find src -name '_exact*.so' -exec touch $@ ';'

$(DEVELOPED): $(INSTALLED) | $(COMPILED)
	$(PIP) --no-compile "slowflow[dev]"
	@touch $@

clean:
	rm -rf .venv .venv-peers build output *.egg-info src/*.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
	find src generated -name '*.so' -delete
