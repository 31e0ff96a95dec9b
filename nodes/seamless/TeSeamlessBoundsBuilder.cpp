#include "nodes/seamless/TeSeamlessBoundsBuilder.h"

#include "patchdb/TeTargetClones.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace {

constexpr int kFewestRows = 16;

int bandRows(const TeSeamlessLayout& layout, std::size_t memory) {
  const std::size_t rowBytes = (std::size_t(layout.resolution()) + 1) * sizeof(float);
  int rows = layout.resolution();
  while (rows > kFewestRows && std::size_t(rows) * rowBytes > memory)
    rows /= 2;
  return rows;
}

float roundedUp(double number) {
  const float rounded = float(number);
  return double(rounded) < number ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

TE_TARGET_CLONES
void widen(const float* samples, int count, TeHeightRange& range) {
  constexpr int kLanes = 8;
  float low[kLanes], high[kLanes];
  std::fill(low, low + kLanes, range.low);
  std::fill(high, high + kLanes, range.high);
  int i = 0;
  for (; i + kLanes <= count; i += kLanes)
    for (int lane = 0; lane < kLanes; lane++) {
      const float sample = samples[i + lane];
      low[lane] = sample < low[lane] ? sample : low[lane];
      high[lane] = sample > high[lane] ? sample : high[lane];
    }
  range.low = *std::min_element(low, low + kLanes);
  range.high = *std::max_element(high, high + kLanes);
  for (; i < count; i++) {
    range.low = std::min(range.low, samples[i]);
    range.high = std::max(range.high, samples[i]);
  }
}

TE_TARGET_CLONES
std::int64_t countNotFinite(const float* samples, std::size_t count) {
  std::int64_t found = 0;
  for (std::size_t i = 0; i < count; i++)
    found += samples[i] - samples[i] == 0 ? 0 : 1;
  return found;
}

} // namespace

TeSeamlessBoundsBuilder::TeSeamlessBoundsBuilder(const TeSeamlessLayout& layout, std::size_t memory)
    : m_layout(layout), m_width(std::size_t(layout.resolution()) + 1), m_bandRows(bandRows(layout, memory)) {}

std::vector<TeSeamlessBoundsBuilder::Surface> TeSeamlessBoundsBuilder::surfaces() const {
  std::vector<Surface> surfaces;
  for (int level = 0; level < m_layout.depth(); level++)
    for (int index = 0; index <= m_layout.topIndex(level); index++) {
      Surface surface;
      surface.level = level;
      surface.index = index;
      surface.step = 1 << m_layout.spacingLog(level, index);
      surface.size = m_layout.cells(level);
      surface.finest = 1 << m_layout.spacingLog(level, m_layout.topIndex(level));
      if (surface.step > 1)
        surfaces.push_back(surface);
    }
  return surfaces;
}

TeResult<TeSeamlessBounds::Measured>
TeSeamlessBoundsBuilder::measure(const TeSeamlessBounds::ReadRows& read,
                                 const TeSeamlessBounds::Progress& progress) {
  const int deepest = m_layout.depth() - 1;
  for (int level = 0; level <= deepest; level++)
    m_measured.errors.emplace_back(std::size_t(m_layout.sideCount(level)) * std::size_t(m_layout.levels()));
  const float infinity = std::numeric_limits<float>::infinity();
  m_measured.ranges.assign(std::size_t(m_layout.patchesPerSide(deepest)) *
                               std::size_t(m_layout.patchesPerSide(deepest)),
                           {infinity, -infinity});
  m_band.resize(std::size_t(m_bandRows + 1) * m_width);
  if (TeStatus status = fetchVertices(read); !status)
    return status.error();
  for (m_first = 0; m_first < m_layout.resolution(); m_first += m_bandRows) {
    if (progress && !progress(double(m_first) / m_layout.resolution()))
      return TeError{"bounds of seamless patches: stopped"};
    if (TeStatus status = readBand(read, m_first); !status)
      return status.error();
    if (m_missing == 0)
      measureBand();
  }
  if (m_missing > 0)
    return TeError{"bounds of seamless patches: " + std::to_string(m_missing) +
                   " samples are missing or not finite"};
  if (progress && !progress(1))
    return TeError{"bounds of seamless patches: stopped"};
  return std::move(m_measured);
}

