#!/usr/bin/env bash
# clang-tidy's short list (.clang-tidy) on the stages that all others stand on: two minutes on two cores. Other files by name:
#   scripts/lint.sh [source...]
# The commands are those of a build that joins no sources, configured for this alone: from others clang-tidy guesses a source's options.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tool=clang-tidy-14
command -v "$tool" >/dev/null || tool=clang-tidy
[ $# -gt 0 ] || set -- src/core/*.cpp src/setup/*.cpp src/timing/*.cpp
commands=$(mktemp -d)
trap 'rm -rf "$commands"' EXIT
cmake -S . -B "$commands" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  -DMRSIM_TESTS=OFF -DMRSIM_FUZZ=OFF >/dev/null
printf '%s\n' "$@" | xargs -P "$(nproc)" -n 4 "$tool" -p "$commands" --quiet
printf '%d sources, no findings\n' $#
