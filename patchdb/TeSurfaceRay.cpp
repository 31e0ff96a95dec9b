#include "patchdb/TeSurfaceRay.h"

#include "patchdb/TePatchData.h"
#include "patchdb/TeSurfaceCell.h"

#include <algorithm>
#include <cmath>

namespace {

/// 1 / direction, whose largest component is 1; 0 where the ray does not move, or so little that it comes
/// nowhere.
double inverseOf(double direction) { return std::fabs(direction) < 1e-200 ? 0 : 1 / direction; }

/// The part of a ray that lies between two values of a coordinate; false if there is none.
bool clip(double origin, double inverse, double low, double high, double& begin, double& end) {
  if (inverse == 0)
    return origin >= low && origin <= high;
  const double a = (low - origin) * inverse;
  const double b = (high - origin) * inverse;
  begin = std::max(begin, std::min(a, b));
  end = std::min(end, std::max(a, b));
  return begin <= end;
}

class Marcher {
public:
  Marcher(const TeLattice& lattice, glm::dvec3 origin, glm::dvec3 direction, double range)
      : m_cells(lattice.cells()), m_spacing(lattice.spacing()), m_origin(origin), m_direction(direction),
        m_inverse(inverseOf(direction.x), inverseOf(direction.y), inverseOf(direction.z)), m_range(range) {}

  /// Where the ray enters a square of base patches; negative if it does not before its first hit.
  double enter(const TeGrowingTree::Bounds& bounds) const {
    double begin = 0;
    double end = m_range;
    return clipToPatches(bounds, begin, end) ? begin : -1;
  }

  bool visit(const TePatchData& patch);

  std::optional<TeRayHit> m_hit;

private:
  bool clipToPatches(const TeGrowingTree::Bounds& bounds, double& begin, double& end) const;
  bool march(const TePatchData& patch, double begin, double end);
  bool crossCell(const TePatchData& patch, int x, int y, double begin, double end);
  TeSurfaceCell cellAt(const TePatchData& patch, int& x, int& y) const;
  void hit(const TePatchData& patch, const TeSurfaceCell& cell, int x, int y, double at);

  double u(double at, int x) const { return std::clamp(m_startU + at * m_stepU - x, 0.0, 1.0); }
  double v(double at, int y) const { return std::clamp(m_startV + at * m_stepV - y, 0.0, 1.0); }
  double z(double at) const { return m_origin.z + at * m_direction.z; }

  /// World coordinate of a patch's west or south border; the bits of TeLattice::position().
  double border(std::int64_t key) const { return double(2 * key * m_cells - m_cells) * (0.5 * m_spacing); }

