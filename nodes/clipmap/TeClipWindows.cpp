#include "nodes/clipmap/TeClipWindows.h"

#include "generators/base/TeLog.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t kMostUploads = 1024; ///< that wait; beyond, whole images are cheaper to tell

TeSampleRect intersection(const TeSampleRect& a, const TeSampleRect& b) {
  TeSampleRect both;
  both.x = std::max(a.x, b.x);
  both.y = std::max(a.y, b.y);
  both.columns = std::max(0, std::min(a.x + a.columns, b.x + b.columns) - both.x);
  both.rows = std::max(0, std::min(a.y + a.rows, b.y + b.rows) - both.y);
  return both;
}

bool isSame(const TeSampleRect& a, const TeSampleRect& b) {
  return a.x == b.x && a.y == b.y && a.columns == b.columns && a.rows == b.rows;
}

/// Calls piece(first, count, texel) for the runs of samples that lie side by side in an image of that side.
template <class Piece>
void forEachRun(std::int32_t first, std::int32_t count, std::int32_t side, Piece piece) {
  while (count > 0) {
    const std::int32_t texel = first % side;
    const std::int32_t run = std::min(count, side - texel);
    piece(first, run, texel);
    first += run;
    count -= run;
  }
}

std::int32_t towards(std::int32_t from, std::int32_t to, std::int32_t steps) {
  return to > from ? from + steps : from - steps;
}

} // namespace

int TeClipWindows::wholeLevel(int size) {
  int level = 0;
  while (level < TePyramidReader::kMaxLevel && tePyramidSide(level + 1) <= size)
    level++;
  return level;
}

TeResult<std::unique_ptr<TeClipWindows>> TeClipWindows::create(std::shared_ptr<TePyramidTiles> tiles,
                                                               int size, int maxLevel) {
  assert(tiles);
  const TePyramidReader& reader = tiles->reader();
  if (size < kMinSize || size > kMaxSize)
    return TeError{reader.name() + ": clip size " + std::to_string(size) + " is not from " +
                   std::to_string(kMinSize) + " to " + std::to_string(kMaxSize)};
  const int base = reader.baseLevel();
  if (base > wholeLevel(size))
    return TeError{reader.name() + ": level " + std::to_string(base) +
                   ", the lowest that is open, is not whole in " + "a clip size of " + std::to_string(size)};
  if (maxLevel >= 0 && maxLevel < base)
    return TeError{reader.name() + ": highest level " + std::to_string(maxLevel) + " is below level " +
                   std::to_string(base) + ", the lowest that is open"};
  const int top = maxLevel < 0 ? reader.topLevel() : std::min(maxLevel, reader.topLevel());
  if (base < std::min(top, wholeLevel(size)))
    return TeError{reader.name() + ": level " + std::to_string(base) +
                   " is the lowest that is open; a clip size of " + std::to_string(size) + " has level " +
                   std::to_string(wholeLevel(size)) + " whole"};
  std::unique_ptr<TeClipWindows> made(new TeClipWindows(std::move(tiles), size, base, top - base + 1));
  try {
    for (Level& level : made->m_levels)
      level.image.resize(made->imageBytes());
  } catch (const std::bad_alloc&) {
    return TeError{"not enough memory for " + std::to_string(made->levels()) + " clip windows of " +
                   std::to_string(size) + "x" + std::to_string(size) + " samples"};
  }
  const std::int32_t side = tePyramidSide(base);
  Level& whole = made->m_levels.front();
  whole.target = {0, 0, side, side};
  if (TeStatus ok = made->m_tiles->read(base, whole.target, whole.image.data(), made->rowBytes()); !ok)
    return ok.error();
  whole.held = whole.target;
  made->note(base, whole.held);
  made->updateResidency();
  return made;
}

TeClipWindows::TeClipWindows(std::shared_ptr<TePyramidTiles> tiles, int size, int base, int levels)
    : m_tiles(std::move(tiles)), m_base(base), m_side(levels > 1 ? size : tePyramidSide(base)),
      m_bytesPerSample(m_tiles->bytesPerSample()), m_levels(std::size_t(levels)) {}

