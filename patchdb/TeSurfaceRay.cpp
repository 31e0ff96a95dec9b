#include "patchdb/TeSurfaceRay.h"

#include "patchdb/TePatchData.h"
#include "patchdb/TeSurfaceCell.inl"

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

/// Where a ray goes on, by [to the south, to the north, neither][to the west, to the east, neither].
constexpr TeDirection kBehind[3][3] = {{TeDirection::SouthWest, TeDirection::SouthEast, TeDirection::South},
                                       {TeDirection::NorthWest, TeDirection::NorthEast, TeDirection::North},
                                       {TeDirection::West, TeDirection::East, TeDirection::East}};

class Marcher {
public:
  Marcher(const TeLattice& lattice, int level, glm::dvec3 origin, glm::dvec3 direction, double range)
      : m_level(level), m_cells(lattice.cells()), m_halfCell(0.5 * lattice.spacing()),
        m_spacing(lattice.spacing() * std::ldexp(1.0, level)), m_perMetre(1 / m_spacing), m_origin(origin),
        m_direction(direction),
        m_inverse(inverseOf(direction.x), inverseOf(direction.y), inverseOf(direction.z)), m_range(range) {}

  /// Where the ray enters a square of patches; negative if it does not before its first hit, or was there.
  double enter(const TeGrowingTree::Bounds& bounds) const {
    double begin, end;
    return clipToPatches(bounds, begin, end) ? begin : -1;
  }

  /// Looks for a hit from where a patch is entered on: in it, and in those behind it as far as they are known
  /// without a gap.
  void visit(const TePatchData& patch);

  std::optional<TeRayHit> m_hit;

private:
  bool clipToPatches(const TeGrowingTree::Bounds& bounds, double& begin, double& end) const;
  bool cross(const TePatchData& patch, double begin, double end);
  /// Cells x0 .. x1-1, y0 .. y1-1 of a patch.
  struct Cells {
    int x0, y0, x1, y1;
  };
  bool march(const TePatchData& patch, int blockLevel, const Cells& cells, double begin, double end);
  bool crossBlock(const TePatchData& patch, int blockLevel, const Cells& cells, double begin, double end);
  bool crossCell(const TePatchData& patch, int x, int y, double begin, double end);
  TeSurfaceCell cellAt(const TePatchData& patch, int& x, int& y) const;
  void hit(const TePatchData& patch, const TeSurfaceCell& cell, int x, int y, double at);

  double u(double at, int x) const { return std::clamp(m_startU + at * m_stepU - x, 0.0, 1.0); }
  double v(double at, int y) const { return std::clamp(m_startV + at * m_stepV - y, 0.0, 1.0); }
  double z(double at) const { return m_origin.z + at * m_direction.z; }

  /// World coordinate of a patch's west or south border; the bits of TeLattice::position().
  double border(std::int64_t key) const {
    return double(2 * (key * (std::int64_t(1) << m_level)) * m_cells - m_cells) * m_halfCell;
  }

  int m_level;
  std::int64_t m_cells;
  double m_halfCell; ///< of the base level
  double m_spacing;
  double m_perMetre;
  glm::dvec3 m_origin;
  glm::dvec3 m_direction;
  glm::dvec3 m_inverse;
  double m_range;
  double m_done = -1; ///< all before it, and it, was looked at
  // The ray in cells of the patch at hand.
  double m_startU = 0, m_startV = 0, m_stepU = 0, m_stepV = 0;
  // How high above the surface the ray was where it was last looked at; NaN = nothing known.
  double m_above = NAN;
  double m_aboveAt = 0;
};

bool Marcher::clipToPatches(const TeGrowingTree::Bounds& bounds, double& begin, double& end) const {
  const std::int64_t limit = TeLattice::kMaxKey >> m_level;
  const auto inWorld = [limit](std::int64_t key) { return std::clamp(key, -limit, limit); };
  begin = std::max(0.0, m_done);
  end = m_range;
  return clip(m_origin.x, m_inverse.x, border(inWorld(bounds.x)), border(inWorld(bounds.x + bounds.span)),
              begin, end) &&
         clip(m_origin.y, m_inverse.y, border(inWorld(bounds.y)), border(inWorld(bounds.y + bounds.span)),
              begin, end) &&
         end > m_done;
}

void Marcher::visit(const TePatchData& first) {
  double begin, end;
  if (!clipToPatches({first.key().x, first.key().y, 1}, begin, end))
    return;
  const int eastward = m_direction.x > 0 ? 1 : 0, northward = m_direction.y > 0 ? 1 : 0;
  for (const TePatchData* patch = &first;;) {
    // As they are clipped to, so that what was crossed is not entered again.
    const double endX =
        m_inverse.x == 0 ? INFINITY : (border(patch->key().x + eastward) - m_origin.x) * m_inverse.x;
    const double endY =
        m_inverse.y == 0 ? INFINITY : (border(patch->key().y + northward) - m_origin.y) * m_inverse.y;
    end = std::min({m_range, endX, endY});
    if (patch->hasHeights() && cross(*patch, begin, end)) {
      m_range = m_hit->distance;
      return;
    }
    // A ray that runs along the border of two patches crosses both.
    if (m_inverse.x == 0 || m_inverse.y == 0)
      return;
    m_done = end;
    if (end >= m_range)
      return;
    patch = patch->neighbour(kBehind[endY <= end ? northward : 2][endX <= end ? eastward : 2]);
    if (!patch)
      return;
    begin = end;
  }
}

