#!/usr/bin/env bash
# Installs the dependencies, builds, and flies over terrain: in a window if there is a display, else into
# pictures. Arguments go to terrane-flight in place of our own.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bash cmake/install-dependencies.sh
cmake --preset release >/dev/null
cmake --build --preset release -j "$(nproc)" --target terrane-flight
flight=$PWD/build/release/bin/terrane-flight

if [ -n "${DISPLAY:-}" ]; then
  shown=("$@")
  [ $# -gt 0 ] || shown=(--radius 8 --view third)
  echo "Arrow keys fly, F1 or / shows all keys, Esc leaves."
  status=0
  "$flight" "${shown[@]}" || status=$?
  # 1: the window could not be opened, so there is no display after all.
  [ "$status" -eq 1 ] || exit "$status"
fi

mkdir -p out
echo "No display: flying into pictures"
fly() {
  local name=$1
  shift
  "$flight" --context osmesa --frames 300 --dt 0.0333 --offscreen "out/$name.png" --report "out/$name.json" "$@"
  printf '  %s\n' "$PWD/out/$name.png" "$PWD/out/$name.json"
}
if [ $# -gt 0 ]; then
  fly flight "$@"
else
  fly flight-first --path line --radius 3
  fly flight-third --path circle --radius 4 --view third
  fly flight-far --path zigzag --radius 8 --hud off
fi
