#include "generators/filters/TeMatrixSource.h"

#include "generators/base/TeFloatEnvironment.h"
#include "generators/base/TeHash.h"
#include "generators/filters/TeMatrixJob.h"

#include <algorithm>
#include <cmath>
#include <vector>

TeMatrixSource::TeMatrixSource(TeHeightSourcePtr input, TeMatrix matrix)
    : m_input(std::move(input)), m_matrix(std::move(matrix)),
      m_margin(reachesBeyondBorders(*m_input) ? m_matrix.radius() : 0) {}

std::uint64_t TeMatrixSource::fingerprint() const {
  std::uint64_t hash = teHashCombine(m_input->fingerprint(), teHashText("matrix"));
  for (double value : m_matrix.values())
    hash = teHashDouble(hash, value);
  return hash;
}

TeMapRequest TeMatrixSource::inputRequest(const TeMapRequest& request) const {
  TeMapRequest wider = request;
  wider.columns += 2 * m_margin;
  wider.rows += 2 * m_margin;
  wider.firstX -= m_margin;
  wider.firstY -= m_margin;
  return wider;
}

TeStatus TeMatrixSource::accepts(int columns, int rows) const {
  const std::int64_t wide = std::int64_t(columns) + 2 * m_margin;
  const std::int64_t high = std::int64_t(rows) + 2 * m_margin;
  if (wide * high > TeHeightMap::kMaxSamples)
    return TeError{"matrix: map size " + std::to_string(columns) + "x" + std::to_string(rows) + " with " +
                   std::to_string(m_margin) + " samples more on each side: more than " +
                   std::to_string(TeHeightMap::kMaxSamples) + " samples"};
  return m_input->accepts(int(wide), int(high));
}

std::unique_ptr<TeHeightJob> TeMatrixSource::start(const TeMapRequest& request) const {
  auto self = std::static_pointer_cast<const TeMatrixSource>(shared_from_this());
  return std::make_unique<TeMatrixJob>(std::move(self), m_input->start(inputRequest(request)));
}

float TeMatrixSource::mean(const float* heights, const double* coefficients, int count, float self) const {
  if (TeHeightMap::isMissing(self))
    return TeHeightMap::missing();
  double sum = 0;
  double used = 0;
  for (int i = 0; i < count; ++i) {
    if (TeHeightMap::isMissing(heights[i]))
      continue;
    sum += coefficients[i] * double(heights[i]);
    used += coefficients[i];
  }
  const float height = m_matrix.cancelsOut(used) ? TeHeightMap::missing() : float(sum / used);
  return std::isfinite(height) ? height : TeHeightMap::missing();
}

TeStatus TeMatrixSource::evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                                  float* heights) const {
  if (!pointEvaluable())
    return TeHeightSource::evaluate(request, samples, count, heights);
  const TeFloatEnvironment environment;
  const TeMapRequest wider = inputRequest(request);
  const int r = m_matrix.radius();
  std::vector<TeMapSample> around;
  std::vector<double> coefficients;
  std::vector<float> found;
  for (std::size_t i = 0; i < count; ++i) {
    const TeMapSample centre = {samples[i].column + m_margin, samples[i].row + m_margin};
    around.assign(1, centre);
    coefficients.clear();
    for (int row = std::max(0, centre.row - r); row <= std::min(wider.rows - 1, centre.row + r); ++row)
      for (int column = std::max(0, centre.column - r);
           column <= std::min(wider.columns - 1, centre.column + r); ++column) {
        around.push_back({column, row});
        coefficients.push_back(m_matrix.at(column - centre.column, row - centre.row));
      }
    found.resize(around.size());
    if (TeStatus ok = m_input->evaluate(wider, around.data(), around.size(), found.data()); !ok)
      return ok;
    heights[i] = mean(found.data() + 1, coefficients.data(), int(coefficients.size()), found[0]);
  }
  return {};
}