TeStatus TeSeamlessBoundsBuilder::fetchVertices(const TeSeamlessBounds::ReadRows& read) {
  int finest = 0;
  m_diagonals.resize(std::size_t(m_layout.depth()));
  for (const Surface& surface : surfaces()) {
    if (!isTall(surface.step))
      continue;
    const std::size_t patches = std::size_t(m_layout.patchesPerSide(surface.level));
    m_diagonals[std::size_t(surface.level)].resize(patches * patches * 2 * std::size_t(surface.size + 1));
    finest = finest == 0 ? surface.finest : std::min(finest, surface.finest);
  }
  if (finest == 0)
    return {};
  finest = std::min(finest, 2 * m_bandRows);
  m_gridSide = m_layout.resolution() / (2 * m_bandRows) + 1;
  m_grid.resize(std::size_t(m_gridSide) * std::size_t(m_gridSide));
  for (int row = 0; row <= m_layout.resolution(); row += finest) {
    if (TeStatus status = read(row, 1, m_band.data()); !status)
      return status;
    keepVertices(row, m_band.data());
  }
  return {};
}

void TeSeamlessBoundsBuilder::keepVertices(int row, const float* samples) {
  const int pitch = 2 * m_bandRows;
  if (row % pitch == 0)
    for (int i = 0; i < m_gridSide; i++)
      m_grid[std::size_t(row / pitch) * std::size_t(m_gridSide) + std::size_t(i)] = samples[i * pitch];
  for (const Surface& surface : surfaces()) {
    if (surface.index != 0 || !isTall(surface.step))
      continue;
    std::vector<float>& diagonals = m_diagonals[std::size_t(surface.level)];
    const int patches = m_layout.patchesPerSide(surface.level);
    // A row between patches belongs to both.
    for (int patchY = std::max(0, (row - 1) / surface.size); patchY < patches && patchY * surface.size <= row;
         patchY++)
      for (int patchX = 0; patchX < patches; patchX++) {
        const float* patch = samples + patchX * surface.size;
        const int y = row - patchY * surface.size;
        diagonals[diagonalStart(surface, patchX, patchY, true) + std::size_t(y)] = patch[y];
        diagonals[diagonalStart(surface, patchX, patchY, false) + std::size_t(y)] = patch[surface.size - y];
      }
  }
}

std::size_t TeSeamlessBoundsBuilder::diagonalStart(const Surface& surface, std::int32_t patchX,
                                                   std::int32_t patchY, bool rising) const {
  const std::size_t patches = std::size_t(m_layout.patchesPerSide(surface.level));
  return ((std::size_t(patchY) * patches + std::size_t(patchX)) * 2 + (rising ? 1 : 0)) *
         std::size_t(surface.size + 1);
}

TeStatus TeSeamlessBoundsBuilder::readBand(const TeSeamlessBounds::ReadRows& read, int first) {
  const std::size_t kept = first > 0 ? 1 : 0; // the last row of the band before
  if (kept)
    std::copy(m_band.end() - std::ptrdiff_t(m_width), m_band.end(), m_band.begin());
  float* samples = m_band.data() + kept * m_width;
  const int rows = m_bandRows + 1 - int(kept);
  if (TeStatus status = read(first + int(kept), rows, samples); !status)
    return status;
  m_missing += countNotFinite(samples, std::size_t(rows) * m_width);
  return {};
}

void TeSeamlessBoundsBuilder::measureBand() {
  const int end = m_first + m_bandRows;
  for (const Surface& surface : surfaces())
    for (int south = m_first / surface.step * surface.step; south < end; south += surface.step)
      for (std::int32_t x = 0; x < m_layout.patchesPerSide(surface.level); x++) {
        measureCells(surface, x, south);
        if (surface.step > surface.finest)
          measureFans(surface, x, south);
      }
  for (int row = m_first; row < end; row++)
    measureRanges(row);
  if (end == m_layout.resolution())
    measureRanges(end);
}

void TeSeamlessBoundsBuilder::measureRanges(int row) {
  const int deepest = m_layout.depth() - 1;
  const int size = m_layout.cells(deepest);
  const int patches = m_layout.patchesPerSide(deepest);
  for (int patchY = std::max(0, (row - 1) / size); patchY < patches && patchY * size <= row; patchY++)
    for (int patchX = 0; patchX < patches; patchX++)
      widen(bandRow(row) + patchX * size, size + 1,
            m_measured.ranges[std::size_t(patchY) * std::size_t(patches) + std::size_t(patchX)]);
}

