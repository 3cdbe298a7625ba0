#!/usr/bin/env bash
# Formats all C++ sources with clang-format 14, or with --check says which are not formatted.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tool=clang-format-14
command -v "$tool" >/dev/null || tool=clang-format
mode=(-i)
[ "${1:-}" = --check ] && mode=(--dry-run --Werror)
git ls-files -z --cached --others --exclude-standard '*.h' '*.cpp' '*.inl' | xargs -0 "$tool" "${mode[@]}"
