#!/usr/bin/env bash
# clang-tidy's short list (.clang-tidy) on the stages that all others stand on: two minutes on two cores. Other files by name:
#   scripts/lint.sh [source...]     needs a configured build folder (BUILD=folder, default build)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tool=clang-tidy-14
command -v "$tool" >/dev/null || tool=clang-tidy
[ $# -gt 0 ] || set -- src/core/*.cpp src/setup/*.cpp src/timing/*.cpp
printf '%s\n' "$@" | xargs -P "$(nproc)" -n 4 "$tool" -p "${BUILD:-build}" --quiet
printf '%d sources, no findings\n' $#
