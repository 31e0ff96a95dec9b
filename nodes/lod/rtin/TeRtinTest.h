#pragma once

#include "nodes/lod/TeLodField.h"
#include "nodes/lod/TeLodSelection.h"
#include "nodes/lod/TeLodView.h"
#include "nodes/lod/rtin/TeRtinRanges.h"
#include "nodes/lod/rtin/TeRtinTriangle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

/// Asks of right triangles whether a view sees them, and whether their errors are small enough for it.
class TeRtinTest {
public:
  struct Box {
    glm::dvec3 low;
    glm::dvec3 high;
  };

  TeRtinTest(const TeLodField& field, const TeRtinRanges& ranges, const TeLodView& view,
             const TeLodAccuracy& accuracy)
      : m_field(field), m_ranges(ranges), m_view(view), m_usesDial(accuracy.dial > 0),
        m_isExact(!m_usesDial && !(accuracy.pixelError > 0)),
        m_wanted(m_usesDial ? accuracy.dial : accuracy.pixelError) {}

  bool isExact() const { return m_isExact; }
  /// All planes of the view.
  std::uint32_t allPlanes() const { return (1U << m_view.planeCount) - 1; }

  /// Holds the true positions of the samples that a triangle covers.
  Box box(const TeRtinTriangle& triangle) const {
    const auto [low, high] = heights(triangle);
    return {m_field.position(triangle.lowColumn(), triangle.lowRow(), double(low)),
            m_field.position(triangle.highColumn(), triangle.highRow(), double(high))};
  }

  /// False if nothing of a box is seen. Takes planes away that do not cut it: they need not be tried for what
  /// it contains.
  bool isSeen(const Box& box, std::uint32_t& planes) const {
    for (int i = 0; planes >> i != 0; i++) {
      if ((planes >> i & 1) == 0)
        continue;
      const glm::dvec4& plane = m_view.planes[std::size_t(i)];
      const bool x = plane.x > 0, y = plane.y > 0, z = plane.z > 0;
      const double farthest = plane.x * (x ? box.high.x : box.low.x) +
                              plane.y * (y ? box.high.y : box.low.y) +
                              plane.z * (z ? box.high.z : box.low.z) + plane.w;
      if (farthest < 0)
        return false;
      const double nearest = plane.x * (x ? box.low.x : box.high.x) + plane.y * (y ? box.low.y : box.high.y) +
                             plane.z * (z ? box.low.z : box.high.z) + plane.w;
      if (nearest > 0)
        planes &= ~(1U << i);
    }
    return true;
  }

  /// From the nearest place that the eye may be at to a box; 1 without perspective.
  double distanceTo(const Box& box) const {
    if (!m_view.perspective)
      return 1;
    const glm::dvec3& eye = m_view.eye;
    const double x = std::max(std::max(box.low.x - eye.x, eye.x - box.high.x), 0.0);
    const double y = std::max(std::max(box.low.y - eye.y, eye.y - box.high.y), 0.0);
    const double z = std::max(std::max(box.low.z - eye.z, eye.z - box.high.z), 0.0);
    return std::max(std::sqrt(x * x + y * y + z * z) - m_view.slack, 0.0);
  }

  /// Whether an error, in the unit of the samples, is small enough at a distance; then it counts for worst()
  /// and worstMetres().
  bool isFine(float error, double distance) {
    const double metres = double(error) * m_field.heightScale();
    const double pixels = kRounding * metres * m_view.focal;
    if (m_isExact || (m_usesDial ? metres > m_wanted : pixels > m_wanted * distance))
      return false;
    count(metres, pixels, distance);
    return true;
  }
  /// The same where a distance is known that may be too small: true spares finding the true one. It is not
  /// said of what might make worst() larger with a dial, where nothing else limits it.
  bool isFineAnyway(float error, double distance) {
    const double metres = double(error) * m_field.heightScale();
    if (m_usesDial && kRounding * metres * m_view.focal > m_worst * distance)
      return false;
    return isFine(error, distance);
  }

  double worst() const { return m_worst; }             ///< pixels, rounded up
  double worstMetres() const { return m_worstMetres; } ///< of these errors

private:
  /// For what rounds in positions and distances.
  static constexpr double kRounding = 1 + 1e-11;

  TeRtinRanges::Range heights(const TeRtinTriangle& triangle) const {
    const int column = triangle.lowColumn(), row = triangle.lowRow();
    const int log = triangle.sizeLog();
    if (triangle.isHalfSquare() || log <= TeRtinRanges::kLeastLog)
      return m_ranges.range(log, column, row);
    // Two squares of half the size, side by side along the hypotenuse.
    const bool along = triangle.highRow() - row < triangle.highColumn() - column;
    const int half = 1 << (log - 1);
    const TeRtinRanges::Range a = m_ranges.range(log - 1, column, row);
    const TeRtinRanges::Range b =
        m_ranges.range(log - 1, column + (along ? half : 0), row + (along ? 0 : half));
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
  }

  void count(double metres, double pixels, double distance) {
    m_worstMetres = std::max(m_worstMetres, metres);
    if (pixels > m_worst * distance)
      m_worst = distance > 0 ? pixels / distance : std::numeric_limits<double>::infinity();
  }

  const TeLodField& m_field;
  const TeRtinRanges& m_ranges;
  const TeLodView& m_view;
  bool m_usesDial;
  bool m_isExact;
  double m_wanted; ///< pixels, or metres with a dial
  double m_worst = 0;
  double m_worstMetres = 0;
};