void TeClipWindows::update(glm::dvec2 centre, int level, std::size_t budget) {
  assert(level >= 0 && level <= TePyramidReader::kMaxLevel);
  if (!std::isfinite(centre.x) || !std::isfinite(centre.y))
    return;
  centre = glm::clamp(centre, glm::dvec2(0), glm::dvec2(std::ldexp(1.0, level)));
  std::int64_t samples = std::numeric_limits<std::int64_t>::max();
  if (budget > 0 && budget / std::size_t(m_bytesPerSample) < std::size_t(samples))
    samples = std::max<std::int64_t>(m_side, std::int64_t(budget / std::size_t(m_bytesPerSample)));
  for (int i = m_base + 1; i <= topLevel(); i++) {
    Level& moved = m_levels[std::size_t(i - m_base)];
    const TeSampleRect before = moved.target;
    moved.target = targetFor(i, centre * std::ldexp(1.0, i - level));
    moved.motion = before.isEmpty() ? 0 : moved.target.count() - intersection(before, moved.target).count();
  }
  bool isUsable = true;
  for (int i = m_base + 1; i <= topLevel() && isUsable; i++) {
    const Level& moved = m_levels[std::size_t(i - m_base)];
    if (!moved.hasFailed)
      samples -= follow(i, samples);
    isUsable = !moved.hasFailed && isWhole(moved) && isNested(i);
  }
  updateResidency();
}

TeSampleRect TeClipWindows::targetFor(int level, glm::dvec2 centre) const {
  const std::int32_t last = tePyramidSide(level) - m_side;
  const glm::dvec2 corner = glm::floor(centre - 0.5 * (m_side - 1) + 0.5);
  return {std::clamp(std::int32_t(corner.x), 0, last), std::clamp(std::int32_t(corner.y), 0, last), m_side,
          m_side};
}

bool TeClipWindows::isNested(int level) const {
  if (level <= m_base + 1)
    return true;
  const TeSampleRect& inner = m_levels[std::size_t(level - m_base)].held;
  const TeSampleRect& outer = m_levels[std::size_t(level - 1 - m_base)].held;
  const std::int32_t reach = 2 * (m_side - 1);
  return inner.x >= 2 * outer.x && inner.y >= 2 * outer.y && inner.x + m_side - 1 <= 2 * outer.x + reach &&
         inner.y + m_side - 1 <= 2 * outer.y + reach;
}

std::int64_t TeClipWindows::follow(int level, std::int64_t samples) {
  Level& moved = m_levels[std::size_t(level - m_base)];
  TeSampleRect& held = moved.held;
  TeSampleRect to = moved.target;
  if (isSame(held, to))
    return 0;
  TeSampleRect common = intersection(held, to);
  const std::int64_t missing = to.count() - common.count();
  if (isWhole(moved) && missing > samples) {
    const std::int32_t right = std::abs(to.x - held.x);
    const std::int32_t up = std::abs(to.y - held.y);
    if (right + up < m_side && isNested(level)) {
      // Some of the way, in proportion: so it stays whole while it lags.
      const auto lines = std::int32_t(samples / m_side);
      std::int32_t columns = std::int32_t(std::int64_t(lines) * right / (right + up));
      const std::int32_t rows = std::min(up, lines - columns);
      columns = std::min(right, lines - rows);
      if (columns + rows == 0)
        return 0;
      to.x = towards(held.x, to.x, columns);
      to.y = towards(held.y, to.y, rows);
      held = intersection(held, to);
      m_statistics.windowMoves++;
      return extend(level, to, samples);
    }
  }
  // Too little for a row; or more comes in with each update than can be loaded, so that it would never be
  // whole.
  if (missing > samples && (samples < m_side || moved.motion > samples))
    return 0;
  if (isWhole(moved) && !common.isEmpty())
    m_statistics.windowMoves++;
  else if (common.isEmpty())
    m_statistics.reloads++;
  held = common;
  return extend(level, to, samples);
}

std::int64_t TeClipWindows::extend(int level, const TeSampleRect& to, std::int64_t samples) {
  TeSampleRect& held = m_levels[std::size_t(level - m_base)].held;
  std::int64_t taken = 0;
  // What fits of `wanted` lines that cost `line` samples each.
  const auto lines = [&](std::int32_t wanted, std::int32_t line) {
    return std::int32_t(std::min<std::int64_t>(wanted, (samples - taken) / line));
  };
  const auto add = [&](const TeSampleRect& rect) {
    taken += rect.count();
    return load(level, rect);
  };
  if (held.isEmpty()) {
    // From the middle, which stays wanted for longest while the viewer moves on.
    held = {to.x, to.y + to.rows / 2, to.columns, 0};
    if (samples >= to.count())
      held.y = to.y;
  } else {
    const std::int32_t west = lines(held.x - to.x, held.rows);
    if (!add({held.x - west, held.y, west, held.rows}))
      return taken;
    held.x -= west;
    held.columns += west;
    const std::int32_t east = lines(to.x + to.columns - held.x - held.columns, held.rows);
    if (!add({held.x + held.columns, held.y, east, held.rows}))
      return taken;
    held.columns += east;
  }
  if (held.columns < to.columns)
    return taken;
  const std::int32_t south = lines(held.y - to.y, held.columns);
  if (!add({held.x, held.y - south, held.columns, south}))
    return taken;
  held.y -= south;
  held.rows += south;
  const std::int32_t north = lines(to.y + to.rows - held.y - held.rows, held.columns);
  if (!add({held.x, held.y + held.rows, held.columns, north}))
    return taken;
  held.rows += north;
  return taken;
}

