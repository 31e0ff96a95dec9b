#include "nodes/seamless/TeSeamlessBounds.h"

#include "nodes/seamless/TeSeamlessBoundsBuilder.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <utility>

namespace {

using Bounds = TeResult<std::shared_ptr<const TeSeamlessBounds>>;

const char* const kSubject = "bounds of seamless patches: ";

void include(TeHeightRange& range, const TeHeightRange& other) {
  range.low = std::min(range.low, other.low);
  range.high = std::max(range.high, other.high);
}

constexpr TeHeightRange kNothing{std::numeric_limits<float>::infinity(),
                                 -std::numeric_limits<float>::infinity()};

TeStatus checkPatches(const TeSeamlessLayout& layout) {
  if (layout.patchCount() > TeSeamlessBounds::kMaxPatches)
    return TeError{kSubject + std::to_string(layout.patchCount()) + " patches, at most " +
                   std::to_string(TeSeamlessBounds::kMaxPatches) + " are allowed"};
  return {};
}

TeError noMemory() { return {std::string(kSubject) + "not enough memory"}; }

std::size_t patchIndex(const TeSeamlessLayout& layout, int level, std::int32_t x, std::int32_t y) {
  return std::size_t(y) * std::size_t(layout.patchesPerSide(level)) + std::size_t(x);
}

TeStatus check(const TeSeamlessLayout& layout, const TeSeamlessBounds::Measured& measured) {
  const int deepest = layout.depth() - 1;
  bool fits = int(measured.errors.size()) == layout.depth() &&
              std::int64_t(measured.ranges.size()) ==
                  std::int64_t(layout.patchesPerSide(deepest)) * layout.patchesPerSide(deepest);
  for (int level = 0; fits && level <= deepest; level++)
    fits =
        std::int64_t(measured.errors[std::size_t(level)].size()) == layout.sideCount(level) * layout.levels();
  if (!fits)
    return TeError{std::string(kSubject) + "errors or ranges of another layout"};
  for (const std::vector<float>& errors : measured.errors)
    for (const float error : errors)
      if (!(error >= 0) || !std::isfinite(error))
        return TeError{std::string(kSubject) + "an error is not a number from 0"};
  for (const TeHeightRange& range : measured.ranges)
    if (!(range.low <= range.high) || !std::isfinite(range.low) || !std::isfinite(range.high))
      return TeError{std::string(kSubject) + "a range of heights is not one of numbers"};
  return {};
}

} // namespace

Bounds TeSeamlessBounds::create(const TeSeamlessLayout& layout, const TeHeightMap& heights) {
  const int side = layout.resolution() + 1;
  if (heights.width() != side || heights.height() != side)
    return TeError{kSubject + std::to_string(heights.width()) + " x " + std::to_string(heights.height()) +
                   " samples; the layout needs " + std::to_string(side) + " x " + std::to_string(side)};
  return create(layout, [&heights, side](int row, int count, float* samples) {
    std::copy_n(heights.row(row), std::size_t(count) * std::size_t(side), samples);
    return TeStatus();
  });
}

Bounds TeSeamlessBounds::create(const TeSeamlessLayout& layout, const ReadRows& read,
                                const Progress& progress, std::size_t memory) {
  if (TeStatus status = checkPatches(layout); !status)
    return status.error();
  try {
    TeSeamlessBoundsBuilder builder(layout, memory);
    TeResult<Measured> measured = builder.measure(read, progress);
    if (!measured)
      return measured.error();
    return create(layout, std::move(*measured));
  } catch (const std::bad_alloc&) {
    return noMemory();
  }
}

Bounds TeSeamlessBounds::create(const TeSeamlessLayout& layout, Measured measured) {
  if (TeStatus status = checkPatches(layout); !status)
    return status.error();
  if (TeStatus status = check(layout, measured); !status)
    return status.error();
  try {
    return std::shared_ptr<const TeSeamlessBounds>(new TeSeamlessBounds(layout, std::move(measured)));
  } catch (const std::bad_alloc&) {
    return noMemory();
  }
}

TeSeamlessBounds::TeSeamlessBounds(const TeSeamlessLayout& layout, Measured measured)
    : m_layout(layout), m_measured(std::move(measured)), m_across(std::size_t(layout.depth())),
      m_along(std::size_t(layout.depth())) {
  const std::size_t levels = std::size_t(layout.levels());
  for (int level = 0; level < layout.depth(); level++) {
    std::vector<float>& errors = m_measured.errors[std::size_t(level)];
    const std::size_t top = std::size_t(layout.topIndex(level));
    for (std::size_t side = 0; side < errors.size(); side += levels) {
      std::fill(errors.begin() + std::ptrdiff_t(side + top), errors.begin() + std::ptrdiff_t(side + levels),
                errors[side + top]);
      for (std::size_t index = top; index > 0; index--)
        errors[side + index - 1] = std::max(errors[side + index - 1], errors[side + index]);
    }
  }
  setRanges();
  const std::size_t divided = std::size_t(layout.depth() - 1);
  m_beyond.resize(divided);
  m_beyondRanges.resize(divided);
  for (int level = layout.depth() - 2; level >= 0; level--)
    setBeyond(level);
}

void TeSeamlessBounds::setRanges() {
  const int b = m_layout.branching();
  m_ranges.resize(std::size_t(m_layout.depth() - 1));
  for (int level = m_layout.depth() - 2; level >= 0; level--) {
    const std::int32_t n = m_layout.patchesPerSide(level);
    m_ranges[std::size_t(level)].assign(std::size_t(n) * std::size_t(n), kNothing);
    for (std::int32_t y = 0; y < n * b; y++)
      for (std::int32_t x = 0; x < n * b; x++)
        include(m_ranges[std::size_t(level)][patchIndex(m_layout, level, x / b, y / b)],
                range(level + 1, x, y));
  }
}

