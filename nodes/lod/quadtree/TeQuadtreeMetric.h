#pragma once

#include "nodes/lod/TeLodField.h"
#include "nodes/lod/TeLodView.h"

#include <algorithm>
#include <limits>

/// A box over the lattice of a quadtree: columns, rows, and heights in their unit.
struct TeQuadtreeBox {
  double x0, x1, y0, y1, z0, z1;
};

/// What a view makes of boxes and errors of a quadtree: distances in metres, to the nearest point of the box.
/// An orthographic view has all at distance 1.
class TeQuadtreeMetric {
public:
  static constexpr unsigned kOutside = 0x80; ///< in place of planes

  TeQuadtreeMetric() = default;
  TeQuadtreeMetric(const TeLodView& view, const TeLodField::Placement& placement, double side);

  unsigned allPlanes() const { return (1u << m_planeCount) - 1; }
  double focal() const { return m_focal; }
  double heightScale() const { return m_heightScale; }

  double distance2(const TeQuadtreeBox& box) const {
    if (!m_perspective)
      return 1;
    const double x = across(m_x, box.x0, box.x1), y = across(m_y, box.y0, box.y1), z = up(box);
    return x * x + y * y + z * z;
  }
  /// Not more than the square of the distance of any box over a rectangle, of heights within setRange().
  double leastDistance2(double x0, double x1, double y0, double y1) const {
    if (!m_perspective)
      return 1;
    const double x = across(m_x, x0, x1), y = across(m_y, y0, y1);
    return x * x + y * y + m_leastUp2;
  }
  void setRange(double low, double high) {
    const double least = up({0, 0, 0, 0, low, high});
    m_leastUp2 = least * least;
  }
  /// The document's: largest of the distances along the axes.
  double maxNorm(const TeQuadtreeBox& box) const {
    if (!m_perspective)
      return 1;
    return std::max({across(m_x, box.x0, box.x1), across(m_y, box.y0, box.y1), up(box)});
  }
  /// Square of the screen error in pixels of a deviation, in the unit of heights; rounded up.
  double pixels2(double deviation, double distance2) const {
    if (deviation == 0)
      return 0;
    const double square = deviation * deviation * m_focal2;
    return distance2 > 0 ? square / distance2 : std::numeric_limits<double>::infinity();
  }

  /// From now on vertices may be drawn off their heights by so many pixels: cut() counts that.
  void setMorph(double pixels) { m_morph = pixels > 0 && m_focal > 0 ? pixels / m_focal : 0; }
  /// Those of `planes` that cut the box; kOutside if nothing of it is in view. A box inside of another never
  /// has more.
  unsigned cut(const TeQuadtreeBox& box, unsigned planes) const;

private:
  struct Plane {
    double x, y, z, w;
  };

  double across(double eye, double low, double high) const {
    return std::max(std::max(low - eye, eye - high) * m_spacing - m_slack, 0.0);
  }
  double up(const TeQuadtreeBox& box) const {
    return std::max(std::max(box.z0 * m_heightScale - m_z, m_z - box.z1 * m_heightScale) - m_slack, 0.0);
  }

  /// Not less than the distance of any point of the box; of boxes inside of it, it is not more.
  double farthest(const TeQuadtreeBox& box) const;

  bool m_perspective = true;
  double m_x = 0, m_y = 0; ///< eye, in the lattice
  double m_z = 0;          ///< metres above the terrain's corner
  double m_spacing = 1, m_heightScale = 1, m_slack = 0;
  double m_focal = 1;  ///< pixels of a unit of height at a distance of a metre
  double m_focal2 = 1; ///< its square, rounded up
  double m_leastUp2 = 0;
  double m_morph = 0; ///< heights a metre of distance
  int m_planeCount = 0;
  Plane m_planes[6] = {}; ///< over the lattice
};
