#include "patchdb/TePatchKey.h"

#include "generators/base/TeHash.h"

#include <cmath>
#include <tuple>

namespace {

std::int64_t floorDivide(std::int64_t value, std::int64_t divisor) {
  const std::int64_t quotient = value / divisor;
  return quotient * divisor > value ? quotient - 1 : quotient;
}

/// Keys of a level are -limit .. limit - 1.
std::int64_t keyLimit(int level) { return TeLattice::kMaxKey >> level; }

TeError outside(const TePatchKey& key) { return {"patch " + key.text() + ": outside the world"}; }

} // namespace

glm::ivec2 teStep(TeDirection direction) {
  static const glm::ivec2 steps[8] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  return steps[int(direction)];
}

bool TePatchKey::valid() const {
  if (level < 0 || level > kMaxLevel)
    return false;
  const std::int64_t limit = keyLimit(level);
  return x >= -limit && x < limit && y >= -limit && y < limit;
}

TeResult<TePatchKey> TePatchKey::parent() const {
  if (!valid())
    return outside(*this);
  if (level == kMaxLevel)
    return TeError{"patch " + text() + ": the largest level has no parents"};
  return TePatchKey{floorDivide(x, 2), floorDivide(y, 2), level + 1};
}

TeResult<TePatchKey> TePatchKey::child(int index) const {
  if (!valid())
    return outside(*this);
  if (level == 0)
    return TeError{"patch " + text() + ": the base level has no children"};
  if (index < 0 || index > 3)
    return TeError{"child " + std::to_string(index) + " of patch " + text() + ": not one of 0 to 3"};
  return TePatchKey{2 * x + index % 2, 2 * y + index / 2, level - 1};
}

int TePatchKey::childIndex() const {
  return int(x - 2 * floorDivide(x, 2)) + 2 * int(y - 2 * floorDivide(y, 2));
}

TeResult<TePatchKey> TePatchKey::neighbour(TeDirection direction) const {
  if (!valid())
    return outside(*this);
  const glm::ivec2 step = teStep(direction);
  const TePatchKey key{x + step.x, y + step.y, level};
  if (!key.valid())
    return outside(key);
  return key;
}

TeResult<TePatchKey> TePatchKey::ancestor(int atLevel) const {
  if (!valid())
    return outside(*this);
  if (atLevel < level || atLevel > kMaxLevel)
    return TeError{"patch " + text() + ": no ancestor at level " + std::to_string(atLevel)};
  const std::int64_t ratio = std::int64_t(1) << (atLevel - level);
  return TePatchKey{floorDivide(x, ratio), floorDivide(y, ratio), atLevel};
}

bool TePatchKey::contains(const TePatchKey& other) const {
  const TeResult<TePatchKey> same = other.ancestor(level);
  return same && *same == *this;
}

std::string TePatchKey::text() const {
  return "(" + std::to_string(x) + ", " + std::to_string(y) + ") level " + std::to_string(level);
}

bool operator<(const TePatchKey& a, const TePatchKey& b) {
  return std::tie(a.level, a.y, a.x) < std::tie(b.level, b.y, b.x);
}

std::size_t TePatchKeyHash::operator()(const TePatchKey& key) const {
  return std::size_t(
      teHashCombine(teHashCombine(std::uint64_t(key.level), std::uint64_t(key.x)), std::uint64_t(key.y)));
}

TeResult<TePatchKey> tePatchAt(const TeLattice& lattice, glm::dvec2 point, int level) {
  if (level < 0 || level > TePatchKey::kMaxLevel)
    return TeError{"level " + std::to_string(level) + ": not one of 0 to " +
                   std::to_string(TePatchKey::kMaxLevel)};
  const double west = lattice.position(-TeLattice::kMaxKey * lattice.cells());
  const double east = lattice.position(TeLattice::kMaxKey * lattice.cells());
  // Written so that a NaN fails.
  if (!(point.x >= west && point.x < east && point.y >= west && point.y < east))
    return TeError{"point (" + std::to_string(point.x) + ", " + std::to_string(point.y) +
                   "): outside the world"};
  double fraction;
  const TePatchKey base{floorDivide(lattice.sampleBelow(point.x, fraction), lattice.cells()),
                        floorDivide(lattice.sampleBelow(point.y, fraction), lattice.cells()), 0};
  return base.ancestor(level);
}

glm::vec<2, std::int64_t> tePatchFirstSample(const TeLattice& lattice, const TePatchKey& key) {
  const std::int64_t cells = std::int64_t(lattice.cells()) << key.level;
  return {key.x * cells, key.y * cells};
}

glm::dvec2 tePatchOrigin(const TeLattice& lattice, const TePatchKey& key) {
  const glm::vec<2, std::int64_t> first = tePatchFirstSample(lattice, key);
  return {lattice.position(first.x), lattice.position(first.y)};
}

// In half cells the centre is an integer: two roundings, as for TeLattice::position().
glm::dvec2 tePatchCentre(const TeLattice& lattice, const TePatchKey& key) {
  const glm::vec<2, std::int64_t> first = tePatchFirstSample(lattice, key);
  const std::int64_t half = (std::int64_t(lattice.cells()) << key.level) - lattice.cells();
  return {double(2 * first.x + half) * (0.5 * lattice.spacing()),
          double(2 * first.y + half) * (0.5 * lattice.spacing())};
}
