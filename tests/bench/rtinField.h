#pragma once

#include "nodes/lod/TeLodField.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

/// The terrain of the benchmarks: the square map of 16-bit samples that TERRANE_BENCH_MAP names (the peers'
/// mpd_1025), or two waves of 1025² samples; 10 m cells, 0.03 m a unit.
inline TeLodFieldPtr rtinField() {
  static const TeLodFieldPtr made = [] {
    const char* name = std::getenv("TERRANE_BENCH_MAP");
    std::ifstream file(name ? name : "", std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const int side = bytes.empty() ? 1025 : int(std::lround(std::sqrt(double(bytes.size()) / 2)));
    TeHeightMap map = TeHeightMap::create(side, side).value();
    for (int row = 0; row < side; row++)
      for (int column = 0; column < side; column++) {
        const std::size_t at = 2 * (std::size_t(row) * std::size_t(side) + std::size_t(column));
        map.at(column, row) = bytes.empty()
                                  ? float(20000 + 15000 * std::sin(column / 97.0) * std::cos(row / 71.0) +
                                          900 * std::sin(column / 7.0) * std::sin(row / 5.0))
                                  : float(static_cast<unsigned char>(bytes[at]) +
                                          256 * static_cast<unsigned char>(bytes[at + 1]));
      }
    return TeLodField::create(std::make_shared<const TeHeightMap>(std::move(map)), {{0, 0, 0}, 10, 0.03})
        .value();
  }();
  return made;
}
