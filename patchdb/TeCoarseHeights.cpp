#include "patchdb/TeCoarseHeights.h"

#include "patchdb/TeSurfaceCell.inl"

#include <cmath>
#include <limits>

namespace {

constexpr int kHighestLevel = 12;

TeError fail(const TePatchKey& key, const std::string& why) { return {"patch " + key.text() + ": " + why}; }

/// Base patch number (x, y) below a patch of a level.
TeResult<const TePatchData*> baseOf(const TePatchTree& tree, const TePatchKey& key, std::int64_t x,
                                    std::int64_t y) {
  const std::int64_t side = std::int64_t(1) << key.level;
  const TePatchKey base{key.x * side + x, key.y * side + y, 0};
  const TePatchData* patch = tree.find(base);
  if (!patch || !patch->hasHeights())
    return fail(key, "the base patch " + base.text() + " has no heights");
  return patch;
}

/// Samples 0 .. n of base patch number `patch` that are coarse samples: the first, and its number.
int firstCoarse(std::int64_t patch, int n, std::int64_t step, int& coarse) {
  const std::int64_t first = patch * n;
  const std::int64_t number = (first + step - 1) / step;
  coarse = int(number);
  return int(number * step - first);
}

void copyBase(const TePatchData& patch, std::int64_t x, std::int64_t y, int n, std::int64_t step,
              TeHeightMap& heights) {
  int firstColumn, row;
  const int firstX = firstCoarse(x, n, step, firstColumn);
  for (std::int64_t j = firstCoarse(y, n, step, row); j <= n; j += step, ++row) {
    int column = firstColumn;
    for (std::int64_t i = firstX; i <= n; i += step, ++column)
      heights.at(column, row) = patch.heights().at(int(i), int(j));
  }
}

double deviationOver(const TePatchData& patch, std::int64_t x, std::int64_t y, int n, std::int64_t step,
                     const TeHeightMap& heights) {
  const auto cellOf = [n, step](std::int64_t sample, double& fraction) {
    const std::int64_t cell = std::min<std::int64_t>(sample / step, n - 1);
    fraction = double(sample - cell * step) / double(step);
    return int(cell);
  };
  double worst = 0;
  for (int j = 0; j <= n; ++j) {
    double u, v;
    const int row = cellOf(y * n + j, v);
    const float* samples = patch.heights().row(j);
    for (int i = 0; i <= n; ++i) {
      const int column = cellOf(x * n + i, u);
      const TeSurfaceCell cell = TeSurfaceCell::of(heights.row(row) + column, heights.width());
      const double distance = std::fabs(samples[i] - teCellHeight(cell, u, v));
      worst = distance > worst ? distance : worst; // a missing height gives NaN, which is not
    }
  }
  return worst;
}

/// A float that is not less, with room for the rounding of whoever interpolates.
float roundedUp(double value) {
  return value == 0 ? 0.0f
                    : std::nextafter(std::nextafter(float(value), std::numeric_limits<float>::infinity()),
                                     std::numeric_limits<float>::infinity());
}

} // namespace

TeResult<TeCoarseHeights> teCoarseHeights(const TeLattice& lattice, const TePatchTree& tree,
                                          const TePatchKey& key) {
  if (!key.valid())
    return fail(key, "outside the world");
  if (key.level < 1 || key.level > kHighestLevel)
    return fail(key, "only levels 1 to " + std::to_string(kHighestLevel) + " are made from base patches");
  const int n = lattice.cells();
  TeResult<TeHeightMap> map = TeHeightMap::create(n + 1, n + 1);
  if (!map)
    return map.error();
  const std::int64_t side = std::int64_t(1) << key.level;
  for (std::int64_t y = 0; y < side; ++y)
    for (std::int64_t x = 0; x < side; ++x) {
      const TeResult<const TePatchData*> base = baseOf(tree, key, x, y);
      if (!base)
        return base.error();
      copyBase(**base, x, y, n, side, *map);
    }
  double worst = 0;
  for (std::int64_t y = 0; y < side; ++y)
    for (std::int64_t x = 0; x < side; ++x)
      worst = std::max(worst, deviationOver(**baseOf(tree, key, x, y), x, y, n, side, *map));
  return TeCoarseHeights{std::move(*map), roundedUp(worst)};
}
