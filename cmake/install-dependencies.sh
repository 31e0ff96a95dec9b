#!/usr/bin/env bash
# Installs what Terrane needs on Debian 12, from Debian's own packages. Does nothing if all of it is there.
set -euo pipefail

packages=(
  g++ binutils cmake ninja-build pkg-config
  libcoin-dev libsoqt520-dev libglm-dev
  libgdal-dev libproj-dev
  libegl-dev libopengl-dev libgl-dev libosmesa6-dev libegl1 libgl1-mesa-dri
  libcli11-dev nlohmann-json3-dev libspdlog-dev libpng-dev libmeshoptimizer-dev
  libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libnoise-dev libbullet-dev
  gdal-bin gnuplot-nox xvfb xauth xdotool
)

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | head -n 1 || true)
  [ "$state" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null; then
  echo "install-dependencies.sh: no apt-get here; install by hand: ${missing[*]}" >&2
  exit 1
fi
if [ "$(id -u)" -eq 0 ]; then
  as_root=(env)
elif command -v sudo >/dev/null; then
  as_root=(sudo env)
else
  echo "install-dependencies.sh: needs root or sudo to install: ${missing[*]}" >&2
  exit 1
fi
echo "Installing: ${missing[*]}"
"${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get update -q
"${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
