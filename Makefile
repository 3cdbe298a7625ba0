# A thin front door; the flags are in CMakePresets.json and the work in ./setup and scripts/.
.PHONY: build test demo asan format lint data ci
build:
	cmake --preset release && cmake --build --preset release
test:
	./setup test
demo:
	./setup demo
asan:
	./setup test asan
format:
	scripts/format.sh
lint:
	python3 scripts/check_includes.py
	python3 scripts/check_names.py
	python3 scripts/check_docs.py
	scripts/format.sh --check
	scripts/lint.py
data:
	python3 scripts/make_data.py
ci:
	.ci/run
