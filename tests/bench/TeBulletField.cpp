#include "tests/bench/TeBulletField.h"

#ifdef TERRANE_HAVE_BULLET

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

namespace {

constexpr int kChunk = 16; ///< cells a side, Bullet's own default

/// Keeps the nearest hit.
class Nearest final : public btTriangleRaycastCallback {
public:
  using btTriangleRaycastCallback::btTriangleRaycastCallback;
  btScalar reportHit(const btVector3&, btScalar fraction, int, int) override {
    m_hit = true;
    return fraction;
  }
  bool m_hit = false;
};

} // namespace

struct TeBulletField::Shape {
  Shape(const TeHeightMap& heights, const TeMapStatistics& statistics, double spacing)
      : field(heights.width(), heights.height(), heights.data(), statistics.minimum, statistics.maximum, 2,
              true),
        low(statistics.minimum), high(statistics.maximum), width(heights.width()) {
    field.setLocalScaling(btVector3(spacing, spacing, 1));
    field.buildAccelerator(kChunk);
  }

  btHeightfieldTerrainShape field;
  double low;
  double high;
  std::size_t width;
};

TeBulletField::TeBulletField(const TeHeightMap& heights, double spacing)
    : m_shape(std::make_unique<Shape>(heights, heights.statistics(), spacing)) {}

TeBulletField::~TeBulletField() = default;

// Bullet puts the middle of the heights at 0.
std::optional<double> TeBulletField::cast(glm::dvec3 from, glm::dvec3 to) const {
  const double middle = 0.5 * (m_shape->low + m_shape->high);
  const btVector3 begin(from.x, from.y, from.z - middle), end(to.x, to.y, to.z - middle);
  Nearest nearest(begin, end);
  m_shape->field.performRaycast(&nearest, begin, end);
  if (!nearest.m_hit)
    return std::nullopt;
  return double(nearest.m_hitFraction);
}

std::optional<double> TeBulletField::heightAt(double x, double y) const {
  const double high = m_shape->high + 1, low = m_shape->low - 1;
  const std::optional<double> hit = cast({x, y, high}, {x, y, low});
  if (!hit)
    return std::nullopt;
  return high + *hit * (low - high);
}

std::size_t TeBulletField::bytes() const {
  const std::size_t chunks = m_shape->width / kChunk;
  return m_shape->width * m_shape->width * sizeof(float) +
         chunks * chunks * sizeof(btHeightfieldTerrainShape::Range);
}

#endif
