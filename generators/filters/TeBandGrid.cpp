#include "generators/filters/TeBandGrid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace {

constexpr int kPadding = TeBandKernel::kPadding;

int roundedUp(int n, int unit) { return (n + unit - 1) / unit * unit; }
int padded(int n) { return roundedUp(n, kPadding); }
int tiled(int n) { return roundedUp(n, TeBandKernel::kTile); }

/// Rows of a power of two of bytes apart would fall into the same few places of the cache.
int paddedStride(int width) {
  const int stride = padded(width);
  return stride % 256 == 0 ? stride + kPadding : stride;
}

int pieces(int length, int most) { return (length + most - 1) / most; }

} // namespace

TeStatus TeBandGrid::accepts(int width, int height) {
  constexpr std::int64_t kMostPadded = std::int64_t(1) << 24;
  const std::int64_t area = std::int64_t(width) * height;
  if (std::min(width, height) >= kPadding || area <= kMostPadded)
    return {};
  return TeError{"band: map size " + std::to_string(width) + "x" + std::to_string(height) + ": more than " +
                 std::to_string(kMostPadded) + " samples need sides of at least " + std::to_string(kPadding)};
}

TeBandGrid::TeBandGrid(int width, int height, const TeBandKernel& kernel)
    : m_kernel(kernel), m_width(width), m_height(height), m_stride(paddedStride(width)), m_carry(kUnitLines) {
  const std::size_t samples = std::size_t(m_stride) * std::size_t(padded(height));
  const int turnedSamples = turnedAtOnce() ? padded(width) : kUnitSamples;
  const std::size_t turned = std::size_t(turnedSamples) * std::size_t(std::min(kUnitLines, padded(height)));
  m_memory.resize(samples + turned + kPadding);
  const std::size_t misaligned = reinterpret_cast<std::uintptr_t>(m_memory.data()) / sizeof(float) % kPadding;
  m_samples = m_memory.data() + (kPadding - misaligned) % kPadding;
  m_turned = m_samples + samples;
}

void TeBandGrid::load(const TeHeightMap& map, int firstRow, int rows) {
  assert(map.width() == m_width && map.height() == m_height);
  for (int y = firstRow; y < firstRow + rows; ++y) {
    const float* in = map.row(y);
    float* out = m_samples + std::size_t(y) * m_stride;
    int unusual = 0;
    for (int x = 0; x < m_width; ++x) {
      out[x] = in[x];
      unusual |= !(std::fabs(in[x]) <= 1e38f);
    }
    m_careful = m_careful || unusual;
  }
}

void TeBandGrid::store(TeHeightMap& map, int firstRow, int rows) const {
  assert(map.width() == m_width && map.height() == m_height);
  for (int y = firstRow; y < firstRow + rows; ++y) {
    const float* in = m_samples + std::size_t(y) * m_stride;
    std::copy(in, in + m_width, map.row(y));
  }
}

void TeBandGrid::begin(float k, int passes, Axis axis) {
  m_k = k;
  m_passesLeft = passes;
  m_axis = axis;
  m_band = m_piece = 0;
  m_falling = false;
}

bool TeBandGrid::unit() {
  if (m_passesLeft == 0)
    return false;
  const Piece now = piece();
  if (m_axis == Axis::Rows)
    unitOfRows(now);
  else
    unitOfColumns(now);
  advance(now);
  return m_passesLeft > 0;
}

TeBandGrid::Piece TeBandGrid::piece() const {
  const bool rows = m_axis == Axis::Rows;
  const int length = rows ? m_width : m_height;
  // Bands of nearly equal width, in whole vectors.
  const int vectors = padded(rows ? m_height : m_width) / kPadding;
  const int bands = pieces(vectors * kPadding, kUnitLines);
  const int count = pieces(length, kUnitSamples);
  const int begin = int(std::int64_t(vectors) * m_band / bands) * kPadding;
  const int end = int(std::int64_t(vectors) * (m_band + 1) / bands) * kPadding;
  const int first = (m_falling ? count - 1 - m_piece : m_piece) * kUnitSamples;
  return {begin,        end - begin,         first, std::min(kUnitSamples, length - first),
          m_piece == 0, m_piece == count - 1};
}

// Short rows are turned once and back once; long ones on each way, so that the buffer stays in the cache.
void TeBandGrid::unitOfRows(const Piece& p) {
  float* corner = m_samples + std::ptrdiff_t(p.firstLine) * m_stride + p.firstSample;
  float* turned = m_turned + (turnedAtOnce() ? std::ptrdiff_t(p.firstSample) * p.lines : 0);
  float* last = turned + std::ptrdiff_t(p.samples - 1) * p.lines;
  const int lines = tiled(std::min(p.lines, m_height - p.firstLine));
  const bool bothWays = p.atStart && p.atEnd;
  const float* before = p.atStart ? nullptr : m_carry.data();
  if (!m_falling || !turnedAtOnce())
    m_kernel.transpose(corner, m_stride, lines, tiled(p.samples), turned, p.lines);
  if (!m_falling) {
    sweep(turned, p.lines, p.samples, p.lines, before);
    std::copy(last, last + p.lines, m_carry.begin());
  }
  if (m_falling || bothWays) {
    sweep(last, -p.lines, p.samples, p.lines, before);
    std::copy(turned, turned + p.lines, m_carry.begin());
  }
  if (m_falling || bothWays || !turnedAtOnce())
    m_kernel.transpose(turned, p.lines, tiled(p.samples), lines, corner, m_stride);
}

void TeBandGrid::unitOfColumns(const Piece& p) {
  float* first = m_samples + std::ptrdiff_t(p.firstSample) * m_stride + p.firstLine;
  float* last = first + std::ptrdiff_t(p.samples - 1) * m_stride;
  if (!m_falling) {
    sweep(first, m_stride, p.samples, p.lines, p.atStart ? nullptr : first - m_stride);
    if (p.atStart && p.atEnd)
      sweep(last, -m_stride, p.samples, p.lines, nullptr);
  } else {
    sweep(last, -m_stride, p.samples, p.lines, p.atStart ? nullptr : last + m_stride);
  }
}

/// Pieces, then the way back, then the next band, axis and pass.
void TeBandGrid::advance(const Piece& p) {
  if (!p.atEnd) {
    ++m_piece;
    return;
  }
  m_piece = 0;
  const bool bothWays = p.atStart || m_falling;
  m_falling = !bothWays;
  if (!bothWays)
    return;
  const int lines = padded(m_axis == Axis::Rows ? m_height : m_width);
  if (++m_band < pieces(lines, kUnitLines))
    return;
  m_band = 0;
  m_passesLeft -= m_axis == Axis::Columns;
  m_axis = m_axis == Axis::Rows ? Axis::Columns : Axis::Rows;
}

void TeBandGrid::sweep(float* row, std::ptrdiff_t step, int count, int width, const float* before) const {
  (m_careful ? m_kernel.sweepCareful : m_kernel.sweep)(row, step, count, width, before, m_k);
}
