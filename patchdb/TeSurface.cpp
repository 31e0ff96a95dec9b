#include "patchdb/TeSurface.h"

#include "patchdb/TeSurfaceCell.inl"
#include "patchdb/TeSurfaceRay.h"

#include <algorithm>
#include <array>
#include <limits>

/// TeLattice::sampleBelow() without its divisions. The sample is the same, since it is settled by the
/// positions that samples have; the fraction may differ by its last bit, and is 0 for the same points.
inline std::int64_t TeSurface::sampleBelow(double coordinate, double& fraction) const {
  const double cell = coordinate * m_perMetre + m_halfSide;
  std::int64_t below = std::int64_t(cell);
  below -= double(below) > cell ? 1 : 0;
  double west = position(below);
  if (west > coordinate) {
    west = position(--below);
  } else if (const double east = position(below + 1); east <= coordinate) {
    west = east;
    ++below;
  }
  fraction = std::min((coordinate - west) * m_perMetre, 1 - 0x1p-53);
  return below;
}

/// Floor of sample / cells and what is left, without a division: the product is off by little, since keys
/// have 48 bits.
inline std::int64_t TeSurface::patchAt(std::int64_t sample, std::int64_t& within) const {
  std::int64_t quotient = std::int64_t(double(sample) * m_perCells);
  quotient -= sample < 0 ? 1 : 0; // no branch: which side of the origin cannot be foretold
  within = sample - quotient * m_cells;
  for (; within >= m_cells; within -= m_cells)
    ++quotient;
  for (; within < 0; within += m_cells)
    --quotient;
  return quotient;
}

/// The base patch with heights that holds the base cell at a sample, which becomes that of the patch; null if
/// there is none, and then x and y may be anything.
inline const TePatchData* TeSurface::basePatchOf(std::int64_t& x, std::int64_t& y) const {
  const TePatchData* last = m_last.load(std::memory_order_acquire);
  if (last && last->hasHeights()) {
    const std::int64_t lastX = x - last->key().x * m_cells;
    const std::int64_t lastY = y - last->key().y * m_cells;
    // One branch: on which side of it the cell lies cannot be foretold.
    if (std::max(std::uint64_t(lastX), std::uint64_t(lastY)) < std::uint64_t(m_cells)) {
      x = lastX;
      y = lastY;
      return last;
    }
  }
  std::int64_t withinX, withinY;
  const std::int64_t patchX = patchAt(x, withinX), patchY = patchAt(y, withinY);
  const TePatchData* found = m_tree->base().find(patchX, patchY);
  if (!found || !found->hasHeights())
    return nullptr;
  m_last.store(found, std::memory_order_release);
  x = withinX;
  y = withinY;
  return found;
}

inline const TePatchData* TeSurface::patchOf(std::int64_t sampleX, std::int64_t sampleY) const {
  std::int64_t x = sampleX, y = sampleY;
  if (const TePatchData* patch = basePatchOf(x, y))
    return patch;
  const TePatchKey key{patchAt(sampleX, x), patchAt(sampleY, y), 0};
  return key.valid() ? m_tree->nearestWithHeights(key) : nullptr;
}

inline const TePatchData* TeSurface::patchOf(std::int64_t sampleX, std::int64_t sampleY, int level) const {
  std::int64_t x, y;
  const std::int64_t patchX = patchAt(sampleX, x) >> level, patchY = patchAt(sampleY, y) >> level;
  const TePatchData* found = m_tree->level(level).find(patchX, patchY);
  return found && found->hasHeights() ? found : nullptr;
}

/// The cell of a patch that holds the base cell at a sample; place.u and .v lead from the base cell's corner.
inline bool TeSurface::locateInCell(std::int64_t sampleX, std::int64_t sampleY, int wanted,
                                    Place& place) const {
  const TePatchData* patch =
      wanted == kFinest ? patchOf(sampleX, sampleY) : patchOf(sampleX, sampleY, wanted);
  if (!patch)
    return false;
  const int level = patch->key().level;
  const std::int64_t side = m_cells << level;
  const std::int64_t x = sampleX - patch->key().x * side;
  const std::int64_t y = sampleY - patch->key().y * side;
  const TeHeightMap& heights = patch->heights();
  place.cell = TeSurfaceCell::of(heights.row(int(y >> level)) + (x >> level), heights.width());
  if (!place.cell.complete())
    return false;
  if (level > 0) {
    const std::int64_t span = std::int64_t(1) << level;
    const double part = 1 / double(span); // exact, as span is a power of two
    place.u = (double(x & (span - 1)) + place.u) * part;
    place.v = (double(y & (span - 1)) + place.v) * part;
  }
  place.patch = patch;
  return true;
}

inline bool TeSurface::locate(glm::dvec2 point, int level, Place& place) const {
  if (!holds(point))
    return false;
  double u, v;
  const std::int64_t x = sampleBelow(point.x, u);
  const std::int64_t y = sampleBelow(point.y, v);
  place.u = u;
  place.v = v;
  if (locateInCell(x, y, level, place))
    return true;
  // A point on a grid line also belongs to the cell on the other side, which may be known where this is not.
  for (int south = 0; south <= (v == 0 ? 1 : 0); ++south)
    for (int west = 0; west <= (u == 0 ? 1 : 0); ++west) {
      place.u = u + west;
      place.v = v + south;
      if (west + south > 0 && locateInCell(x - west, y - south, level, place))
        return true;
    }
  return false;
}

