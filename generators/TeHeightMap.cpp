#include "generators/TeHeightMap.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <string>

namespace {

/// Overflow to infinity becomes missing; NaN (one operand missing, or inf - inf) becomes *the* missing value.
/// In whole numbers, so that loops over it need no branch.
float finiteOrMissing(float height) {
  constexpr std::uint32_t kExponent = 0x7F800000u;
  constexpr std::uint32_t kMissing = 0x7FC00000u;
  std::uint32_t bits;
  std::memcpy(&bits, &height, sizeof bits);
  bits = (bits & kExponent) == kExponent ? kMissing : bits;
  std::memcpy(&height, &bits, sizeof bits);
  return height;
}

std::string text(const TeMapRect& r) {
  return "(" + std::to_string(r.x) + ", " + std::to_string(r.y) + ") " + std::to_string(r.width) + "x" +
         std::to_string(r.height);
}

TeStatus checkInside(const TeHeightMap& map, const TeMapRect& r, const char* which) {
  const bool inside = r.x >= 0 && r.y >= 0 && r.width >= 1 && r.height >= 1 && r.x <= map.width() - r.width &&
                      r.y <= map.height() - r.height;
  if (inside)
    return {};
  return TeError{std::string(which) + " rectangle " + text(r) + " is not inside the map of " +
                 std::to_string(map.width()) + "x" + std::to_string(map.height()) + " samples"};
}

TeStatus checkPair(const TeHeightMap& source, const TeMapRect& from, const TeHeightMap& destination,
                   const TeMapRect& to) {
  if (TeStatus ok = checkInside(source, from, "source"); !ok)
    return ok;
  if (TeStatus ok = checkInside(destination, to, "destination"); !ok)
    return ok;
  if (from.width != to.width || from.height != to.height)
    return TeError{"source rectangle " + text(from) + " and destination rectangle " + text(to) +
                   " differ in size"};
  return {};
}

/// destination = operation(destination, source) over the rectangles, which may overlap in one map: the rows
/// are visited away from the destination, and a row is read whole before it is written.
template <class Operation>
TeStatus combine(const TeHeightMap& source, const TeMapRect& from, TeHeightMap& destination,
                 const TeMapRect& to, Operation operation) {
  if (TeStatus ok = checkPair(source, from, destination, to); !ok)
    return ok;
  const bool downwards = &source == &destination && to.y > from.y;
  std::vector<float> line(static_cast<std::size_t>(from.width));
  for (int i = 0; i < from.height; ++i) {
    const int y = downwards ? from.height - 1 - i : i;
    const float* in = source.row(from.y + y) + from.x;
    std::copy(in, in + from.width, line.begin());
    float* out = destination.row(to.y + y) + to.x;
    for (int x = 0; x < from.width; ++x)
      out[x] = operation(out[x], line[std::size_t(x)]);
  }
  return {};
}

template <class Operation> TeStatus apply(TeHeightMap& map, const TeMapRect& to, Operation operation) {
  if (TeStatus ok = checkInside(map, to, "destination"); !ok)
    return ok;
  for (int y = 0; y < to.height; ++y) {
    float* out = map.row(to.y + y) + to.x;
    for (int x = 0; x < to.width; ++x)
      out[x] = operation(out[x]);
  }
  return {};
}

} // namespace

float TeHeightMap::missing() { return std::numeric_limits<float>::quiet_NaN(); }

TeResult<TeHeightMap> TeHeightMap::create(int width, int height) {
  if (width < 1 || height < 1)
    return TeError{"map size " + std::to_string(width) + "x" + std::to_string(height) +
                   ": both sides must be at least 1"};
  if (std::int64_t(width) * height > kMaxSamples)
    return TeError{"map size " + std::to_string(width) + "x" + std::to_string(height) + ": more than " +
                   std::to_string(kMaxSamples) + " samples"};
  TeHeightMap map;
  map.m_width = width;
  map.m_height = height;
  try {
    map.m_samples.assign(std::size_t(width) * std::size_t(height), 0.0f);
  } catch (const std::bad_alloc&) {
    return TeError{"map size " + std::to_string(width) + "x" + std::to_string(height) +
                   ": not enough memory"};
  }
  return map;
}