void TeSeamlessBounds::setBeyond(int level) {
  const std::size_t here = std::size_t(level);
  const double half = m_layout.cells(level) / 2;
  const double child = m_layout.cells(level + 1);
  m_across[here] = std::max(half, child + std::max(m_across[here + 1], m_along[here + 1]));
  m_along[here] = std::max(m_along[here + 1], m_across[here + 1]);

  m_beyond[here].resize(std::size_t(m_layout.sideCount(level)));
  m_beyondRanges[here].resize(std::size_t(m_layout.sideCount(level)));
  const std::int32_t n = m_layout.patchesPerSide(level);
  for (const bool horizontal : {true, false})
    for (std::int32_t y = 0; y < n + horizontal; y++)
      for (std::int32_t x = 0; x < n + !horizontal; x++) {
        const TeSideKey side{level, horizontal, x, y};
        const std::size_t index = std::size_t(m_layout.sideIndex(side));
        m_beyond[here][index] = beyondOf(side);
        m_beyondRanges[here][index] = rangeBeyond(side);
      }
}

float TeSeamlessBounds::beyondOf(const TeSideKey& side) const {
  const std::size_t levels = std::size_t(m_layout.levels());
  const std::size_t here = std::size_t(side.level);
  const int b = m_layout.branching();
  const std::int32_t n = m_layout.patchesPerSide(side.level + 1);
  const std::size_t top = std::size_t(m_layout.topIndex(side.level));
  float beyond = m_measured.errors[here][std::size_t(m_layout.sideIndex(side)) * levels + top];
  float inner = 0; // the largest of the children at the side
  for (int i = 0; i < b; i++)
    for (const int across : {-1, 0}) {
      const std::int32_t x = side.x * b + (side.horizontal ? i : across);
      const std::int32_t y = side.y * b + (side.horizontal ? across : i);
      if (x < 0 || y < 0 || x >= n || y >= n)
        continue;
      const TeSide shared = side.horizontal ? (across ? TeNorth : TeSouth) : (across ? TeEast : TeWest);
      const TeSideKey part = TeSeamlessLayout::sideOf(side.level + 1, x, y, shared);
      beyond = std::max(beyond, m_measured.errors[here + 1][std::size_t(m_layout.sideIndex(part)) * levels]);
      if (here + 1 < m_beyond.size())
        for (const TeSide own : {TeNorth, TeEast, TeSouth, TeWest}) {
          const TeSideKey key = TeSeamlessLayout::sideOf(side.level + 1, x, y, own);
          inner = std::max(inner, m_beyond[here + 1][std::size_t(m_layout.sideIndex(key))]);
        }
    }
  if (inner > 0) {
    const float raised = std::nextafter(inner / kMorphRatio, std::numeric_limits<float>::infinity());
    beyond = std::max(beyond, raised);
  }
  return beyond;
}

/// The box reaches to borders of patches of the deepest level.
TeHeightRange TeSeamlessBounds::rangeBeyond(const TeSideKey& side) const {
  const int deepest = m_layout.depth() - 1;
  const double cell = m_layout.cells(deepest);
  const double size = m_layout.cells(side.level);
  const double across = m_across[std::size_t(side.level)];
  const double along = m_along[std::size_t(side.level)];
  const double x0 = side.x * size - (side.horizontal ? along : across);
  const double y0 = side.y * size - (side.horizontal ? across : along);
  const double x1 = side.x * size + (side.horizontal ? size + along : across);
  const double y1 = side.y * size + (side.horizontal ? across : size + along);
  const std::int32_t n = m_layout.patchesPerSide(deepest);
  const auto clamped = [n](double patch) { return std::int32_t(std::clamp(patch, 0.0, double(n))); };
  TeHeightRange found = kNothing;
  for (std::int32_t y = clamped(std::floor(y0 / cell)); y < clamped(std::ceil(y1 / cell)); y++)
    for (std::int32_t x = clamped(std::floor(x0 / cell)); x < clamped(std::ceil(x1 / cell)); x++)
      include(found, m_measured.ranges[patchIndex(m_layout, deepest, x, y)]);
  return found;
}

TeHeightRange TeSeamlessBounds::range(int level, std::int32_t x, std::int32_t y) const {
  assert(level >= 0 && level < m_layout.depth());
  const bool deepest = level == m_layout.depth() - 1;
  return (deepest ? m_measured.ranges : m_ranges[std::size_t(level)])[patchIndex(m_layout, level, x, y)];
}

TeSideBounds TeSeamlessBounds::side(const TeSideKey& key) const {
  assert(key.level >= 0 && key.level < m_layout.depth());
  const std::size_t level = std::size_t(key.level);
  const std::size_t index = std::size_t(m_layout.sideIndex(key));
  const std::int32_t n = m_layout.patchesPerSide(key.level);
  TeSideBounds bounds;
  bounds.error = m_measured.errors[level].data() + index * std::size_t(m_layout.levels());
  bounds.range = kNothing;
  if (key.x < n && key.y < n)
    include(bounds.range, range(key.level, key.x, key.y));
  const std::int32_t otherX = key.x - !key.horizontal;
  const std::int32_t otherY = key.y - key.horizontal;
  if (otherX >= 0 && otherY >= 0)
    include(bounds.range, range(key.level, otherX, otherY));
  const bool deepest = level == m_beyond.size();
  bounds.beyond = deepest ? 0 : m_beyond[level][index];
  bounds.beyondRange = deepest ? bounds.range : m_beyondRanges[level][index];
  return bounds;
}