  std::int64_t m_cells;
  double m_spacing;
  glm::dvec3 m_origin;
  glm::dvec3 m_direction;
  glm::dvec3 m_inverse;
  double m_range;
  // The ray in cells of the patch at hand.
  double m_startU = 0, m_startV = 0, m_stepU = 0, m_stepV = 0;
  // How high above the surface the ray was where it was last looked at; NaN = nothing known.
  double m_above = NAN;
  double m_aboveAt = 0;
};

bool Marcher::clipToPatches(const TeGrowingTree::Bounds& bounds, double& begin, double& end) const {
  const auto inWorld = [](std::int64_t key) {
    return std::clamp(key, -TeLattice::kMaxKey, TeLattice::kMaxKey);
  };
  return clip(m_origin.x, m_inverse.x, border(inWorld(bounds.x)), border(inWorld(bounds.x + bounds.span)),
              begin, end) &&
         clip(m_origin.y, m_inverse.y, border(inWorld(bounds.y)), border(inWorld(bounds.y + bounds.span)),
              begin, end);
}

bool Marcher::visit(const TePatchData& patch) {
  double begin = 0;
  double end = m_range;
  if (!patch.hasHeights() || !clipToPatches({patch.key().x, patch.key().y, 1}, begin, end))
    return true;
  // The margin keeps the sign certain wherever the ray is cut off.
  const double margin = 1 + 1e-9 * std::max(std::fabs(patch.minimum()), std::fabs(patch.maximum()));
  if (!clip(m_origin.z, m_inverse.z, patch.minimum() - margin, patch.maximum() + margin, begin, end))
    return true;
  m_startU = (m_origin.x - border(patch.key().x)) / m_spacing;
  m_startV = (m_origin.y - border(patch.key().y)) / m_spacing;
  m_stepU = m_direction.x / m_spacing;
  m_stepV = m_direction.y / m_spacing;
  if (!(std::fabs(begin - m_aboveAt) <= 1e-12 * std::fabs(begin)))
    m_above = NAN;
  if (march(patch, begin, end))
    m_range = m_hit->distance;
  return true;
}

bool Marcher::march(const TePatchData& patch, double begin, double end) {
  const int cells = int(m_cells);
  const auto cellOf = [cells](double position) {
    return int(std::clamp(std::floor(position), 0.0, double(cells - 1)));
  };
  int x = cellOf(m_startU + begin * m_stepU);
  int y = cellOf(m_startV + begin * m_stepV);
  const int eastward = m_stepU > 0 ? 1 : 0;
  const int northward = m_stepV > 0 ? 1 : 0;
  const double perU = m_inverse.x * m_spacing;
  const double perV = m_inverse.y * m_spacing;
  double at = begin;
  for (;;) {
    const double nextX = perU != 0 ? (x + eastward - m_startU) * perU : INFINITY;
    const double nextY = perV != 0 ? (y + northward - m_startV) * perV : INFINITY;
    const double next = std::max(at, std::min({nextX, nextY, end}));
    if (crossCell(patch, x, y, at, next))
      return true;
    const bool crossX = nextX <= next;
    const bool crossY = nextY <= next;
    x += crossX ? 2 * eastward - 1 : 0;
    y += crossY ? 2 * northward - 1 : 0;
    if ((!crossX && !crossY) || x < 0 || x >= cells || y < 0 || y >= cells)
      return false;
    at = next;
  }
}

/// The cell of the patch; if it has a missing corner and the ray runs along its west or south side, the one
/// on the other side of that.
TeSurfaceCell Marcher::cellAt(const TePatchData& patch, int& x, int& y) const {
  const TeHeightMap& heights = patch.heights();
  const TeSurfaceCell cell = TeSurfaceCell::of(heights.row(y) + x, heights.width());
  if (cell.complete())
    return cell;
  if (m_stepU == 0 && m_startU == x && x > 0)
    --x;
  else if (m_stepV == 0 && m_startV == y && y > 0)
    --y;
  return TeSurfaceCell::of(heights.row(y) + x, heights.width());
}

/// Looks for a hit on the way through a cell; true if there is one.
bool Marcher::crossCell(const TePatchData& patch, int x, int y, double begin, double end) {
  const TeSurfaceCell cell = cellAt(patch, x, y);
  if (!cell.complete()) {
    m_above = NAN;
    return false;
  }
  // Wholly above or below the corners: only the side matters.
  const double z0 = z(begin), z1 = z(end);
  const double highest = cell.highest(), lowest = cell.lowest();
  if (std::min(z0, z1) > highest || std::max(z0, z1) < lowest) {
    const double above = z0 > highest ? z1 - highest : z1 - lowest;
    if (!std::isnan(m_above) && (m_above < 0) != (above < 0)) {
      hit(patch, cell, x, y, begin);
      return true;
    }
    m_above = above;
    m_aboveAt = end;
    return false;
  }
  const double u0 = u(begin, x), v0 = v(begin, y), u1 = u(end, x), v1 = v(end, y);
  const double above0 = z0 - cell.height(u0, v0);
  const double above1 = z1 - cell.height(u1, v1);
  const auto differ = [](double a, double b) { return (a < 0) != (b < 0); };
  if (above0 == 0 || (!std::isnan(m_above) && differ(m_above, above0))) {
    hit(patch, cell, x, y, begin);
    return true;
  }
  double from = begin, above = above0;
  const double side0 = u0 - v0, side1 = u1 - v1;
  if ((side0 > 0 && side1 < 0) || (side0 < 0 && side1 > 0)) {
    const double middle = begin + (end - begin) * (side0 / (side0 - side1));
    const double on = u(middle, x);
    const double aboveMiddle = z(middle) - cell.height(on, on);
    if (aboveMiddle == 0 || differ(above, aboveMiddle)) {
      hit(patch, cell, x, y, from + (middle - from) * (above / (above - aboveMiddle)));
      return true;
    }
    from = middle;
    above = aboveMiddle;
  }
  if (above1 == 0 || differ(above, above1)) {
    hit(patch, cell, x, y, from + (end - from) * (above / (above - above1)));
    return true;
  }
  m_above = above1;
  m_aboveAt = end;
  return false;
}

void Marcher::hit(const TePatchData& patch, const TeSurfaceCell& cell, int x, int y, double at) {
  TeRayHit found;
  found.distance = at;
  found.position = {m_origin.x + at * m_direction.x, m_origin.y + at * m_direction.y,
                    cell.height(u(at, x), v(at, y))};
  found.normal = cell.normal(u(at, x), v(at, y), m_spacing);
  found.key = patch.key();
  m_hit = found;
}

} // namespace

std::optional<TeRayHit> teMarchRay(const TeLattice& lattice, const TeGrowingTree& tree, glm::dvec3 origin,
                                   glm::dvec3 direction, double maxDistance) {
  const auto finite = [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (!finite(origin) || !finite(direction) || !(maxDistance >= 0))
    return std::nullopt;
  // A largest component of 1 keeps every product below in range.
  const double scale = std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
  Marcher marcher(lattice, origin, direction / scale, maxDistance * scale);
  tree.traverse([&](const TeGrowingTree::Bounds& bounds) { return marcher.enter(bounds); },
                [&](const TePatchData& patch) { return marcher.visit(patch); });
  if (marcher.m_hit)
    marcher.m_hit->distance /= scale;
  return marcher.m_hit;
}
