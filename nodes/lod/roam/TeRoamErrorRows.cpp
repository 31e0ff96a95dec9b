#include "nodes/lod/roam/TeRoamErrorRows.h"

#include "nodes/lod/TeLatticeTriangle.h"
#include "nodes/lod/TeTriangleDeviation.h"
#include "nodes/lod/roam/TeRoamFan.h"
#include "nodes/lod/roam/TeRoamTriangle.h"
#include "patchdb/TeTargetClones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

constexpr int kLargestAtOnce = 64; ///< cells of a square
constexpr int kFewestAtOnce = 16;  ///< squares a row

TE_TARGET_CLONES
void deviations(const float* sample, const float* a, const float* b, const float* c, double weightA,
                double weightB, double weightC, int count, double* worst) {
  for (int i = 0; i < count; i++) {
    const double plane = weightA * double(a[i]) + weightB * double(b[i]) + weightC * double(c[i]);
    const double deviation = std::fabs(double(sample[i]) - plane);
    worst[i] = deviation > worst[i] ? deviation : worst[i];
  }
}

float roundedUp(double value) {
  const float rounded = float(value);
  return double(rounded) < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

/// Twice the middle of edge k lies at corner k + corner k + 1; points as in TeRoamFan.
int pointX(int point) {
  const int k = point % 3;
  return point < 3 ? TeRoamTriangle::kCornerX[k]
                   : (TeRoamTriangle::kCornerX[k] + TeRoamTriangle::kCornerX[(k + 1) % 3]) / 2;
}
int pointY(int point) {
  const int k = point % 3;
  return point < 3 ? TeRoamTriangle::kCornerY[k]
                   : (TeRoamTriangle::kCornerY[k] + TeRoamTriangle::kCornerY[(k + 1) % 3]) / 2;
}

/// Corners of the ten parts, in halves of a square's side from its south-west.
struct Part {
  int x[3];
  int y[3];
};

std::vector<Part> makeParts() {
  std::vector<TeRoamFan::Triangle> chosen;
  const TeRoamFan::Triangle* children = TeRoamFan::all()[7].triangles.data();
  const auto sorted = [](TeRoamFan::Triangle triangle) {
    std::sort(triangle.begin(), triangle.end());
    return triangle;
  };
  for (int mask = 0; mask < 7; mask++) {
    const TeRoamFan& fan = TeRoamFan::all()[std::size_t(mask)];
    for (int i = 0; i < fan.count; i++) {
      const TeRoamFan::Triangle triangle = sorted(fan.triangles[std::size_t(i)]);
      const bool isChild = std::any_of(children, children + 4, [&](const TeRoamFan::Triangle& child) {
        return sorted(child) == triangle;
      });
      if (!isChild && std::find(chosen.begin(), chosen.end(), triangle) == chosen.end())
        chosen.push_back(triangle);
    }
  }
  std::vector<Part> parts;
  for (const TeRoamFan::Triangle& triangle : chosen) {
    Part part{};
    for (std::size_t k = 0; k < 3; k++) {
      part.x[k] = pointX(triangle[k]);
      part.y[k] = pointY(triangle[k]);
    }
    parts.push_back(part);
  }
  return parts;
}

const std::vector<Part>& parts() {
  static const std::vector<Part> made = makeParts();
  return made;
}

/// A part's corner in samples of a square.
TeLodVertex cornerOf(const Part& part, std::size_t k, bool upper, int side) {
  const int x = upper ? 2 - part.x[k] : part.x[k], y = upper ? 2 - part.y[k] : part.y[k];
  return {x * side / 2, y * side / 2, 0};
}

} // namespace

TeRoamErrorRows::TeRoamErrorRows(const TeHeightMap& heights, int side)
    : m_heights(&heights), m_side(side), m_squares((heights.width() - 1) / side) {
  if (side > kLargestAtOnce || m_squares < kFewestAtOnce)
    return;
  addTerms(false, m_terms[0]);
  addTerms(true, m_terms[1]);
  m_samples.resize(std::size_t(side + 1) * std::size_t(side + 1) * std::size_t(m_squares));
  m_worst.resize(std::size_t(m_squares));
}

void TeRoamErrorRows::addTerms(bool upper, std::vector<Term>& terms) const {
  const auto place = [&](int column, int row) { return row * (m_side + 1) + column; };
  for (const Part& part : parts()) {
    const TeLodVertex a = cornerOf(part, 0, upper, m_side), b = cornerOf(part, 1, upper, m_side),
                      c = cornerOf(part, 2, upper, m_side);
    const auto area = [](const TeLodVertex& p, const TeLodVertex& q, const TeLodVertex& r) {
      return (q.column - p.column) * (r.row - p.row) - (r.column - p.column) * (q.row - p.row);
    };
    const double whole = area(a, b, c);
    const TeLatticeTriangle triangle(a, b, c);
    for (int row = triangle.firstRow(); row <= triangle.lastRow(); row++) {
      const TeLatticeTriangle::Span span = triangle.span(row);
      for (int column = span.first; column <= span.last; column++) {
        const TeLodVertex sample{column, row, 0};
        const int parts[3] = {area(sample, b, c), area(a, sample, c), area(a, b, sample)};
        if ((parts[0] == 0) + (parts[1] == 0) + (parts[2] == 0) == 2)
          continue; // a corner
        terms.push_back({place(column, row),
                         {place(a.column, a.row), place(b.column, b.row), place(c.column, c.row)},
                         {parts[0] / whole, parts[1] / whole, parts[2] / whole}});
      }
    }
  }
}

void TeRoamErrorRows::gather(int row) {
  const std::size_t squares = std::size_t(m_squares);
  for (int y = 0; y <= m_side; y++) {
    const float* from = m_heights->row(row * m_side + y);
    for (int x = 0; x <= m_side; x++) {
      float* to = m_samples.data() + std::size_t(y * (m_side + 1) + x) * squares;
      for (std::size_t i = 0; i < squares; i++)
        to[i] = from[std::size_t(x) + i * std::size_t(m_side)];
    }
  }
}

void TeRoamErrorRows::measure(int row, float* lower, float* upper) {
  if (m_samples.empty()) {
    measureEach(row, false, lower);
    measureEach(row, true, upper);
    return;
  }
  gather(row);
  measureAtOnce(m_terms[0], lower);
  measureAtOnce(m_terms[1], upper);
}

void TeRoamErrorRows::measureAtOnce(const std::vector<Term>& terms, float* errors) {
  std::fill(m_worst.begin(), m_worst.end(), 0.0);
  const auto samples = [&](int place) {
    return m_samples.data() + std::size_t(place) * std::size_t(m_squares);
  };
  for (const Term& term : terms)
    deviations(samples(term.sample), samples(term.corners[0]), samples(term.corners[1]),
               samples(term.corners[2]), term.weights[0], term.weights[1], term.weights[2], m_squares,
               m_worst.data());
  std::transform(m_worst.begin(), m_worst.end(), errors, roundedUp);
}

void TeRoamErrorRows::measureEach(int row, bool upper, float* errors) const {
  for (int square = 0; square < m_squares; square++) {
    errors[square] = 0;
    for (const Part& part : parts()) {
      TeLodVertex corners[3];
      for (std::size_t k = 0; k < 3; k++) {
        corners[k] = cornerOf(part, k, upper, m_side);
        corners[k].column += square * m_side;
        corners[k].row += row * m_side;
        corners[k].height = m_heights->at(corners[k].column, corners[k].row);
      }
      errors[square] =
          std::max(errors[square], teTriangleDeviation(*m_heights, corners[0], corners[1], corners[2]));
    }
  }
}
