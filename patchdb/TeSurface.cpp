#include "patchdb/TeSurface.h"

#include "patchdb/TeSurfaceCell.inl"
#include "patchdb/TeSurfaceRay.h"

#include <algorithm>

/// TeLattice::sampleBelow() without its divisions. The sample is the same, since it is settled by the
/// positions that samples have; the fraction may differ by its last bit, and is 0 for the same points.
inline std::int64_t TeSurface::sampleBelow(double coordinate, double& fraction) const {
  const double cell = coordinate * m_perMetre + 0.5 * double(m_cells);
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

/// Floor of sample / cells, without a division: the product is off by little, since keys have 48 bits.
inline std::int64_t TeSurface::patchAt(std::int64_t sample) const {
  std::int64_t quotient = std::int64_t(double(sample) * m_perCells);
  quotient -= quotient * m_cells > sample ? 1 : 0; // as often as not where samples are negative: no branch
  while (quotient * m_cells > sample)
    --quotient;
  while ((quotient + 1) * m_cells <= sample)
    ++quotient;
  return quotient;
}

inline const TePatchData* TeSurface::patchOf(std::int64_t sampleX, std::int64_t sampleY) const {
  const std::int64_t cells = m_cells;
  const TePatchData* last = m_last.load(std::memory_order_acquire);
  if (last && last->hasHeights()) {
    const std::int64_t x = sampleX - last->key().x * cells;
    const std::int64_t y = sampleY - last->key().y * cells;
    if (x >= 0 && x < cells && y >= 0 && y < cells)
      return last;
  }
  const TePatchKey key{patchAt(sampleX), patchAt(sampleY), 0};
  if (!key.valid())
    return nullptr;
  const TePatchData* found = m_tree->find(key);
  if (!found || !found->hasHeights())
    return m_tree->nearestWithHeights(key);
  m_last.store(found, std::memory_order_release);
  return found;
}

inline const TePatchData* TeSurface::patchOf(std::int64_t sampleX, std::int64_t sampleY, int level) const {
  const TePatchKey base{patchAt(sampleX), patchAt(sampleY), 0};
  if (!base.valid())
    return nullptr;
  const TePatchData* found = m_tree->find({base.x >> level, base.y >> level, level});
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
    place.u = (double(x & (span - 1)) + place.u) / double(span);
    place.v = (double(y & (span - 1)) + place.v) / double(span);
  }
  place.patch = patch;
  return true;
}

inline bool TeSurface::locate(glm::dvec2 point, int level, Place& place) const {
  const double limit = 2 * m_halfCell * double(m_cells) * double(TeLattice::kMaxKey);
  // Written so that a NaN fails.
  if (!(std::fabs(point.x) < limit && std::fabs(point.y) < limit))
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

std::optional<double> TeSurface::heightAt(glm::dvec2 point) const {
  Place place;
  if (!locate(point, kFinest, place))
    return std::nullopt;
  return teCellHeight(place.cell, place.u, place.v);
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