bool TeClipWindows::load(int number, const TeSampleRect& rect) {
  Level& level = m_levels[std::size_t(number - m_base)];
  TeStatus status;
  forEachRun(rect.y, rect.rows, m_side, [&](std::int32_t y, std::int32_t rows, std::int32_t row) {
    forEachRun(rect.x, rect.columns, m_side, [&](std::int32_t x, std::int32_t columns, std::int32_t column) {
      if (!status || columns == 0)
        return;
      const TeSampleRect texels{column, row, columns, rows};
      unsigned char* image = level.image.data() + std::size_t(row) * rowBytes() +
                             std::size_t(column) * std::size_t(m_bytesPerSample);
      status = m_tiles->read(number, {x, y, columns, rows}, image, rowBytes());
      if (status)
        note(number, texels);
    });
  });
  if (status)
    return true;
  level.hasFailed = true;
  level.held = {};
  TeLog::warning(status.error().message + "; level " + std::to_string(number - 1) + " stands for level " +
                 std::to_string(number) + (number < topLevel() ? " and those above" : ""));
  return false;
}

void TeClipWindows::note(int level, const TeSampleRect& texels) {
  m_statistics.samplesUploaded += texels.count();
  m_statistics.bytesUploaded += texels.count() * m_bytesPerSample;
  if (m_uploads.size() < kMostUploads)
    m_uploads.push_back({level, texels});
  else
    m_uploads = allUploads();
}

void TeClipWindows::updateResidency() {
  m_residency.base = m_base;
  m_residency.windows.assign(m_levels.size(), TeClipWindow());
  m_residency.windows[0].side = m_levels[0].held.columns;
  for (std::size_t i = 1; i < m_levels.size(); i++) {
    const Level& level = m_levels[i];
    if (level.hasFailed || !isWhole(level) || !isNested(m_base + int(i)))
      return;
    m_residency.windows[i] = {level.held.x, level.held.y, m_side};
  }
}

bool TeClipWindows::isSettled() const {
  for (std::size_t i = 1; i < m_levels.size(); i++) {
    const Level& level = m_levels[i];
    if (level.hasFailed)
      return true;
    if (level.target.isEmpty() || !isSame(level.held, level.target))
      return false;
  }
  return true;
}

std::vector<TeClipUpload> TeClipWindows::allUploads() const {
  std::vector<TeClipUpload> uploads;
  for (std::size_t i = 0; i < m_levels.size(); i++) {
    // Whole images where not all is held, too: what is not gets written before it is used.
    const TeSampleRect& held = m_levels[i].held;
    if (i == 0)
      uploads.push_back({m_base, held});
    else if (!held.isEmpty())
      uploads.push_back({m_base + int(i), {0, 0, m_side, m_side}});
  }
  return uploads;
}

const unsigned char* TeClipWindows::samples(const TeClipUpload& upload) const {
  const Level& level = m_levels[std::size_t(upload.level - m_base)];
  return level.image.data() + std::size_t(upload.texels.y) * rowBytes() +
         std::size_t(upload.texels.x) * std::size_t(m_bytesPerSample);
}

const unsigned char* TeClipWindows::sample(int level, std::int32_t x, std::int32_t y) const {
  if (level < m_base) {
    x <<= m_base - level;
    y <<= m_base - level;
    level = m_base;
  }
  if (level > topLevel())
    return nullptr;
  const TeSampleRect& held = m_levels[std::size_t(level - m_base)].held;
  if (x < held.x || y < held.y || x >= held.x + held.columns || y >= held.y + held.rows)
    return nullptr;
  return samples({level, {x % m_side, y % m_side, 1, 1}});
}

std::uint16_t TeClipWindows::height(int level, std::int32_t x, std::int32_t y) const {
  const unsigned char* bytes = sample(level, x, y);
  assert(bytes && m_bytesPerSample == 2);
  return std::uint16_t(bytes[0] | bytes[1] << 8);
}
