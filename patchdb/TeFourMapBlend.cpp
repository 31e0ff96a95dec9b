#include "patchdb/TeFourMapBlend.h"

#include "generators/base/TeFloatEnvironment.h"
#include "patchdb/TeTargetClones.h"

#include <algorithm>

namespace {

constexpr int kRowsAhead =
    4; // maps are read in four streams of short rows, too short for the hardware to guess
constexpr int kFloatsOfALine = 16;
constexpr int kSamplesPerUnit = 4096;

/// Rows of samples: the first sample and the step from row to row.
struct Rows {
  const float* first;
  int stride;
};

/// Samples of rows `from` .. `to` - 1, which are not border rows. The weights of column 0 are those of the
/// formula too, but a map of weight 0 must not take part there: the caller sets this column, and column n.
/// `scale` is 1/whole² where that is exact, else 0.
TE_TARGET_CLONES
void blendRows(Rows southWest, Rows southEast, Rows northWest, Rows northEast, float* out, int cells,
               const double* rising, double whole, int from, int to, double scale) {
  const double sum = whole * whole;
  for (int y = from; y < to; ++y) {
    const double north = rising[y];
    const double south = whole - north;
    const float* a = southWest.first + std::ptrdiff_t(y) * southWest.stride;
    const float* b = southEast.first + std::ptrdiff_t(y) * southEast.stride;
    const float* c = northWest.first + std::ptrdiff_t(y) * northWest.stride;
    const float* d = northEast.first + std::ptrdiff_t(y) * northEast.stride;
    float* row = out + std::ptrdiff_t(y) * (cells + 1);
    if (y + kRowsAhead < to)
      for (int x = 0; x <= cells; x += kFloatsOfALine) {
        __builtin_prefetch(a + std::ptrdiff_t(kRowsAhead) * southWest.stride + x);
        __builtin_prefetch(b + std::ptrdiff_t(kRowsAhead) * southEast.stride + x);
        __builtin_prefetch(c + std::ptrdiff_t(kRowsAhead) * northWest.stride + x);
        __builtin_prefetch(d + std::ptrdiff_t(kRowsAhead) * northEast.stride + x);
      }
    if (scale != 0)
      for (int x = 0; x < cells; ++x) {
        const double east = rising[x];
        const double west = whole - east;
        row[x] = float(
            (west * south * a[x] + east * south * b[x] + west * north * c[x] + east * north * d[x]) * scale);
      }
    else
      for (int x = 0; x < cells; ++x) {
        const double east = rising[x];
        const double west = whole - east;
        row[x] = float(
            (west * south * a[x] + east * south * b[x] + west * north * c[x] + east * north * d[x]) / sum);
      }
  }
}

bool powerOfTwo(int value) { return (value & (value - 1)) == 0; }

} // namespace

TeFourMapBlend::TeFourMapBlend(const TeBlendWeights& weights, const TeHeightMap& southWest,
                               const TeHeightMap& southEast, const TeHeightMap& northWest,
                               const TeHeightMap& northEast, TeHeightMap& patch)
    : m_weights(&weights), m_maps{&southWest, &southEast, &northWest, &northEast}, m_patch(&patch),
      m_cells(weights.cells()) {
  assert(patch.height() == patch.width() && patch.width() == m_cells + 1);
  for ([[maybe_unused]] const TeHeightMap* map : m_maps)
    assert(map->width() == 2 * m_cells + 1 && map->height() == map->width());
}

/// A border sample between two maps, `at` cells from where the first has all the weight.
float TeFourMapBlend::blendTwo(float first, float second, int at) const {
  const double whole = m_weights->whole();
  const double rising = m_weights->rising()[at];
  return float(((whole - rising) * whole * first + rising * whole * second) / (whole * whole));
}

bool TeFourMapBlend::step(TeAllowance& allowance) {
  const TeFloatEnvironment environment;
  const int rows = std::max(1, kSamplesPerUnit / (m_cells + 1));
  while (m_row <= m_cells) {
    const int end = std::min(m_row + rows, m_cells + 1);
    blendTo(end);
    m_row = end;
    if (!allowance.spend())
      break;
  }
  return m_row > m_cells;
}

void TeFourMapBlend::finish() {
  TeAllowance all = TeAllowance::unlimited();
  step(all);
}

void TeFourMapBlend::blendBorder(int y) {
  const int n = m_cells;
  float* out = m_patch->row(y);
  const float* west = y == 0 ? m_maps[0]->row(n) + n : m_maps[2]->row(n) + n;
  const float* east = y == 0 ? m_maps[1]->row(n) : m_maps[3]->row(n);
  out[0] = west[0];
  for (int x = 1; x < n; ++x)
    out[x] = blendTwo(west[x], east[x], x);
  out[n] = east[n];
}

// The patch is the north-east quarter of its south-west map, and so on.
void TeFourMapBlend::blendTo(int end) {
  const int n = m_cells;
  if (m_row == 0)
    blendBorder(0);
  const int from = std::max(m_row, 1);
  const int to = std::min(end, n);
  if (from < to) {
    const int stride = 2 * n + 1;
    const Rows southWest{m_maps[0]->row(n) + n, stride};
    const Rows southEast{m_maps[1]->row(n), stride};
    const Rows northWest{m_maps[2]->data() + n, stride};
    const Rows northEast{m_maps[3]->data(), stride};
    const double whole = m_weights->whole();
    blendRows(southWest, southEast, northWest, northEast, m_patch->data(), n, m_weights->rising(), whole,
              from, to, powerOfTwo(m_weights->whole()) ? 1.0 / (whole * whole) : 0.0);
    for (int y = from; y < to; ++y) {
      const std::ptrdiff_t at = std::ptrdiff_t(y) * stride;
      float* row = m_patch->row(y);
      row[0] = blendTwo(southWest.first[at], northWest.first[at], y);
      row[n] = blendTwo(southEast.first[at + n], northEast.first[at + n], y);
    }
  }
  if (end > n)
    blendBorder(n);
}
