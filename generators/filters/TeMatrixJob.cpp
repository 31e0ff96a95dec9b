#include "generators/filters/TeMatrixJob.h"

#include <algorithm>
#include <cmath>

namespace {
/// Products that one unit may take.
constexpr int kUnitProducts = 65536;
} // namespace

TeMatrixJob::TeMatrixJob(std::shared_ptr<const TeMatrixSource> source, std::unique_ptr<TeHeightJob> input)
    : m_source(std::move(source)), m_input(std::move(input)) {
  for (double value : m_source->matrix().values())
    m_whole += value;
}

TeProgress TeMatrixJob::unit() {
  if (m_input)
    return unitOfInput();
  const int side = m_source->matrix().side();
  const int count = std::min(std::max(1, kUnitProducts / (side * side)), m_map.width() - m_column);
  const int margin = m_source->margin();
  const int r = m_source->matrix().radius();
  const int row = m_row + margin;
  float* heights = m_map.row(m_row) + m_column;
  // The part of the run where the matrix is not cut, as columns of m_before.
  const bool rowInside = row >= r && row + r < m_before.height();
  const int begin = m_column + margin;
  const int end = begin + count;
  const int insideBegin = rowInside ? std::min(std::max(begin, r), end) : end;
  const int insideEnd = rowInside ? std::max(insideBegin, std::min(end, m_before.width() - r)) : end;
  for (int x = begin; x < insideBegin; ++x)
    heights[x - begin] = single(x);
  if (insideEnd > insideBegin)
    inside(insideBegin, insideEnd - insideBegin, heights + (insideBegin - begin));
  for (int x = insideEnd; x < end; ++x)
    heights[x - begin] = single(x);

  m_column += count;
  if (m_column == m_map.width()) {
    m_column = 0;
    ++m_row;
  }
  return m_row == m_map.height() ? TeProgress::Done : TeProgress::Working;
}

TeProgress TeMatrixJob::unitOfInput() {
  TeAllowance one = TeAllowance::units(1);
  const TeProgress progress = m_input->step(one);
  if (progress == TeProgress::Failed)
    return fail(m_input->error());
  if (progress == TeProgress::Working)
    return progress;
  m_before = m_input->takeMap();
  m_input.reset();
  const int margin = m_source->margin();
  TeResult<TeHeightMap> map =
      TeHeightMap::create(m_before.width() - 2 * margin, m_before.height() - 2 * margin);
  if (!map)
    return fail(map.error());
  m_map = std::move(*map);
  return TeProgress::Working;
}

void TeMatrixJob::inside(int column, int count, float* heights) {
  const TeMatrix& matrix = m_source->matrix();
  const int r = matrix.radius();
  m_sums.assign(std::size_t(count), 0.0);
  double* sums = m_sums.data();
  for (int dy = -r; dy <= r; ++dy)
    for (int dx = -r; dx <= r; ++dx) {
      const double coefficient = matrix.at(dx, dy);
      const float* in = m_before.row(m_row + m_source->margin() + dy) + column + dx;
      for (int i = 0; i < count; ++i)
        sums[i] += coefficient * double(in[i]);
    }
  for (int i = 0; i < count; ++i) {
    heights[i] = float(sums[i] / m_whole);
    if (!std::isfinite(heights[i])) // a missing sample is near, or a sum too large
      heights[i] = single(column + i);
  }
}

float TeMatrixJob::single(int column) const {
  const TeMatrix& matrix = m_source->matrix();
  const int r = matrix.radius();
  const int row = m_row + m_source->margin();
  float heights[TeMatrix::kMaxSide * TeMatrix::kMaxSide];
  double coefficients[TeMatrix::kMaxSide * TeMatrix::kMaxSide];
  int count = 0;
  for (int y = std::max(0, row - r); y <= std::min(m_before.height() - 1, row + r); ++y)
    for (int x = std::max(0, column - r); x <= std::min(m_before.width() - 1, column + r); ++x) {
      heights[count] = m_before.at(x, y);
      coefficients[count++] = matrix.at(x - column, y - row);
    }
  return m_source->mean(heights, coefficients, count, m_before.at(column, row));
}
