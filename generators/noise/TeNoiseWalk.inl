#pragma once

#include "generators/noise/TeNoiseCell.inl"

/// Which cells of the lattice a block of samples lies in; part of TeNoiseLoops.inl, with the rules stated
/// there.
namespace {

constexpr int kBlock = 256; ///< samples worked on together; their arrays fit the first-level cache

std::uint64_t cellOf(TeNoiseCoordinate coordinate) { return std::uint64_t(coordinate >> 64); }
std::uint64_t fractionOf(TeNoiseCoordinate coordinate) {
  return std::uint64_t(coordinate) >> (64 - kFractionBits);
}

/// Where the samples of a block are: in a row, or anywhere.
struct Samples {
  int count;
  bool row;
  std::int64_t firstX, firstY; ///< of a row
  const std::int64_t* halfX;   ///< of samples anywhere
  const std::int64_t* halfY;
};

TeNoiseCoordinate coordinateX(const TeNoiseOctave& octave, std::int64_t halfX, std::int64_t halfY) {
  return TeNoiseCoordinate(halfX) * octave.along + TeNoiseCoordinate(halfY) * octave.across + octave.offsetX;
}
TeNoiseCoordinate coordinateY(const TeNoiseOctave& octave, std::int64_t halfX, std::int64_t halfY) {
  return TeNoiseCoordinate(halfY) * octave.along - TeNoiseCoordinate(halfX) * octave.across + octave.offsetY;
}

/// Coordinates of a block's samples in one octave.
struct Positions {
  std::uint64_t cellX[kBlock], cellY[kBlock];
  std::uint64_t fractionX[kBlock + kLanes], fractionY[kBlock + kLanes]; ///< in 2^-kFractionBits
};

void locate(const Samples& samples, const TeNoiseOctave& octave, Positions& at) {
  TeNoiseCoordinate x = coordinateX(octave, samples.firstX, samples.firstY);
  TeNoiseCoordinate y = coordinateY(octave, samples.firstX, samples.firstY);
  for (int j = 0; j < samples.count; ++j) {
    if (!samples.row) {
      x = coordinateX(octave, samples.halfX[j], samples.halfY[j]);
      y = coordinateY(octave, samples.halfX[j], samples.halfY[j]);
    }
    at.cellX[j] = cellOf(x);
    at.cellY[j] = cellOf(y);
    at.fractionX[j] = fractionOf(x);
    at.fractionY[j] = fractionOf(y);
    x += 2 * octave.along;
    y -= 2 * octave.across;
  }
}

/// Where a coordinate that grows by less than a cell a sample enters new cells. Without branches: they would
/// be mispredicted at every other cell.
class Crossings {
public:
  Crossings(std::uint64_t fraction, std::uint64_t step, std::uint64_t count) : m_step(step) {
    const std::uint64_t inCell = step == 0 ? count : ~std::uint64_t(0) / step;
    const std::uint64_t first = step == 0 ? count : ~fraction / step + 1;
    m_perCell = inCell < count ? inCell : count;
    m_next = first < count ? first : count;
    m_fraction = fraction + m_next * step;
  }

  /// The first sample in the next cell.
  std::uint64_t next() const { return m_next; }
  /// Goes on to the cell after that, if this is where sample j is.
  std::uint64_t passIf(bool here) {
    const std::uint64_t mask = 0 - std::uint64_t(here);
    const std::uint64_t advance = m_perCell * m_step;
    const std::uint64_t oneMore = m_fraction + advance >= m_fraction;
    m_next += (m_perCell + oneMore) & mask;
    m_fraction += (advance + (m_step & (0 - oneMore))) & mask;
    return here;
  }

private:
  std::uint64_t m_step;
  std::uint64_t m_perCell; ///< samples in a cell: this many, or one more
  std::uint64_t m_next;
  std::uint64_t m_fraction; ///< at sample m_next
};

/// The cells that successive samples of a block lie in, and the first sample in each.
struct Passage {
  int cells = 0;
  int first[kBlock + 1];
  std::uint64_t x[kBlock], y[kBlock];
};

/// Along a row, x growing and y falling by less than a cell a sample.
void walkRow(TeNoiseCoordinate startX, TeNoiseCoordinate startY, std::uint64_t stepX, std::uint64_t stepY,
             int samples, Passage& passage) {
  const std::uint64_t count = std::uint64_t(samples);
  Crossings eastward(std::uint64_t(startX), stepX, count);
  Crossings southward(~std::uint64_t(startY), stepY, count); // falls as its complement grows
  std::uint64_t cellX = cellOf(startX);
  std::uint64_t cellY = cellOf(startY);
  int cells = 0;
  for (std::uint64_t j = 0; j < count;) {
    passage.first[cells] = int(j);
    passage.x[cells] = cellX;
    passage.y[cells] = cellY;
    ++cells;
    const std::uint64_t x = eastward.next();
    const std::uint64_t y = southward.next();
    j = x < y ? x : y;
    cellX += eastward.passIf(x == j);
    cellY -= southward.passIf(y == j);
  }
  passage.first[cells] = samples;
  passage.cells = cells;
}

/// Along any path.
void walk(const Positions& at, int samples, Passage& passage) {
  int cells = 0;
  for (int j = 0; j < samples; ++j) {
    // The last entry is written again until the cell changes.
    cells += j > 0 && (at.cellX[j] != at.cellX[j - 1] || at.cellY[j] != at.cellY[j - 1]);
    passage.x[cells] = at.cellX[j];
    passage.y[cells] = at.cellY[j];
    passage.first[cells + 1] = j + 1;
  }
  passage.first[0] = 0;
  passage.cells = cells + 1;
}

} // namespace