bool TeHeightMap::hasMissing() const {
  return std::any_of(m_samples.begin(), m_samples.end(), [](float h) { return isMissing(h); });
}

void TeHeightMap::fillMissing(float height) {
  for (float& h : m_samples)
    if (isMissing(h))
      h = finiteOrMissing(height);
}

TeStatus TeHeightMap::copy(const TeHeightMap& source, TeMapRect from, TeMapRect to) {
  return combine(source, from, *this, to, [](float, float s) { return finiteOrMissing(s); });
}

TeStatus TeHeightMap::add(const TeHeightMap& source, TeMapRect from, TeMapRect to) {
  return combine(source, from, *this, to, [](float d, float s) { return finiteOrMissing(d + s); });
}

TeStatus TeHeightMap::subtract(const TeHeightMap& source, TeMapRect from, TeMapRect to) {
  return combine(source, from, *this, to, [](float d, float s) { return finiteOrMissing(d - s); });
}

TeStatus TeHeightMap::multiply(const TeHeightMap& source, TeMapRect from, TeMapRect to) {
  return combine(source, from, *this, to, [](float d, float s) { return finiteOrMissing(d * s); });
}

TeStatus TeHeightMap::addScaled(const TeHeightMap& source, float factor, TeMapRect from, TeMapRect to) {
  return combine(source, from, *this, to,
                 [factor](float d, float s) { return finiteOrMissing(d + factor * s); });
}

TeStatus TeHeightMap::minimum(const TeHeightMap& source, TeMapRect from, TeMapRect to) {
  return combine(source, from, *this, to,
                 [](float d, float s) { return isMissing(d) || isMissing(s) ? missing() : std::min(d, s); });
}

TeStatus TeHeightMap::maximum(const TeHeightMap& source, TeMapRect from, TeMapRect to) {
  return combine(source, from, *this, to,
                 [](float d, float s) { return isMissing(d) || isMissing(s) ? missing() : std::max(d, s); });
}

TeStatus TeHeightMap::fill(float height, TeMapRect to) {
  return apply(*this, to, [height](float) { return finiteOrMissing(height); });
}

TeStatus TeHeightMap::scale(float factor, TeMapRect to) {
  return apply(*this, to, [factor](float d) { return finiteOrMissing(d * factor); });
}

TeMapStatistics TeHeightMap::statistics() const {
  return empty() ? TeMapStatistics{} : statistics(bounds()).value();
}

TeResult<TeMapStatistics> TeHeightMap::statistics(TeMapRect rect) const {
  if (TeStatus ok = checkInside(*this, rect, "statistics"); !ok)
    return ok.error();
  TeMapStatistics s;
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -lowest;
  double sum = 0;
  for (int y = 0; y < rect.height; ++y) {
    const float* in = row(rect.y + y) + rect.x;
    double rowSum = 0; // row by row, so that the error grows with the side and not with the area
    for (int x = 0; x < rect.width; ++x) {
      if (isMissing(in[x])) {
        ++s.missing;
        continue;
      }
      lowest = std::min(lowest, in[x]);
      highest = std::max(highest, in[x]);
      rowSum += in[x];
    }
    sum += rowSum;
  }
  s.present = std::int64_t(rect.width) * rect.height - s.missing;
  if (s.present > 0) {
    s.minimum = lowest;
    s.maximum = highest;
    s.mean = sum / double(s.present);
  }
  return s;
}

void TeHeightMap::shift(float metres) {
  for (float& h : m_samples)
    h = finiteOrMissing(h + metres);
}

void TeHeightMap::shiftMinimumTo(float height) { shift(height - statistics().minimum); }
void TeHeightMap::shiftMeanTo(float height) { shift(float(height - statistics().mean)); }

bool operator==(const TeHeightMap& a, const TeHeightMap& b) {
  return a.m_width == b.m_width && a.m_height == b.m_height &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.bytes()) == 0);
}
