#include "nodes/lod/TeLodField.h"

#include "generators/base/TeText.h"

#include <cmath>

TeResult<TeLodFieldPtr> TeLodField::create(std::shared_ptr<const TeHeightMap> heights,
                                           const Placement& placement) {
  if (!heights)
    return TeError{"no height map is given"};
  const int cells = heights->width() - 1;
  if (heights->width() != heights->height() || cells < kMinCells || cells > kMaxCells ||
      (cells & (cells - 1)) != 0)
    return TeError{teFormat("%d × %d samples are no square of 2^n + 1, n from 1 to 14", heights->width(),
                            heights->height())};
  for (int row = 0; row <= cells; row++) {
    const float* samples = heights->row(row);
    for (int column = 0; column <= cells; column++)
      if (!std::isfinite(samples[column]))
        return TeError{teFormat("the height of sample (%d, %d) is missing", column, row)};
  }
  const glm::dvec3& corner = placement.corner;
  if (!std::isfinite(corner.x + corner.y + corner.z))
    return TeError{"the corner of the terrain is not finite"};
  if (!(placement.spacing > 0) || !std::isfinite(placement.spacing))
    return TeError{teFormat("a spacing of %g is not more than 0", placement.spacing)};
  if (!(placement.heightScale >= 0) || !std::isfinite(placement.heightScale))
    return TeError{teFormat("a height scale of %g is negative or not finite", placement.heightScale)};
  return TeLodFieldPtr(new TeLodField(std::move(heights), placement));
}

TeLodField::TeLodField(std::shared_ptr<const TeHeightMap> heights, const Placement& placement)
    : m_heights(std::move(heights)), m_placement(placement) {
  while (1 << m_cellsLog < cells())
    m_cellsLog++;
  const TeMapStatistics statistics = m_heights->statistics();
  m_lowest = statistics.minimum;
  m_highest = statistics.maximum;
}
