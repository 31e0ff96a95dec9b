#include "apps/terrane-accuracy/TeMeasuredErrors.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

void TeMeasuredErrors::add(const TeScreenError::Report& report) {
  const std::int64_t covered = report.samples - report.uncovered;
  m_worstPixels = std::max(m_worstPixels, report.worst);
  m_p999Pixels = std::max(m_p999Pixels, report.quantile);
  m_worstMetres = std::max(m_worstMetres, report.worstMetres);
  m_squares += report.rms * report.rms * double(covered);
  m_samples += covered;
  m_uncovered += report.uncovered;
}

void TeMeasuredErrors::addJump(const TeLodField& field, const TeLodView& view, const TeDrawnSurface& before,
                               const TeDrawnSurface& after) {
  for (int row = 0; row <= field.cells(); row++) {
    const float* old = before.row(row);
    const float* now = after.row(row);
    for (int column = 0; column <= field.cells(); column++) {
      const double jump = std::abs(double(now[column]) - double(old[column]));
      if (!(jump > 0)) // nor where one of them ends
        continue;
      const glm::dvec3 point = field.position(field.vertex(column, row));
      if (view.meets(point, point))
        m_popping =
            std::max(m_popping, view.pixels(jump * field.heightScale(), glm::distance(view.eye, point)));
    }
  }
}

double TeMeasuredErrors::rmsPixels() const {
  return m_samples ? std::sqrt(m_squares / double(m_samples)) : 0;
}