void TeSeamlessBoundsBuilder::measureCells(const Surface& surface, std::int32_t patchX, int south) {
  const int size = surface.size;
  const int left = patchX * size;
  const int north = south + surface.step;
  const std::int32_t patchY = south / size;
  const int bottom = patchY * size;
  if (isTall(surface.step)) {
    const int pitch = 2 * m_bandRows;
    const auto gridRow = [&](int row) {
      return m_grid.data() + std::size_t(row / pitch) * std::size_t(m_gridSide) + left / pitch;
    };
    m_cells.set(gridRow(south), gridRow(north), surface.step / pitch, size, surface.step,
                south - bottom < size / 2);
  } else {
    m_cells.set(bandRow(south) + left, bandRow(north) + left, surface.step, size, surface.step,
                south - bottom < size / 2);
  }
  const int last = north == m_layout.resolution() ? north : north - 1;
  double west = 0, east = 0, below = 0, above = 0;
  for (int row = std::max(south, m_first); row <= std::min(last, m_first + m_bandRows); row++) {
    const float* samples = bandRow(row) + left;
    const int y = row - south;
    const int middle = std::min(row - bottom, bottom + size - row);
    double& outer = row - bottom <= size / 2 ? below : above;
    west = std::max(west, m_cells.deviation(samples, y, 0, middle));
    outer = std::max(outer, m_cells.deviation(samples, y, middle, size - middle));
    east = std::max(east, m_cells.deviation(samples, y, size - middle, size));
  }
  raise(surface, patchX, patchY, TeWest, west);
  raise(surface, patchX, patchY, TeEast, east);
  raise(surface, patchX, patchY, TeSouth, below);
  raise(surface, patchX, patchY, TeNorth, above);
}

void TeSeamlessBoundsBuilder::measureFans(const Surface& surface, std::int32_t patchX, int south) {
  measureFan(surface, patchX, south, true);
  measureFan(surface, patchX, south, false);
}

/// The cell on a diagonal of the patch, with a fan for the side to the south or north and one for the side to
/// the west or east.
void TeSeamlessBoundsBuilder::measureFan(const Surface& surface, std::int32_t patchX, int south, bool west) {
  const int step = surface.step;
  const std::int32_t patchY = south / surface.size;
  const int centreRow = patchY * surface.size + surface.size / 2;
  const bool southern = south < centreRow;
  const int nearRow = southern ? south + step : south;
  const int upward = southern ? -1 : 1;
  const int eastward = west ? -1 : 1;
  const int left = patchX * surface.size;
  const int nearColumn = left + surface.size / 2 + eastward * std::abs(nearRow - centreRow);
  const int farRow = nearRow + upward * step;
  const int farColumn = nearColumn + eastward * step;

  m_diagonal.resize(std::size_t(step) + 1);
  const bool tall = isTall(step);
  const std::vector<float>& kept = m_diagonals[std::size_t(surface.level)];
  for (int t = 0; t <= step; t += surface.finest) {
    const int row = nearRow + upward * t;
    m_diagonal[std::size_t(t)] = tall ? kept[diagonalStart(surface, patchX, patchY, upward == eastward) +
                                             std::size_t(row - patchY * surface.size)]
                                      : bandRow(row)[nearColumn + eastward * t];
  }
  for (const bool vertical : {true, false}) {
    m_fan.set(step, surface.finest, m_diagonal.data(),
              vertical ? vertex(surface, farRow, nearColumn) : vertex(surface, nearRow, farColumn));
    double largest = 0;
    for (int row = std::max(south, m_first); row < std::min(south + step, m_first + m_bandRows); row++) {
      TeSeamlessFan::Row samples;
      samples.corner = bandRow(row) + nearColumn;
      samples.direction = eastward;
      samples.across = std::abs(row - nearRow);
      samples.alongU = vertical;
      largest = std::max(largest, m_fan.deviation(samples));
    }
    const TeSide side = vertical ? (southern ? TeSouth : TeNorth) : (west ? TeWest : TeEast);
    raise(surface, patchX, patchY, side, largest);
  }
}

double TeSeamlessBoundsBuilder::vertex(const Surface& surface, int row, int column) const {
  if (!isTall(surface.step))
    return bandRow(row)[column];
  const int pitch = 2 * m_bandRows;
  return m_grid[std::size_t(row / pitch) * std::size_t(m_gridSide) + std::size_t(column / pitch)];
}

void TeSeamlessBoundsBuilder::raise(const Surface& surface, std::int32_t patchX, std::int32_t patchY,
                                    TeSide side, double deviation) {
  const std::int64_t index =
      m_layout.sideIndex(TeSeamlessLayout::sideOf(surface.level, patchX, patchY, side));
  float& error = m_measured.errors[std::size_t(surface.level)]
                                  [std::size_t(index * m_layout.levels()) + std::size_t(surface.index)];
  error = std::max(error, roundedUp(deviation));
}
