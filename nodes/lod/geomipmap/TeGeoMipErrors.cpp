#include "nodes/lod/geomipmap/TeGeoMipErrors.h"

#include "nodes/lod/geomipmap/TeGeoMipSampler.h"
#include "patchdb/TeTargetClones.h"

#include <algorithm>

namespace {

constexpr int kLanes = TeGeoMipSampler::kLanes;

/// Samples of up to eight patches side by side, from patch x on; what would lie beyond repeats the last.
void gather(const TeHeightMap& heights, int patchCells, int x, int y, int count,
            TeGeoMipSampler::Block& block) {
  const int width = patchCells + 1;
  for (int row = 0; row < width; row++) {
    const float* from = heights.row(y * patchCells + row) + x * patchCells;
    float* to = block.data() + std::size_t(row) * std::size_t(width) * kLanes;
    for (int lane = 0; lane < kLanes; lane++) {
      const float* samples = from + std::min(lane, count - 1) * patchCells;
      for (int column = 0; column < width; column++)
        to[column * kLanes + lane] = samples[column];
    }
  }
}

TE_TARGET_CLONES
void ranges(const float* block, int samples, float* low, float* high) {
  for (int lane = 0; lane < kLanes; lane++)
    low[lane] = high[lane] = block[lane];
  for (int i = 1; i < samples; i++)
    for (int lane = 0; lane < kLanes; lane++) {
      const float height = block[i * kLanes + lane];
      low[lane] = height < low[lane] ? height : low[lane];
      high[lane] = height > high[lane] ? height : high[lane];
    }
}

/// Samples that are vertices of the level below but not of this one, under the edges that take their place.
TeGeoMipSampler::Samples leftOut(int patchCells, int level) {
  TeGeoMipSampler::Samples samples;
  const int step = 1 << level, half = step / 2;
  const auto number = [&](int x, int y) { return std::uint16_t(y * (patchCells + 1) + x); };
  for (int y = 0; y <= patchCells; y += half)
    for (int x = 0; x <= patchCells; x += half) {
      const int dx = x % step, dy = y % step;
      if (dx == 0 && dy == 0)
        continue;
      const std::uint16_t from = number(x - dx, y - dy), to = number(x + dx, y + dy);
      samples.push_back({number(x, y), {from, to, to}, {0.5f, 0.5f, 0}});
    }
  return samples;
}

} // namespace

TeGeoMipErrors::TeGeoMipErrors(const TeLodField& field, const TeGeoMipPatterns& patterns)
    : m_levels(patterns.levels()), m_patches(field.cells() / patterns.patchCells()),
      m_stride(2 * (m_levels - 1) + 2 * m_levels * (m_levels - 1)),
      m_values(std::size_t(m_patches) * std::size_t(m_patches) * std::size_t(m_stride)),
      m_ranges(std::size_t(m_patches) * std::size_t(m_patches)) {
  const int patchCells = patterns.patchCells();
  const TeGeoMipSampler sampler(patchCells);

  struct Column {
    int offset;
    int floor; ///< another number of the patch that this one is no less than; negative: none
    TeGeoMipSampler::Samples samples;
  };
  std::vector<Column> columns;
  for (int level = 1; level < m_levels; level++) {
    columns.push_back({level - 1, level - 2, sampler.samples(patterns.regular(level))});
    const int midpoint = m_levels - 2 + level;
    columns.push_back({midpoint, level > 1 ? midpoint - 1 : -1, leftOut(patchCells, level)});
  }
  for (int border = 1; border < m_levels; border++)
    for (int level = 0; level < border; level++)
      for (int number = 0; number < 4; number++) {
        const auto side = TeGeoMipSide(number);
        std::vector<TeGeoMipPatterns::Triangle> triangles = patterns.stitched(level, side, border);
        // Beside it a strip that is not stitched has to end on the diagonal, too.
        triangles.push_back(patterns.half(level, TeGeoMipSide((number + 3) % 4), true));
        triangles.push_back(patterns.half(level, TeGeoMipSide((number + 1) % 4), false));
        columns.push_back({offset(level, side, border),
                           border - 1 > level ? offset(level, side, border - 1) : -1,
                           sampler.samples(triangles)});
      }

  TeGeoMipSampler::Block block(std::size_t(patchCells + 1) * std::size_t(patchCells + 1) * kLanes);
  for (int y = 0; y < m_patches; y++)
    for (int x = 0; x < m_patches; x += kLanes) {
      const int count = std::min(kLanes, m_patches - x);
      gather(field.heights(), patchCells, x, y, count, block);
      float low[kLanes], high[kLanes];
      ranges(block.data(), (patchCells + 1) * (patchCells + 1), low, high);
      for (int lane = 0; lane < count; lane++)
        m_ranges[number(x + lane, y)] = {low[lane], high[lane]};
      for (const Column& column : columns) {
        const TeGeoMipSampler::Lanes worst = TeGeoMipSampler::deviations(column.samples, block);
        for (int lane = 0; lane < count; lane++) {
          float* values = m_values.data() + number(x + lane, y) * std::size_t(m_stride);
          values[column.offset] = column.floor < 0 ? worst[std::size_t(lane)]
                                                   : std::max(worst[std::size_t(lane)], values[column.floor]);
        }
      }
    }
}
