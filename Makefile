# Thin: each target is one or two commands that you could type yourself.
BUILD   ?= build
FUZZ_SECONDS ?= 600
KILLS   ?= 200
CLANG    = -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_C_COMPILER=clang-14 -DCMAKE_LINKER=/usr/bin/ld -DTERP_PAGE=OFF
RUNS    ?= runs
FIGURES ?= figures
TERP     = $(BUILD)/terp
CASES    = cases/column_collapse
VERSION  = $(shell sed -n 's|^project.terp VERSION \([0-9.]*\) .*|\1|p' CMakeLists.txt)
WINDOWS  = $(abspath $(BUILD))/windows
BROWSER  = $(abspath $(BUILD))/browser
EMSCRIPTEN = $(CURDIR)/build/browser/emscripten
ZIP      = $(BUILD)/terp_$(VERSION)_windows_x86_64.zip
PYTHON   = PYTHONPATH=python /usr/bin/python3

.DEFAULT_GOAL := help
.PHONY: help install build demo test test-long package windows browser site gallery release wheel test-web vtk verify
.PHONY: verify-paper kill physics test-cluster fuzz sanitize lint accept clean

help:            ## this list
	@echo "Terp: explicit material point method for soil that softens and fails"
	@echo
	@sed -n 's/^\([a-z-]*\): *[a-z-]* *## */  make \1\t/p' $(MAKEFILE_LIST) | expand -t 22

install:         ## install what is missing from Debian (tools/install-dependencies)
	@tools/install-dependencies

build: install   ## build the program: build/terp
	@cmake -S . -B $(BUILD) -G Ninja -DTERP_TESTS=OFF >/dev/null
	@cmake --build $(BUILD)

demo: build      ## run the paper's models with both schemes, draw figures 1 to 9, compare, write the report page
	@for model in 1 2; do for scheme in mixed gp; do \
	   echo "model $$model, MPM-$$scheme:"; \
	   $(TERP) run $(CASES)/model_$$model.toml --set scheme=mpm_$$scheme --set output.fields.every=0.05 \
	     -o $(RUNS)/model_$${model}_$$scheme --force || exit; \
	 done; done
	@$(PYTHON) -m terp.figures $(RUNS)/model_1_mixed $(RUNS)/model_1_gp \
	   $(RUNS)/model_2_mixed $(RUNS)/model_2_gp -o $(FIGURES)
	@for model in 1 2; do $(TERP) compare $(RUNS)/model_$${model}_mixed $(RUNS)/model_$${model}_gp || exit; done
	@echo "figures in $(FIGURES)/, runs in $(RUNS)/"
	@$(TERP) report $(RUNS)/model_2_mixed $(RUNS)/model_2_gp -o $(RUNS)/report.html

test: install    ## install, build and run the tests
	@cmake -S . -B $(BUILD) -G Ninja -DTERP_TESTS=ON >/dev/null
	@cmake --build $(BUILD)
	@tests/support/in_memory ctest --test-dir $(BUILD) --output-on-failure -j 4 -LE 'verify|long'

test-long:       ## after `make test`: the tests that take more than six seconds each; ARGS="-E ledger" as CI does
	@tests/support/in_memory ctest --test-dir $(BUILD) --output-on-failure -j 4 -L long $(ARGS)

package: build   ## a Debian package: program, Python package, documents, cases, manual page, completion
	@cmake --build $(BUILD) --target manual
	@cd $(BUILD) && cpack >/dev/null && ls terp_*.deb

windows: build   ## a zip with terp.exe for Windows, compiled by mingw-w64 and tested with Wine (packaging/README.md)
	@tools/install-dependencies --windows
	@tools/build_windows_libraries $(WINDOWS)/libraries
	@cmake -S . -B $(WINDOWS)/terp -G Ninja -DCMAKE_TOOLCHAIN_FILE=$(CURDIR)/cmake/windows.cmake -DTERP_PYTHON=OFF \
	   -DTERP_WINDOWS_LIBRARIES=$(WINDOWS)/libraries >/dev/null
	@cmake --build $(WINDOWS)/terp
	@tools/package_windows $(WINDOWS)/terp/terp.exe $(WINDOWS)/libraries $(ZIP)
	@tests/windows/check_windows.py $(ZIP) $(WINDOWS)/terp/check_system.exe $(TERP)

browser: install ## terp.html: the solver in one page of a browser, by Debian 13's emscripten (docs/browser.md)
	@tools/install-dependencies --browser
	@tools/build_browser_libraries $(EMSCRIPTEN) $(BROWSER)/libraries
	@cmake -S . -B $(BROWSER)/program -G Ninja -DCMAKE_TOOLCHAIN_FILE=$(CURDIR)/cmake/browser.cmake -DTERP_PYTHON=OFF \
	   -DTERP_EMSCRIPTEN=$(EMSCRIPTEN) -DTERP_BROWSER_LIBRARIES=$(BROWSER)/libraries >/dev/null
	@cmake --build $(BROWSER)/program --target terp
	@cd web && { [ -e node_modules/.terp-lock ] || npm ci --silent; } && npm run --silent build:solver
	@tools/licences.py $(BROWSER)/libraries $(EMSCRIPTEN) > $(BROWSER)/licences.txt
	@node web/solver/assemble.mjs $(BROWSER)/program/terp.js $(BROWSER)/program/terp.wasm web/dist/index.html \
	   web/dist/solver/solver.html $(BROWSER)/licences.txt $(VERSION) $(BROWSER)/terp.html