// The usual case by itself: a base patch, not its north or east rim, and nothing missing.
bool TeSurface::findHeight(glm::dvec2 point, double& height) const {
  if (!holds(point))
    return false;
  double u, v;
  std::int64_t x = sampleBelow(point.x, u), y = sampleBelow(point.y, v);
  if (const TePatchData* patch = basePatchOf(x, y)) {
    const TeHeightMap& heights = patch->heights();
    const TeSurfaceCell cell = TeSurfaceCell::of(heights.row(int(y)) + x, heights.width());
    if (cell.complete()) {
      height = teInnerHeight(cell, u, v);
      return true;
    }
  }
  Place place;
  if (!locate(point, kFinest, place))
    return false;
  height = teCellHeight(place.cell, place.u, place.v);
  return true;
}

// Each step for several points, so that what one waits for in memory the next asks for meanwhile.
void TeSurface::heightsAt(const glm::dvec2* points, std::size_t count, double* heights) const {
  constexpr std::size_t kTogether = 32;
  struct Query {
    double u, v;
    std::int64_t x, y; ///< of the cell in its patch
    std::int64_t patchX, patchY;
    const TePatchData* patch;
    TeSurfaceCell cell;
  };
  std::array<Query, kTogether> queries;
  const TeGrowingTree& base = m_tree->base();
  for (std::size_t first = 0; first < count; first += kTogether) {
    const std::size_t together = std::min(kTogether, count - first);
    for (std::size_t i = 0; i < together; ++i) {
      Query& query = queries[i];
      const glm::dvec2 point = holds(points[first + i]) ? points[first + i] : glm::dvec2(0);
      query.patchX = patchAt(sampleBelow(point.x, query.u), query.x);
      query.patchY = patchAt(sampleBelow(point.y, query.v), query.y);
    }
    for (std::size_t i = 0; i < together; ++i) {
      Query& query = queries[i];
      query.patch = base.find(query.patchX, query.patchY);
    }
    for (std::size_t i = 0; i < together; ++i) {
      Query& query = queries[i];
      if (query.patch && query.patch->hasHeights()) {
        const TeHeightMap& map = query.patch->heights();
        query.cell = TeSurfaceCell::of(map.row(int(query.y)) + query.x, map.width());
      } else {
        query.cell.southWest = std::numeric_limits<float>::quiet_NaN();
      }
    }
    for (std::size_t i = 0; i < together; ++i) {
      const Query& query = queries[i];
      double& height = heights[first + i];
      if (query.cell.complete() && holds(points[first + i]))
        height = teInnerHeight(query.cell, query.u, query.v);
      else
        height = heightAt(points[first + i]).value_or(std::numeric_limits<double>::quiet_NaN());
    }
  }
}

std::optional<glm::dvec3> TeSurface::normalAt(glm::dvec2 point) const {
  Place place;
  if (!locate(point, kFinest, place))
    return std::nullopt;
  const double spacing = m_lattice->spacing() * double(std::int64_t(1) << place.patch->key().level);
  return place.cell.normal(place.u, place.v, spacing);
}

std::optional<TeSurfacePoint> TeSurface::pointAt(glm::dvec2 point) const {
  Place place;
  if (!locate(point, kFinest, place))
    return std::nullopt;
  return TeSurfacePoint{teCellHeight(place.cell, place.u, place.v), place.patch->key(),
                        place.patch->deviation()};
}

std::optional<TeSurfacePoint> TeSurface::pointAt(glm::dvec2 point, int level) const {
  Place place;
  if (level < 0 || level > TePatchKey::kMaxLevel || !locate(point, level, place))
    return std::nullopt;
  return TeSurfacePoint{teCellHeight(place.cell, place.u, place.v), place.patch->key(),
                        place.patch->deviation()};
}

// Vertical rays are point queries: they cross no grid line on which a march could move on.
std::optional<TeRayHit> TeSurface::intersect(glm::dvec3 origin, glm::dvec3 direction, double maxDistance,
                                             int level) const {
  if (level < 0 || level > TePatchKey::kMaxLevel)
    return std::nullopt;
  if (direction.x != 0 || direction.y != 0)
    return teMarchRay(*m_lattice, m_tree->level(level), level, origin, direction, maxDistance);
  Place place;
  if (direction.z == 0 || !std::isfinite(direction.z) || !std::isfinite(origin.z) ||
      !locate({origin.x, origin.y}, level, place))
    return std::nullopt;
  const double height = place.cell.height(place.u, place.v);
  const double distance = (height - origin.z) / direction.z;
  if (!(distance >= 0 && distance <= maxDistance))
    return std::nullopt;
  return TeRayHit{distance,
                  {origin.x, origin.y, height},
                  place.cell.normal(place.u, place.v, m_lattice->spacing() * std::ldexp(1.0, level)),
                  place.patch->key()};
}
