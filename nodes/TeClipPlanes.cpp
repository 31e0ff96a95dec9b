#include "nodes/TeClipPlanes.h"

#include <Inventor/SbMatrix.h>
#include <Inventor/SbXfBox3f.h>
#include <Inventor/SoPath.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetMatrixAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <algorithm>
#include <limits>

namespace {

constexpr float kNearPerFar = 1e-4f;
constexpr float kMargin = 0.01f; ///< of the depth, on both sides, against rounding

void setSilently(SoSFFloat& field, float value) {
  const SbBool notified = field.enableNotify(FALSE);
  field.setValue(value);
  field.enableNotify(notified);
}

/// The last node of a path, also where it is hidden in a node kit. Coin means any path to be looked at as a
/// full one, which the sanitizer does not know.
__attribute__((no_sanitize("vptr"))) SoNode* tailOf(SoPath* path) {
  return static_cast<SoFullPath*>(path)->getTail();
}

} // namespace

TeStatus teFitClipPlanes(SoNode* scene, const SbViewportRegion& viewport) {
  SoSearchAction search;
  search.setType(SoCamera::getClassTypeId());
  search.setInterest(SoSearchAction::FIRST);
  search.apply(scene);
  if (!search.getPath())
    return TeError{"the scene has no camera"};
  SoCamera* camera = static_cast<SoCamera*>(tailOf(search.getPath()));

  SoGetBoundingBoxAction bounds(viewport);
  bounds.apply(scene);
  if (bounds.getBoundingBox().isEmpty())
    return {};
  SoGetMatrixAction place(viewport);
  place.apply(search.getPath());
  SbVec3f eye;
  SbVec3f forward;
  place.getMatrix().multVecMatrix(camera->position.getValue(), eye);
  camera->orientation.getValue().multVec(SbVec3f(0, 0, -1), forward);
  place.getMatrix().multDirMatrix(forward, forward);
  forward.normalize();

  const SbBox3f box = bounds.getBoundingBox();
  float nearest = std::numeric_limits<float>::max();
  float farthest = -nearest;
  for (int corner = 0; corner < 8; corner++) {
    const SbVec3f point((corner & 1 ? box.getMax() : box.getMin())[0],
                        (corner & 2 ? box.getMax() : box.getMin())[1],
                        (corner & 4 ? box.getMax() : box.getMin())[2]);
    const float distance = (point - eye).dot(forward);
    nearest = std::min(nearest, distance);
    farthest = std::max(farthest, distance);
  }
  const float margin = std::max(kMargin * (farthest - nearest), 1e-3f);
  nearest -= margin;
  farthest += margin;
  if (camera->isOfType(SoPerspectiveCamera::getClassTypeId())) {
    farthest = std::max(farthest, 1e-3f);
    nearest = std::max(nearest, farthest * kNearPerFar);
  }
  setSilently(camera->nearDistance, nearest);
  setSilently(camera->farDistance, farthest);
  return {};
}