site:            ## the documents as a site with search, build/site, with terp.html where `make browser` built it
	@tools/install-dependencies --site
	@tools/make_site $(BUILD)/site $(BROWSER)/terp.html

gallery: build   ## the cases, pictures and times of docs/gallery.md (7 minutes of one core); or CASE="3 4"
	@tools/install-dependencies --web
	@cd web && { [ -e node_modules/.terp-lock ] || npm ci --silent; }
	@tools/make_gallery $(TERP) $(CASE)

release:         ## all that is published of a version, and its tag (packaging/release); ARGS=--dry-run
	@packaging/release $(ARGS)

wheel: build     ## a wheel of the Python package with its compiled part
	@packaging/make_wheel $(BUILD)

verify: build    ## all cases with a known answer, or CASE="name name"; writes build/ and docs/verification.md
	@$(PYTHON) -m terp.verify $(CASE) --terp $(TERP) --markdown $(BUILD)/verification.md --overview docs/verification.md

physics: build   ## the table of sound physics: rest, slides, energy; ARGS="--seed 2 --rows level_clay" (tests/physics)
	@/usr/bin/python3 tests/physics/table.py --terp $(TERP) $(ARGS)

test-web: build  ## the pages: unit tests, and end-to-end tests in Chromium on runs of the program and on build/site
	@tools/install-dependencies --web
	@cd web && { [ -e node_modules/.terp-lock ] || npm ci --silent; } && npm run --silent build && npm test \
	   && TERP=$(abspath $(TERP)) TERP_HTML=$(BROWSER)/terp.html SITE=$(abspath $(BUILD))/site npm run test:e2e

vtk: install     ## read results with VTK 9.3 and the newest: Debian 13 and sid, 2.5 GB in build/vtk
	@cmake -S . -B $(BUILD) -G Ninja -DTERP_TESTS=ON >/dev/null
	@cmake --build $(BUILD)
	@for release in trixie sid; do tests/vtk/fetch_vtk $$release $(BUILD)/vtk/$$release || exit; done
	@ctest --test-dir $(BUILD) --output-on-failure -R '^vtk\.'

verify-paper: install  ## takes minutes: the paper's column on other meshes and in a turned frame, the dike
	@cmake -S . -B $(BUILD) -G Ninja -DTERP_TESTS=ON >/dev/null
	@cmake --build $(BUILD)
	@ctest --test-dir $(BUILD) --output-on-failure -L verify -V

kill: install    ## kill KILLS=200 runs at random moments, resume them, compare every file
	@cmake -S . -B $(BUILD) -G Ninja -DTERP_TESTS=ON >/dev/null
	@cmake --build $(BUILD) --target terp kill_at_call
	@/usr/bin/python3 tests/reliability/kill_runs.py $(TERP) --kills $(KILLS) \
	   --library $(BUILD)/tests/reliability/libkill_at_call.so

test-cluster: build  ## as root: kill studies on threads, ranks of mpirun, tasks of a real Slurm; compare their tables
	@tools/install-dependencies --cluster
	@tests/cluster/kill_studies.py $(TERP)

fuzz: install    ## fuzz each reader of files with libFuzzer (clang), FUZZ_SECONDS=600 fast, as many with sanitizers
	@tools/install-dependencies --checks
	@cmake -S . -B $(BUILD)/fuzz_fast -G Ninja -DTERP_FUZZ=ON $(CLANG) >/dev/null
	@cmake --build $(BUILD)/fuzz_fast
	@cmake -S . -B $(BUILD)/fuzz -G Ninja -DTERP_FUZZ=ON -DTERP_SANITIZE=ON $(CLANG) >/dev/null
	@cmake --build $(BUILD)/fuzz
	@tests/fuzz/run $(BUILD)/fuzz_fast/tests/fuzz $(BUILD)/fuzz/found $(FUZZ_SECONDS)
	@tests/fuzz/run $(BUILD)/fuzz/tests/fuzz $(BUILD)/fuzz/found $(FUZZ_SECONDS)

sanitize: install ## the tests with the address, undefined-behaviour and thread sanitizers
	@tools/check_sanitizers $(BUILD)

lint: install    ## clang-tidy, cppcheck and mypy, warnings as errors (.clang-tidy, tools/lint, python/mypy.ini)
	@tools/install-dependencies --checks
	@cmake -S . -B $(BUILD)/lint -G Ninja -DTERP_INSTRUCTIONS=plain -DTERP_UNITY=OFF -DTERP_TESTS=OFF $(CLANG) >/dev/null
	@tools/lint $(BUILD)/lint
	@cd python && /usr/bin/python3 -m mypy -p terp

accept: build    ## write what CASE=column_collapse gives now into its expected.toml
	@$(PYTHON) tests/cases/check_expected.py $(TERP) cases/$(CASE) --accept
	@$(PYTHON) tests/cases/check_expected.py $(TERP) cases/$(CASE) --long --accept
	@git diff --stat cases/$(CASE)

clean:           ## remove the build folder
	@rm -rf $(BUILD)
