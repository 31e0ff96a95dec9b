#!/bin/bash
# bits.sh SOURCE_DIR WORK_DIR COMPILER OPTION...: builds the layer generators with a compiler and options of its
# own and compares the bits of every generator with the golden ones.
set -euo pipefail
source_dir=$1 work_dir=$2 compiler=$3
shift 3
rm -rf "$work_dir"
mkdir -p "$work_dir"
cd "$source_dir"
launcher=$(command -v ccache || true)
mapfile -t sources < <(find generators -name '*.cpp' -not -path '*/modules/*' | sort)
sources+=(tests/hard_cases/bits/goldenDriver.cpp)
printf '%s\n' "${sources[@]}" | xargs -P "$(nproc)" -I{} sh -c \
  'object=$1/$(echo "$2" | tr / _).o; shift 2; "$@" -o "$object"' sh "$work_dir" {} \
  $launcher "$compiler" -std=c++17 -ffp-contract=off -fPIC -I. "$@" -c {}
"$compiler" "$@" "$work_dir"/*.o -o "$work_dir/goldenDriver" -pthread -ldl
echo "$compiler $*:"
"$work_dir/goldenDriver" compare
