#pragma once

#include "patchdb/TeRayHit.h"

#include <Inventor/details/SoSubDetail.h>

/// Where terrain was picked: in double precision, in the terrain's own metres, whatever scale it is drawn at.
/// Found on the SoPickedPoint for the terrain node: SoPickedPoint::getDetail(terrainNode).
class SoTeTerrainDetail : public SoDetail {
  typedef SoDetail inherited;
  SO_DETAIL_HEADER(SoTeTerrainDetail);

public:
  SoTeTerrainDetail() = default;
  explicit SoTeTerrainDetail(const TeRayHit& hit) : m_hit(hit) {}
  static void initClass();
  SoDetail* copy() const override { return new SoTeTerrainDetail(*this); }

  /// The patch that was hit.
  const TePatchKey& getPatchKey() const { return m_hit.key; }
  /// World position, metres; z is the height.
  const glm::dvec3& getPosition() const { return m_hit.position; }
  double getHeight() const { return m_hit.position.z; }
  /// Unit normal of the triangle that was hit.
  const glm::dvec3& getNormal() const { return m_hit.normal; }

private:
  TeRayHit m_hit;
};
