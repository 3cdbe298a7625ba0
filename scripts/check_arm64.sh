#!/usr/bin/env bash
# Does another processor compute the same bits? Builds tests/portable/kernel_hash for arm64, runs it under qemu, and compares its hashes of
# traces, distances, pruning and meshes with those of this machine's build (BUILD=folder, default build, made with tests). Says "skipped"
# where compiler or emulator is missing.
#   scripts/check_arm64.sh [folder to build in]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for tool in aarch64-linux-gnu-g++ qemu-aarch64; do
  command -v "$tool" >/dev/null && continue
  echo "skipped: no $tool (apt-get install qemu-user g++-aarch64-linux-gnu libc6-dev-arm64-cross)"
  exit 0
done
folder=${1:-build-arm64}

here=${BUILD:-build}/tests/kernel_hash
if [ ! -x "$here" ]; then
  echo "$here is missing: build with MRSIM_TESTS first"
  exit 1
fi
mkdir -p "$folder"
{
  # -O1: compiled in half the time; no level of optimisation may change a bit.
  cmake -S tests/portable -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ &&
    cmake --build "$folder"
} >"$folder/log" 2>&1 || {
  tail -n 50 "$folder/log"
  exit 1
}
programs=(data/*.MPF data/*.NC data/*.CNC)
"$here" data "${programs[@]}" >"$folder/here.txt"
qemu-aarch64 -L /usr/aarch64-linux-gnu "$folder/kernel_hash" data "${programs[@]}" >"$folder/arm64.txt"
diff "$folder/here.txt" "$folder/arm64.txt"
printf '%d hashes, all equal on %s and arm64\n' "$(wc -l <"$folder/here.txt")" "$(uname -m)"
