#include "patchdb/TeFourMapBlend.h"

#include "generators/base/TeFloatEnvironment.h"
#include "patchdb/TeTargetClones.h"

namespace {

/// Samples 1 .. n-1 of an inner row: all four weights are positive. `scale` is 1/n² where that is exact.
TE_TARGET_CLONES
void blendInside(const float* southWest, const float* southEast, const float* northWest,
                 const float* northEast, float* out, int cells, int y, double scale) {
  const double north = y;
  const double south = cells - y;
  const double whole = double(cells) * cells;
  if (scale != 0) {
    for (int x = 1; x < cells; ++x) {
      const double east = x;
      const double west = cells - x;
      out[x] = float((west * south * southWest[x] + east * south * southEast[x] +
                      west * north * northWest[x] + east * north * northEast[x]) *
                     scale);
    }
    return;
  }
  for (int x = 1; x < cells; ++x) {
    const double east = x;
    const double west = cells - x;
    out[x] = float((west * south * southWest[x] + east * south * southEast[x] + west * north * northWest[x] +
                    east * north * northEast[x]) /
                   whole);
  }
}

/// Samples 1 .. n-1 of a border row between two maps.
TE_TARGET_CLONES
void blendEdge(const float* west, const float* east, float* out, int cells) {
  const double whole = double(cells) * cells;
  for (int x = 1; x < cells; ++x)
    out[x] = float((double(cells - x) * cells * west[x] + double(x) * cells * east[x]) / whole);
}

/// A border sample between two maps, `at` cells from where the first has all the weight.
float blendTwo(float first, float second, int cells, int at) {
  const double whole = double(cells) * cells;
  return float((double(cells - at) * cells * first + double(at) * cells * second) / whole);
}

bool powerOfTwo(int value) { return (value & (value - 1)) == 0; }

} // namespace

TeFourMapBlend::TeFourMapBlend(const TeHeightMap& southWest, const TeHeightMap& southEast,
                               const TeHeightMap& northWest, const TeHeightMap& northEast, TeHeightMap& patch)
    : m_maps{&southWest, &southEast, &northWest, &northEast}, m_patch(&patch), m_cells(patch.width() - 1) {
  assert(patch.height() == patch.width() && m_cells >= 1);
  for ([[maybe_unused]] const TeHeightMap* map : m_maps)
    assert(map->width() == 2 * m_cells + 1 && map->height() == map->width());
}

std::int64_t TeFourMapBlend::weight(int cells, int map, int x, int y) {
  return std::int64_t(map % 2 == 0 ? cells - x : x) * (map / 2 == 0 ? cells - y : y);
}

bool TeFourMapBlend::step(TeAllowance& allowance) {
  const TeFloatEnvironment environment;
  while (m_row <= m_cells) {
    blendRow(m_row++);
    if (!allowance.spend())
      break;
  }
  return m_row > m_cells;
}

void TeFourMapBlend::finish() {
  TeAllowance all = TeAllowance::unlimited();
  step(all);
}

// The patch is the north-east quarter of its south-west map, and so on.
void TeFourMapBlend::blendRow(int y) {
  const int n = m_cells;
  float* out = m_patch->row(y);
  if (y == 0 || y == n) {
    const float* west = y == 0 ? m_maps[0]->row(n) + n : m_maps[2]->row(n) + n;
    const float* east = y == 0 ? m_maps[1]->row(n) : m_maps[3]->row(n);
    out[0] = west[0];
    blendEdge(west, east, out, n);
    out[n] = east[n];
    return;
  }
  const float* southWest = m_maps[0]->row(n + y) + n;
  const float* southEast = m_maps[1]->row(n + y);
  const float* northWest = m_maps[2]->row(y) + n;
  const float* northEast = m_maps[3]->row(y);
  out[0] = blendTwo(southWest[0], northWest[0], n, y);
  blendInside(southWest, southEast, northWest, northEast, out, n, y,
              powerOfTwo(n) ? 1.0 / (double(n) * n) : 0.0);
  out[n] = blendTwo(southEast[n], northEast[n], n, y);
}
