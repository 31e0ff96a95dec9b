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
  const int lowest = reader.baseLevel();
  if (lowest > wholeLevel(size))
    return TeError{reader.name() + ": level " + std::to_string(lowest) +
                   ", the lowest that is open, is not whole in a clip size of " + std::to_string(size)};
  const int top = maxLevel < 0 ? reader.topLevel() : std::min(maxLevel, reader.topLevel());
  if (lowest < std::min(top, wholeLevel(size)))
    return TeError{reader.name() + ": level " + std::to_string(lowest) +
                   " is the lowest that is open; a clip size of " + std::to_string(size) + " has level " +
                   std::to_string(wholeLevel(size)) + " whole"};
  const int base = std::min(lowest, top);
  try {
    std::unique_ptr<TeClipWindows> made(new TeClipWindows(std::move(tiles), size, base, top - base + 1));
    Level& whole = made->m_levels.front();
    if (TeStatus ok = whole.image.loadWhole(*made->m_tiles, lowest); !ok)
      return ok.error();
    whole.target = whole.image.held();
    made->note(base, whole.target);
    made->updateResidency();
    return made;
  } catch (const std::bad_alloc&) {
    return TeError{"not enough memory for " + std::to_string(top - base + 1) + " clip windows of " +
                   std::to_string(size) + "x" + std::to_string(size) + " samples"};
  }
}

TeClipWindows::TeClipWindows(std::shared_ptr<TePyramidTiles> tiles, int size, int base, int levels)
    : m_tiles(std::move(tiles)), m_base(base), m_side(levels > 1 ? size : tePyramidSide(base)),
      m_bytesPerSample(m_tiles->bytesPerSample()) {
  for (int level = base; level < base + levels; level++)
    m_levels.push_back({TeClipImage(level, m_side, m_bytesPerSample), {}, 0});
}

void TeClipWindows::update(glm::dvec2 centre, int level, std::size_t budget) {
  assert(level >= 0 && level <= TePyramidReader::kMaxLevel);
  if (!std::isfinite(centre.x) || !std::isfinite(centre.y))
    return;
  centre = glm::clamp(centre, glm::dvec2(0), glm::dvec2(std::ldexp(1.0, level)));
  std::int64_t samples = std::numeric_limits<std::int64_t>::max();
  if (budget > 0)
    samples = std::max<std::int64_t>(m_side, std::int64_t(budget / std::size_t(m_bytesPerSample)));
  for (int i = m_base + 1; i <= topLevel(); i++) {
    Level& moved = at(i);
    const TeSampleRect before = moved.target;
    moved.target = targetFor(i, centre * std::ldexp(1.0, i - level));
    moved.motion = before.isEmpty() ? 0 : moved.target.count() - teIntersection(before, moved.target).count();
  }
  bool isUsable = true;
  for (int i = m_base + 1; i <= topLevel() && isUsable; i++) {
    const TeClipImage& image = at(i).image;
    if (!image.hasFailed())
      samples -= follow(i, samples);
    isUsable = image.isWhole() && isNested(i);
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
  const TeSampleRect& inner = at(level).image.held();
  const TeSampleRect& outer = at(level - 1).image.held();
  const std::int32_t reach = 2 * (m_side - 1);
  return inner.x >= 2 * outer.x && inner.y >= 2 * outer.y && inner.x + m_side - 1 <= 2 * outer.x + reach &&
         inner.y + m_side - 1 <= 2 * outer.y + reach;
}

std::int64_t TeClipWindows::follow(int level, std::int64_t samples) {
  Level& moved = at(level);
  const TeSampleRect before = moved.image.held();
  TeSampleRect window = moved.target;
  const bool isWhole = moved.image.isWhole();
  const std::int64_t missing = window.count() - teIntersection(before, window).count();
  if (missing == 0)
    return 0;
  if (missing > samples) {
    if (isWhole)
      window = partOfTheWay(moved, level, samples);
    // Too little for a row; or more comes in with each update than can be loaded, so that it would never be
    // whole.
    const bool isLoaded = window == moved.target;
    if (window == before || samples < m_side || (isLoaded && moved.motion > samples))
      return 0;
  }
  if (teIntersection(before, window).isEmpty())
    m_statistics.reloads++;
  else if (isWhole)
    m_statistics.windowMoves++;
  m_places.clear();
  const TeResult<std::int64_t> taken = moved.image.follow(*m_tiles, window, samples, m_places);
  for (const TeSampleRect& texels : m_places)
    note(level, texels);
  if (taken)
    return *taken;
  TeLog::warning(taken.error().message + "; level " + std::to_string(level - 1) + " stands for level " +
                 std::to_string(level) + (level < topLevel() ? " and those above" : ""));
  return 0;
}

TeSampleRect TeClipWindows::partOfTheWay(const Level& moved, int level, std::int64_t samples) const {
  TeSampleRect window = moved.image.held();
  const std::int32_t right = std::abs(moved.target.x - window.x);
  const std::int32_t up = std::abs(moved.target.y - window.y);
  if (right + up >= m_side || !isNested(level))
    return moved.target;
  const auto lines = std::int32_t(std::min<std::int64_t>(samples / m_side, right + up));
  std::int32_t columns = std::int32_t(std::int64_t(lines) * right / (right + up));
  const std::int32_t rows = std::min(up, lines - columns);
  columns = std::min(right, lines - rows);
  window.x = towards(window.x, moved.target.x, columns);
  window.y = towards(window.y, moved.target.y, rows);
  return window;
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
  m_residency.windows[0].side = m_levels[0].image.held().columns;
  for (int i = m_base + 1; i <= topLevel(); i++) {
    const TeClipImage& image = at(i).image;
    if (!image.isWhole() || !isNested(i))
      return;
    m_residency.windows[std::size_t(i - m_base)] = {image.held().x, image.held().y, m_side};
  }
}

bool TeClipWindows::isSettled() const {
  for (int i = m_base + 1; i <= topLevel() && !at(i).image.hasFailed(); i++) {
    if (at(i).target.isEmpty() || at(i).image.held() != at(i).target)
      return false;
  }
  return true;
}

std::vector<TeClipUpload> TeClipWindows::allUploads() const {
  std::vector<TeClipUpload> uploads = {{m_base, m_levels.front().image.held()}};
  // Whole images where not all is held, too: what is not gets written before it is used.
  for (int i = m_base + 1; i <= topLevel(); i++) {
    if (!at(i).image.held().isEmpty())
      uploads.push_back({i, {0, 0, m_side, m_side}});
  }
  return uploads;
}

const unsigned char* TeClipWindows::samples(const TeClipUpload& upload) const {
  return at(upload.level).image.place(upload.texels.x, upload.texels.y);
}

const unsigned char* TeClipWindows::sample(int level, std::int32_t x, std::int32_t y) const {
  if (level > topLevel())
    return nullptr;
  if (level >= m_base)
    return at(level).image.sample(x, y);
  const int shift = m_base - level;
  return at(m_base).image.sample(x << shift, y << shift);
}

std::uint16_t TeClipWindows::height(int level, std::int32_t x, std::int32_t y) const {
  const unsigned char* bytes = sample(level, x, y);
  assert(bytes && m_bytesPerSample == 2);
  return std::uint16_t(bytes[0] | bytes[1] << 8);
}
