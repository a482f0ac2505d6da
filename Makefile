# What can be done with a checkout of EduGym. Needed: make and Python 3.11 or newer; all else goes into .venv.
#
#   make lab        open the lessons in JupyterLab   (make lab ARGS=--no-browser)
#   make test       run every check, and every test that is not slow   (make test ARGS="-k boulder" for some of them)
#                   (JOBS=8 runs the tests in eight processes, for a machine of eight cores;
#                   EDUGYM_CACHE_DIR=FOLDER keeps their machine code, so that the next run takes less time)
#   make test-all   run the slow tests too: all claims, nbgrader, browsers, learning to the end, random programs
#   make reproduce  recompute the results of the paper
#   make site       build the website in site/build/html, and in a terminal show it at http://127.0.0.1:8000
#   make bench      measure speed, against what one would use instead
#   make dist       build the package from what is committed, and try it in an empty environment
#   make test-lowest  run the tests with the lowest versions of the dependencies that pyproject.toml allows
#   make test-clients  install Dask, MiniGrid, Ray with RLlib, Tianshou and TorchRL, and try EduGym with each
#   make grade      grade a class in a container   (make grade CLASS=$HOME/course LESSON=01_exploration)
#   make clean      remove .venv and what tools left behind

PYTHON ?= python3
ARGS ?=
JOBS ?= 2
RUN := .venv/bin/python -m

.PHONY: lab test test-all test-lowest test-clients reproduce site bench dist grade clean

lab: .venv/lab.installed
	.venv/bin/edugym lab $(ARGS)

# mypy needs one core for a minute, so it runs beside the tests. What it has found counts when they are done.
test: .venv/dev.installed
	$(RUN) ruff check
	$(RUN) ruff format --check
	.venv/bin/lint-imports
	$(RUN) mypy & types=$$!; trap "kill $$types 2>/dev/null" EXIT; trap "exit 130" INT TERM; \
		$(RUN) pytest -n $(JOBS) --dist worksteal -m "not slow" $(ARGS) && \
		{ wait $$types || { echo "mypy failed: what it says stands above, among the tests" >&2; exit 1; }; }
	.venv/bin/python docs/pages.py --check & pages=$$!; .venv/bin/python lessons/build.py --check && \
		.venv/bin/python docs/agents.py --check && .venv/bin/python docs/architecture.py --check && wait $$pages

# The tests that `make test` leaves out, and it alone: together the two commands run everything once. They start kernels and
# browsers, which hang now and then: a test that exceeds its time is run once more, and the summary says so.
test-all: .venv/dev.installed
	$(RUN) pytest -n $(JOBS) --dist worksteal -m slow --reruns 1 --only-rerun "Timeout \(>" $(ARGS)

# How fast it is, side by side with what one would use instead.
bench: .venv/dev.installed
	$(RUN) benchmarks $(ARGS)

reproduce: .venv/lab.installed
	.venv/bin/edugym reproduce $(ARGS)

# The website with the playground, and where PYODIDE names a folder with a release of Pyodide, with the lessons in JupyterLite. Nothing of the lessons is executed; kernels that were compiled before are not compiled again.
LITE := $(if $(PYODIDE),--pyodide "$(PYODIDE)")
site: .venv/site.installed
	.venv/bin/python site/website.py --jobs $(JOBS) $(LITE) $(ARGS)

