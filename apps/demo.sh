#!/usr/bin/env bash
# Installs the dependencies, builds, and shows terrain: in a window if there is a display, else as pictures.
# Arguments go to terrane-static.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash cmake/install-dependencies.sh
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target terrane-static
static=$PWD/build/release/bin/terrane-static

if [ -n "${DISPLAY:-}" ]; then
  status=0
  "$static" "$@" || status=$?
  # 1: the window could not be opened, so there is no display after all.
  [ "$status" -eq 1 ] || exit "$status"
fi

mkdir -p out
"$static" --context osmesa --offscreen out/terrane.png --report out/terrane.json "$@"
"$static" --context osmesa --offscreen out/terrane-parts.png --parts --wireframe "$@"
"$static" --context osmesa --offscreen out/terrane-top.png --top "$@"
echo "No display: written are"
printf '  %s\n' "$PWD"/out/terrane.png "$PWD"/out/terrane-parts.png "$PWD"/out/terrane-top.png "$PWD"/out/terrane.json
