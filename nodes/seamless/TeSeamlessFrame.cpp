#include "nodes/seamless/TeSeamlessFrame.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace {

/// Differences of samples to the eye's then stay below 2^24, and are exact as float.
constexpr double kMaxEyeSample = 1 << 23;

bool isFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; column++)
    for (int row = 0; row < 4; row++)
      if (!std::isfinite(matrix[column][row]))
        return false;
  return true;
}

} // namespace

TeSeamlessFrame::TeSeamlessFrame(const TeSeamlessPlacement& placement, const glm::dmat4& view,
                                 const glm::dmat4& projection)
    : m_placement(placement) {
  const glm::dmat3 turned(view);
  const double determinant = glm::determinant(turned);
  if (!isFinite(view) || !isFinite(projection) || determinant == 0 || !std::isfinite(determinant))
    return;
  m_eye = glm::inverse(turned) * -glm::dvec3(view[3]);
  const glm::dvec3 fromCorner = m_eye - placement.corner;
  const glm::dvec2 samples = glm::dvec2(fromCorner) / placement.spacing;
  const glm::dvec2 nearest = glm::clamp(glm::floor(samples), -kMaxEyeSample, kMaxEyeSample);
  m_eyeSample = glm::ivec2(nearest);
  m_eyeFraction = glm::vec2(glm::dvec2(fromCorner) - nearest * placement.spacing);
  m_base = float(-fromCorner.z);
  m_view = glm::mat4(glm::dmat4(turned));
  m_clip = glm::mat4(projection * glm::dmat4(turned));
  m_isValid = std::isfinite(m_eyeFraction.x) && std::isfinite(m_eyeFraction.y) && std::isfinite(m_base);
}

glm::vec3 TeSeamlessFrame::relative(std::int32_t column, std::int32_t row, float height) const {
  return {float(column - m_eyeSample.x) * spacing() - m_eyeFraction.x,
          float(row - m_eyeSample.y) * spacing() - m_eyeFraction.y, height * heightScale() + m_base};
}
