#include "generators/filters/TeMatrix.h"

#include "generators/base/TeText.h"

#include <charconv>
#include <cmath>
#include <string>

namespace {

TeStatus checkSide(int side) {
  if (side >= 1 && side <= TeMatrix::kMaxSide && side % 2 == 1)
    return {};
  return TeError{"matrix: side " + std::to_string(side) + " is not an odd number from 1 to " +
                 std::to_string(TeMatrix::kMaxSide)};
}

std::vector<double> binomials(int count) {
  std::vector<double> row(std::size_t(count), 1.0);
  for (int n = 1; n < count; ++n)
    for (int i = n - 1; i > 0; --i)
      row[std::size_t(i)] += row[std::size_t(i - 1)];
  return row;
}

} // namespace

TeMatrix::TeMatrix(int side, std::vector<double> values)
    : m_side(side), m_values(std::move(values)), m_sizeSum(0) {
  for (double value : m_values)
    m_sizeSum += std::fabs(value);
}

TeResult<TeMatrix> TeMatrix::box(int side) {
  if (TeStatus ok = checkSide(side); !ok)
    return ok.error();
  return TeMatrix(side, std::vector<double>(std::size_t(side) * std::size_t(side), 1.0));
}

TeResult<TeMatrix> TeMatrix::gauss(int side) {
  if (TeStatus ok = checkSide(side); !ok)
    return ok.error();
  const std::vector<double> line = binomials(side);
  std::vector<double> values;
  for (double row : line)
    for (double column : line)
      values.push_back(row * column);
  return TeMatrix(side, std::move(values));
}

TeResult<TeMatrix> TeMatrix::parse(std::string_view text) {
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto skipBlanks = [&] {
    while (at < end && (*at == ' ' || *at == '\t'))
      ++at;
  };
  for (skipBlanks(); at < end; skipBlanks()) {
    double value = 0;
    const std::from_chars_result result = std::from_chars(at, end, value);
    const bool separated = result.ptr == end || *result.ptr == ' ' || *result.ptr == '\t';
    // Sums and products with heights must stay far inside a double's range.
    if (result.ec != std::errc() || !separated || !(std::fabs(value) <= 1e100))
      return TeError{"matrix: coefficients " + teQuoted(text) + ", number " +
                     std::to_string(values.size() + 1) + ": not a number of at most 1e100"};
    values.push_back(value);
    at = result.ptr;
    if (values.size() > std::size_t(kMaxSide * kMaxSide))
      break;
  }
  for (int side = 1; side <= kMaxSide; side += 2)
    if (values.size() == std::size_t(side * side))
      return TeMatrix(side, std::move(values));
  return TeError{
      "matrix: coefficients " + teQuoted(text) + ": " +
      (values.size() > std::size_t(kMaxSide * kMaxSide) ? "too many" : std::to_string(values.size())) +
      " numbers; expected 1, 9, 25, ... (an odd side squared, up to " + std::to_string(kMaxSide) +
      " squared), or box or gauss"};
}

bool TeMatrix::cancelsOut(double sum) const { return !(std::fabs(sum) > 1e-6 * m_sizeSum); }

TeStatus TeMatrix::checkSums(bool cutAtBorders) const {
  // sums[y][x] = sum of the rows below y and columns below x, so that any rectangle's sum is four terms.
  const std::size_t stride = std::size_t(m_side) + 1;
  std::vector<double> sums(stride * stride, 0.0);
  for (std::size_t y = 1; y < stride; ++y)
    for (std::size_t x = 1; x < stride; ++x)
      sums[y * stride + x] = m_values[(y - 1) * std::size_t(m_side) + x - 1] + sums[(y - 1) * stride + x] +
                             sums[y * stride + x - 1] - sums[(y - 1) * stride + x - 1];
  const int cuts = cutAtBorders ? radius() : 0;
  for (int south = 0; south <= cuts; ++south)
    for (int north = 0; north <= cuts; ++north)
      for (int west = 0; west <= cuts; ++west)
        for (int east = 0; east <= cuts; ++east) {
          const std::size_t top = std::size_t(m_side - north) * stride;
          const std::size_t bottom = std::size_t(south) * stride;
          const std::size_t right = std::size_t(m_side - east);
          const std::size_t left = std::size_t(west);
          const double sum =
              sums[top + right] - sums[top + left] - sums[bottom + right] + sums[bottom + left];
          if (cancelsOut(sum))
            return TeError{"matrix: the coefficients' sum is zero" +
                           std::string(south + north + west + east
                                           ? " for the part of the matrix that remains at a border"
                                           : "") +
                           "; the sum divides the result and must not vanish"};
        }
  return {};
}
