#include "patchdb/TeSurface.h"

#include "patchdb/TeSurfaceRay.h"

#include <algorithm>

std::optional<double> TeSurface::heightAt(glm::dvec2 point) const {
  Place place;
  if (!locate(point, place))
    return std::nullopt;
  return place.cell.height(place.u, place.v);
}

std::optional<glm::dvec3> TeSurface::normalAt(glm::dvec2 point) const {
  Place place;
  if (!locate(point, place))
    return std::nullopt;
  const double spacing = m_lattice->spacing() * double(std::int64_t(1) << place.patch->key().level);
  return place.cell.normal(place.u, place.v, spacing);
}

std::optional<TeSurfacePoint> TeSurface::pointAt(glm::dvec2 point) const {
  Place place;
  if (!locate(point, place))
    return std::nullopt;
  return TeSurfacePoint{place.cell.height(place.u, place.v), place.patch->key(), place.patch->deviation()};
}

// Vertical rays are point queries: they cross no grid line on which a march could move on.
std::optional<TeRayHit> TeSurface::intersect(glm::dvec3 origin, glm::dvec3 direction,
                                             double maxDistance) const {
  if (direction.x != 0 || direction.y != 0)
    return teMarchRay(*m_lattice, m_tree->level(0), origin, direction, maxDistance);
  Place place;
  if (direction.z == 0 || !std::isfinite(direction.z) || !std::isfinite(origin.z) ||
      !locate({origin.x, origin.y}, place) || place.patch->key().level != 0)
    return std::nullopt;
  const double height = place.cell.height(place.u, place.v);
  const double distance = (height - origin.z) / direction.z;
  if (!(distance >= 0 && distance <= maxDistance))
    return std::nullopt;
  return TeRayHit{distance,
                  {origin.x, origin.y, height},
                  place.cell.normal(place.u, place.v, m_lattice->spacing()),
                  place.patch->key()};
}

bool TeSurface::locate(glm::dvec2 point, Place& place) const {
  const double limit = 2 * m_halfCell * double(m_cells) * double(TeLattice::kMaxKey);
  // Written so that a NaN fails.
  if (!(std::fabs(point.x) < limit && std::fabs(point.y) < limit))
    return false;
  double u, v;
  const std::int64_t x = sampleBelow(point.x, u);
  const std::int64_t y = sampleBelow(point.y, v);
  place.u = u;
  place.v = v;
  if (locateInCell(x, y, place))
    return true;
  // A point on a grid line also belongs to the cell on the other side, which may be known where this is not.
  for (int south = 0; south <= (v == 0 ? 1 : 0); ++south)
    for (int west = 0; west <= (u == 0 ? 1 : 0); ++west) {
      place.u = u + west;
      place.v = v + south;
      if (west + south > 0 && locateInCell(x - west, y - south, place))
        return true;
    }
  return false;
}

/// TeLattice::sampleBelow() without its divisions. The sample is the same, since it is settled by the
/// positions that samples have; the fraction may differ by its last bit, and is 0 for the same points.
std::int64_t TeSurface::sampleBelow(double coordinate, double& fraction) const {
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

/// The cell of a patch that holds the base cell at a sample; place.u and .v lead from the base cell's corner.
bool TeSurface::locateInCell(std::int64_t sampleX, std::int64_t sampleY, Place& place) const {
  const TePatchData* patch = patchOf(sampleX, sampleY);
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

const TePatchData* TeSurface::patchOf(std::int64_t sampleX, std::int64_t sampleY) const {
  const std::int64_t cells = m_cells;
  const TePatchData* last = m_last.load(std::memory_order_acquire);
  if (last && last->hasHeights()) {
    const std::int64_t x = sampleX - last->key().x * cells;
    const std::int64_t y = sampleY - last->key().y * cells;
    if (x >= 0 && x < cells && y >= 0 && y < cells)
      return last;
  }
  const auto patchAt = [cells](std::int64_t sample) {
    const std::int64_t quotient = sample / cells;
    return quotient * cells > sample ? quotient - 1 : quotient;
  };
  const TePatchKey key{patchAt(sampleX), patchAt(sampleY), 0};
  const TePatchData* found = key.valid() ? m_tree->nearestWithHeights(key) : nullptr;
  if (found && found->key().level == 0)
    m_last.store(found, std::memory_order_release);
  return found;
}