# From a copy of what is committed, so that nothing of the working folder gets in.
dist: .venv/dev.installed
	rm -rf dist build && mkdir -p build/tree build/empty
	git archive HEAD | tar -x -C build/tree
	$(RUN) build --no-isolation --outdir dist build/tree
	$(RUN) twine check --strict dist/*
	$(PYTHON) -m venv build/venv
	build/venv/bin/pip install --quiet "$$(echo dist/*.whl)[lab]"
	cd build/empty && ../venv/bin/edugym list && ../venv/bin/edugym lab --help && ../venv/bin/python -c "import edugym; \
		edugym.train('Boulder', edugym.QLearning.create(edugym.make_mdp('Boulder')), n_steps=1000, seed=0)"

# Without the extras that need PyTorch or nbgrader: these have lowest versions of their own.
LOWEST := build/lowest
test-lowest:
	rm -rf $(LOWEST) && $(PYTHON) -m venv $(LOWEST)
	$(PYTHON) .ci/lowest.py > $(LOWEST)/constraints.txt
	$(LOWEST)/bin/pip install --quiet --constraint $(LOWEST)/constraints.txt --editable ".[notebook]" \
		hypothesis pytest pytest-timeout pytest-xdist
	@# Old libraries use what newer ones call deprecated: that is no fault of ours.
	$(LOWEST)/bin/python -m pytest -n $(JOBS) --dist worksteal -m "not slow" -W default::DeprecationWarning -W default::FutureWarning $(ARGS) \
		tests/adapters tests/agents tests/checks tests/compiled tests/contract tests/envs tests/exact tests/experiments \
		tests/mdp tests/rendering tests/system tests/training

# With libraries of others, too many for every checkout.
CLIENTS := build/clients
test-clients:
	rm -rf $(CLIENTS) && $(PYTHON) -m venv $(CLIENTS)
	$(CLIENTS)/bin/pip install --quiet --constraint constraints.txt --editable ".[experiments]" \
		distributed minigrid "ray[rllib]" tianshou torchrl hypothesis pytest pytest-timeout
	$(CLIENTS)/bin/python -m pytest $(ARGS) tests/adapters/test_other_libraries.py tests/experiments/test_clusters.py

# Students' code sees neither the network nor any file of yours but the class, of which it may write the results only.
CONTAINER ?= docker
grade:
	@test -f "$(CLASS)/assigned/teacher/$(LESSON).json" || { echo "CLASS must be the folder that has 'assigned', and LESSON \
	a lesson that was assigned there: make grade CLASS=\$$HOME/course LESSON=01_exploration" >&2; exit 1; }
	mkdir -p "$(CLASS)/results"
	$(CONTAINER) build --quiet --tag edugym-grading --file Containerfile .
	$(CONTAINER) run $(if $(findstring podman,$(CONTAINER)),--userns keep-id) --rm --network none --read-only --tmpfs /tmp:exec --memory 4g --pids-limit 512 --cap-drop all \
		--user "$$(id -u):$$(id -g)" --volume "$(abspath $(CLASS))/assigned:/class/assigned:ro" \
		--volume "$(abspath $(CLASS))/submitted:/class/submitted:ro" --volume "$(abspath $(CLASS))/results:/class/results" \
		edugym-grading "assigned/teacher/$(LESSON).json" $(ARGS)

clean:
	rm -rf .venv build dist site/build .mypy_cache .pytest_cache .ruff_cache .hypothesis
	find . -name __pycache__ -prune -exec rm -rf {} +

# Each extra of pyproject.toml is installed once, and again when what it depends on changes.
.venv/%.installed: pyproject.toml constraints.txt
	@$(PYTHON) -c "import sys; sys.exit(sys.version_info < (3, 11))" || \
		{ echo "EduGym needs Python 3.11 or newer, which '$(PYTHON)' is not. Name one: make PYTHON=python3.12" >&2; exit 1; }
	@echo "Installing EduGym and what it needs into .venv; this takes a minute or two."
	test -x .venv/bin/python || $(PYTHON) -m venv .venv
	$(RUN) pip install --quiet --no-compile --constraint constraints.txt --editable ".[$*]"
	@# The tests try the wrappers of MO-Gymnasium, which asks for pygame: that must not lie beside pygame-ce, which does as well.
	test $* != dev || $(RUN) pip install --quiet --no-compile --no-deps "mo-gymnasium>=1.3" || \
		echo "MO-Gymnasium cannot be installed here: the test of its wrappers is skipped." >&2
	@# pip would do this on one core. Some packages bring files for other versions of Python, which do not compile.
	$(RUN) compileall -qq -j 0 .venv/lib 2>/dev/null || true
	touch $@
