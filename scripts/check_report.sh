#!/bin/sh
# The committed viewer is what its sources give, and the report works in a browser.
# Usage: scripts/check_report.sh [BUILD]   (needs node, npm and chromium; CHROMIUM overrides its path)
set -eu
build=$(cd "${1:-build}" && pwd)
cd "$(dirname "$0")/../web"
[ -d node_modules ] || npm ci --ignore-scripts
node build.mjs --check
node test/report_test.mjs "$build/tests/report_fixture"
node test/play_test.mjs "$build/bin/mrsim"
