#include "generators/TeRegionChooser.h"

#include <algorithm>
#include <string>

namespace {

std::int64_t floorDivide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0); }

/// |a - b|, which need not fit into 64 signed bits.
std::uint64_t distance(std::int64_t a, std::int64_t b) {
  return a > b ? std::uint64_t(a) - std::uint64_t(b) : std::uint64_t(b) - std::uint64_t(a);
}

bool isKey(const TeMapKey& key) {
  constexpr std::int64_t kMost = TeLattice::kMaxKey;
  return key.x >= -kMost && key.x <= kMost && key.y >= -kMost && key.y <= kMost;
}

std::string text(const TeMapKey& key) {
  return "(" + std::to_string(key.x) + ", " + std::to_string(key.y) + ")";
}

} // namespace

TeRegionChooser::TeRegionChooser(TeHeightSourcePtr everywhere) : m_everywhere(std::move(everywhere)) {
  assert(m_everywhere);
}

TeStatus TeRegionChooser::addRectangle(TeMapKey southWest, TeMapKey northEast, TeHeightSourcePtr source) {
  assert(source);
  if (southWest.x > northEast.x || southWest.y > northEast.y)
    return TeError{"region: rectangle from " + text(southWest) + " to " + text(northEast) + " holds no map"};
  m_regions.push_back({Shape::Rectangle, southWest, northEast, 0, std::move(source)});
  return {};
}

TeStatus TeRegionChooser::addDisc(TeMapKey centre, std::int64_t radius, TeHeightSourcePtr source) {
  assert(source);
  if (radius < 0 || radius > TeLattice::kMaxKey || !isKey(centre))
    return TeError{"region: disc of radius " + std::to_string(radius) + " around " + text(centre) +
                   ": radius and centre must be within 2^47"};
  m_regions.push_back({Shape::Disc, centre, centre, radius, std::move(source)});
  return {};
}

TeStatus TeRegionChooser::addChequers(std::int64_t side, TeHeightSourcePtr source) {
  assert(source);
  if (side < 1)
    return TeError{"region: side of chequers is " + std::to_string(side) + ", must be at least 1"};
  m_regions.push_back({Shape::Chequers, {}, {}, side, std::move(source)});
  return {};
}

bool TeRegionChooser::Region::holds(const TeMapKey& key) const {
  if (shape == Shape::Rectangle)
    return key.x >= a.x && key.x <= b.x && key.y >= a.y && key.y <= b.y;
  if (shape == Shape::Chequers)
    return ((floorDivide(key.x, size) ^ floorDivide(key.y, size)) & 1) == 0;
  const std::uint64_t dx = distance(key.x, a.x);
  const std::uint64_t dy = distance(key.y, a.y);
  const std::uint64_t radius = std::uint64_t(size);
  if (dx > radius || dy > radius)
    return false;
  __extension__ using Wide = unsigned __int128;
  return Wide(dx) * dx + Wide(dy) * dy <= Wide(radius) * radius;
}

TeHeightSourcePtr TeRegionChooser::choose(const TeMapKey& key) const {
  for (std::size_t i = m_regions.size(); i-- > 0;)
    if (m_regions[i].holds(key))
      return m_regions[i].source;
  return m_everywhere;
}

bool TeRegionChooser::fits() const {
  const std::uint64_t fingerprint = m_everywhere->fingerprint();
  return m_everywhere->fits() &&
         std::all_of(m_regions.begin(), m_regions.end(), [fingerprint](const Region& r) {
           return r.source->fingerprint() == fingerprint && r.source->fits();
         });
}

bool TeRegionChooser::pointEvaluable() const {
  return m_everywhere->pointEvaluable() &&
         std::all_of(m_regions.begin(), m_regions.end(),
                     [](const Region& r) { return r.source->pointEvaluable(); });
}