/// Looks for a hit in a patch, between its borders; true if there is one.
bool Marcher::cross(const TePatchData& patch, double begin, double end) {
  // The margin keeps the sign certain wherever the ray is cut off.
  const double margin = 1 + 1e-9 * std::max(std::fabs(patch.minimum()), std::fabs(patch.maximum()));
  if (!clip(m_origin.z, m_inverse.z, patch.minimum() - margin, patch.maximum() + margin, begin, end))
    return false;
  m_startU = (m_origin.x - border(patch.key().x)) / m_spacing;
  m_startV = (m_origin.y - border(patch.key().y)) / m_spacing;
  m_stepU = m_direction.x * m_perMetre;
  m_stepV = m_direction.y * m_perMetre;
  if (!(std::fabs(begin - m_aboveAt) <= 1e-12 * std::fabs(begin)))
    m_above = NAN;
  const int cells = int(m_cells);
  return march(patch, patch.blocks().levels() - 1, {0, 0, cells, cells}, begin, end);
}

/// Through the blocks of a level, which are cells if it is 0, of a block of the next; true if there is a hit.
bool Marcher::march(const TePatchData& patch, int blockLevel, const Cells& cells, double begin, double end) {
  const int shift = blockLevel * TeHeightBlocks::kShift;
  const int side = 1 << shift;
  // By the south-west cell of the block that holds a cell.
  const auto blockOf = [shift](double position, int low, int high) {
    return (int(std::min(std::max(position, double(low)), double(high - 1))) >> shift) << shift;
  };
  int x = blockOf(m_startU + begin * m_stepU, cells.x0, cells.x1);
  int y = blockOf(m_startV + begin * m_stepV, cells.y0, cells.y1);
  const bool eastward = m_stepU > 0, northward = m_stepV > 0;
  const double perU = m_inverse.x * m_spacing, perV = m_inverse.y * m_spacing;
  double at = begin;
  for (;;) {
    const int x1 = std::min(x + side, cells.x1), y1 = std::min(y + side, cells.y1);
    const double nextX = perU != 0 ? ((eastward ? x1 : x) - m_startU) * perU : INFINITY;
    const double nextY = perV != 0 ? ((northward ? y1 : y) - m_startV) * perV : INFINITY;
    const double next = std::max(at, std::min({nextX, nextY, end}));
    if (blockLevel == 0 ? crossCell(patch, x, y, at, next)
                        : crossBlock(patch, blockLevel, {x, y, x1, y1}, at, next))
      return true;
    const bool crossX = nextX <= next;
    const bool crossY = nextY <= next;
    x += crossX ? (eastward ? side : -side) : 0;
    y += crossY ? (northward ? side : -side) : 0;
    if ((!crossX && !crossY) || x < cells.x0 || x >= cells.x1 || y < cells.y0 || y >= cells.y1)
      return false;
    at = next;
  }
}

/// A block is passed over if the ray stays above or below it and was on that side before.
bool Marcher::crossBlock(const TePatchData& patch, int blockLevel, const Cells& cells, double begin,
                         double end) {
  const int shift = blockLevel * TeHeightBlocks::kShift;
  const TeHeightBlocks::Range& range = patch.blocks().range(blockLevel, cells.x0 >> shift, cells.y0 >> shift);
  const double z0 = z(begin), z1 = z(end);
  const bool over = std::min(z0, z1) > range.high;
  if (over || std::max(z0, z1) < range.low) {
    const double above = over ? z1 - range.high : z1 - range.low;
    if (std::isnan(m_above) || (m_above < 0) == (above < 0)) {
      m_above = above;
      m_aboveAt = end;
      return false;
    }
  }
  return march(patch, blockLevel - 1, cells, begin, end);
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
  const double above0 = z0 - teCellHeight(cell, u0, v0);
  const double above1 = z1 - teCellHeight(cell, u1, v1);
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
    const double aboveMiddle = z(middle) - teCellHeight(cell, on, on);
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

std::optional<TeRayHit> teMarchRay(const TeLattice& lattice, const TeGrowingTree& tree, int level,
                                   glm::dvec3 origin, glm::dvec3 direction, double maxDistance) {
  const auto finite = [](const glm::dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  if (!finite(origin) || !finite(direction) || !(maxDistance >= 0))
    return std::nullopt;
  // A largest component of 1 keeps every product below in range.
  const double scale = std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
  Marcher marcher(lattice, level, origin, direction / scale, maxDistance * scale);
  const double side = lattice.patchSide() * std::ldexp(1.0, level);
  const auto keyOf = [&](double at) {
    return std::int64_t(std::floor(std::clamp((at + 0.5 * lattice.patchSide()) / side, -0x1p50, 0x1p50)));
  };
  // Mostly the ray starts over known land, which needs no tree.
  const TePatchData* start =
      direction.x != 0 && direction.y != 0 ? tree.find(keyOf(origin.x), keyOf(origin.y)) : nullptr;
  if (start)
    marcher.visit(*start);
  if (!marcher.m_hit)
    tree.traverse([&](const TeGrowingTree::Bounds& bounds) { return marcher.enter(bounds); },
                  [&](const TePatchData& patch) {
                    marcher.visit(patch);
                    return true;
                  });
  if (marcher.m_hit)
    marcher.m_hit->distance /= scale;
  return marcher.m_hit;
}
