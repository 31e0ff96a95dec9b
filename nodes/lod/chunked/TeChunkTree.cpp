#include "nodes/lod/chunked/TeChunkTree.h"

#include "nodes/lod/TeTriangleDeviation.h"
#include "nodes/lod/chunked/TeChunkTriangles.h"
#include "nodes/lod/rtin/TeRtinErrors.h"
#include "patchdb/TeTargetClones.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace {

TE_TARGET_CLONES
void countBelow(const float* errors, std::size_t count, float threshold, std::uint8_t* levels) {
  for (std::size_t i = 0; i < count; i++)
    levels[i] = std::uint8_t(levels[i] + (errors[i] > threshold ? 1 : 0));
}

/// What a quarter of the errors that are not 0 exceed, of some tens of thousands of them.
float usualError(const std::vector<float>& errors) {
  constexpr std::size_t kLooked = 65536;
  const std::size_t step = errors.size() / kLooked | 1; // odd: not the vertices of coarse levels alone
  std::vector<float> some;
  for (std::size_t i = 0; i < errors.size(); i += step)
    if (errors[i] > 0)
      some.push_back(errors[i]);
  if (some.empty())
    return 0;
  const auto place = some.begin() + std::ptrdiff_t(some.size() * 3 / 4);
  std::nth_element(some.begin(), place, some.end());
  return *place;
}

float roundedUp(double value) {
  const float rounded = float(value);
  return double(rounded) < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

/// Corners on their samples.
struct Samples {
  const TeLodField& field;
  TeLodVertex at(int column, int row) { return field.vertex(column, row); }
  TeLodVertex middle(const TeLodVertex&, const TeLodVertex&, int column, int row) {
    return field.vertex(column, row);
  }
};

/// Measures the triangles of a chunk.
struct Measure {
  const TeHeightMap& heights;
  TeChunkTree::Square square;
  TeChunkTree::Chunk& chunk;

  void operator()(const TeLodVertex& a, const TeLodVertex& b, const TeLodVertex& apex) {
    chunk.triangles++;
    const int size = std::abs(a.column - b.column) + std::abs(a.row - b.row);
    const bool isCell = size == 2 && a.column != b.column && a.row != b.row;
    if (!isCell)
      chunk.error = std::max(chunk.error, teTriangleDeviation(heights, a, b, apex));
    addBorder(a, b);
    addBorder(b, apex);
    addBorder(apex, a);
  }

  void addBorder(const TeLodVertex& from, const TeLodVertex& to) {
    int side = -1;
    if (from.row == to.row && (from.row == square.row || from.row == square.row + square.cells))
      side = from.row == square.row ? 0 : 2;
    else if (from.column == to.column &&
             (from.column == square.column || from.column == square.column + square.cells))
      side = from.column == square.column ? 3 : 1;
    if (side < 0)
      return;
    chunk.borderEdges[std::size_t(side)]++;
    const int dx = to.column - from.column, dy = to.row - from.row;
    const int steps = std::max(std::abs(dx), std::abs(dy));
    double worst = 0;
    for (int i = 1; i < steps; i++) {
      const double height = double(heights.at(from.column + dx / steps * i, from.row + dy / steps * i));
      const double drawn =
          double(from.height) + (double(to.height) - double(from.height)) * double(i) / double(steps);
      worst = std::max(worst, std::fabs(height - drawn));
    }
    float& error = chunk.borderErrors[std::size_t(side)];
    error = std::max(error, roundedUp(worst));
  }
};

} // namespace

TeChunkTree::TeChunkTree(TeLodFieldPtr field, int leafCells, float firstError)
    : m_field(std::move(field)), m_leafCells(leafCells), m_width(std::size_t(m_field->cells()) + 1) {
  assert(leafCells > 0 && m_field->cells() % leafCells == 0);
  while (cells(m_levels - 1) < m_field->cells())
    m_levels++;
  std::size_t count = 0;
  for (int level = 0; level < m_levels; level++) {
    m_first.push_back(count);
    count += std::size_t(chunks(level)) * std::size_t(chunks(level));
  }
  m_chunks.resize(count);
  markVertices(firstError);
  for (int level = 0; level < m_levels; level++) {
    float largest = level == 0 ? 0 : m_largestErrors.back();
    for (int y = 0; y < chunks(level); y++)
      for (int x = 0; x < chunks(level); x++) {
        measure(level, x, y);
        largest = std::max(largest, chunk(level, x, y).error);
      }
    m_largestErrors.push_back(largest);
  }
}

void TeChunkTree::markVertices(float firstError) {
  const std::vector<float> errors = TeRtinErrors::create(field().heights(), TeRtinError::Exact);
  if (firstError < 0)
    firstError = usualError(errors);
  m_vertexLevels.resize(errors.size());
  m_levelErrors.push_back(0);
  for (int level = 1; level < m_levels; level++) {
    m_levelErrors.push_back(std::ldexp(firstError, level - 1));
    countBelow(errors.data(), errors.size(), levelError(level), m_vertexLevels.data());
  }
}

TeChunkTree::Square TeChunkTree::square(int level, int x, int y) const {
  const int side = cells(level);
  return {x * side, y * side, side, (x + y) % 2 == 0};
}

TeLodBox TeChunkTree::box(int level, int x, int y) const {
  const Square square = this->square(level, x, y);
  const Chunk& chunk = this->chunk(level, x, y);
  return {field().position(square.column, square.row, double(chunk.low)),
          field().position(square.column + square.cells, square.row + square.cells, double(chunk.high))};
}

void TeChunkTree::measure(int level, int x, int y) {
  Chunk& chunk = m_chunks[number(level, x, y)];
  const Square square = this->square(level, x, y);
  if (level == 0) {
    const TeMapStatistics statistics =
        field().heights().statistics({square.column, square.row, square.cells + 1, square.cells + 1}).value();
    chunk.low = statistics.minimum;
    chunk.high = statistics.maximum;
    chunk.triangles = 2 * square.cells * square.cells;
    chunk.borderEdges.fill(square.cells);
    return;
  }
  chunk.low = field().highest();
  chunk.high = field().lowest();
  for (const int child : {0, 1, 2, 3}) {
    const Chunk& part = this->chunk(level - 1, 2 * x + child % 2, 2 * y + child / 2);
    chunk.low = std::min(chunk.low, part.low);
    chunk.high = std::max(chunk.high, part.high);
  }
  Samples samples{field()};
  Measure measure{field().heights(), square, chunk};
  TeChunkTriangles<TeLodVertex, Samples, Measure>(*this, level, false, samples, measure).walk(x, y);
}
