# make paper   set up, derive, solve, print Table 2 beside the paper, draw Fig. 7 (first command of the README)
# make test    everything that CI runs (second command)
# make derive  write generated/ anew and build what is compiled from it; make check: compare generated/ with a fresh derivation; make bench: the benchmarks
# make validity  averaging against the equation of motion: maps, table, the ledger's verdicts on figures, and
#                docs/validity.md, some ten minutes
# make bench-peers  other tools on the same problem, each installed into an environment of its own under .venv-peers

PYTHON ?= python3
BIN := .venv/bin
INSTALLED := .venv/installed
NATIVE := $(wildcard src/slowflow/native/*.[ch] src/slowflow/native/solver/*.[ch] generated/c/*.h generated/native/*.[ch])

.PHONY: paper test derive check lint bench bench-peers validity clean
.DELETE_ON_ERROR:

paper: derive
	$(BIN)/slowflow paper --out output

test: $(INSTALLED) check lint
	$(BIN)/slowflow info
	$(BIN)/python -m pytest -n auto --dist worksteal
	SLOWFLOW_BACKEND=numpy $(BIN)/python -m pytest -n auto --dist worksteal -m both_backends

derive: $(INSTALLED)
	$(BIN)/python -m derivations
	$(BIN)/python setup.py --quiet build_ext --inplace
	@touch $(INSTALLED)

check: $(INSTALLED)
	$(BIN)/python -m derivations --check

lint: $(INSTALLED)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

bench: $(INSTALLED)
	$(BIN)/python -m benchmarks
	$(BIN)/python -m benchmarks.bench_scenes
	@if $(BIN)/python -c 'import heyoka' 2>/dev/null; then $(BIN)/python -m benchmarks.bench_exact; \
	else echo "exact motions: not measured, heyoka is not installed (pip install -e '.[exact]')"; fi

validity: $(INSTALLED)
	$(BIN)/python -m benchmarks.claims
	$(BIN)/python -m derivations
	$(BIN)/python -m benchmarks.validity

bench-peers: $(INSTALLED)
	$(BIN)/python -m benchmarks.peers

$(INSTALLED): pyproject.toml setup.py $(NATIVE)
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "slowflow needs Python 3.11 or newer: make PYTHON=python3.12"; exit 1; }
	@test -x $(BIN)/python || $(PYTHON) -m venv .venv || { echo "no venv module: on Debian, apt install python3-venv"; exit 1; }
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[dev]"
	@touch $@

clean:
	rm -rf .venv .venv-peers build output *.egg-info src/*.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
	find src generated -name '*.so' -delete
