#include "apps/terrane-view/TeViewContent.h"

#include "apps/common/TeProgressLine.h"
#include "apps/terrane-view/TeDemMap.h"
#include "apps/terrane-view/TeSceneReading.h"
#include "apps/terrane-view/TeTerrainScene.h"

#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetMatrixAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoLight.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoRotation.h>

#include <algorithm>
#include <cmath>

namespace {

const SbViewportRegion kAnyViewport(1, 1);

/// The first node of a type; the action keeps the path.
SoPath* firstOf(SoSearchAction& search, SoNode* root, const SoType& type) {
  search.setType(type);
  search.setInterest(SoSearchAction::FIRST);
  search.apply(root);
  return search.getPath();
}

/// Takes the scene's first camera out, whose place another one will have, and tells how it stood.
void takeCamera(SoSeparator* root, TeViewContent& content) {
  SoSearchAction search;
  SoPath* path = firstOf(search, root, SoCamera::getClassTypeId());
  if (!path || path->getLength() < 2)
    return;
  SoGetMatrixAction place(kAnyViewport);
  place.apply(path);
  SoCamera* camera = static_cast<SoCamera*>(path->getTail());
  SbVec3f eye, scale;
  SbRotation turn, ignored;
  SbVec3f shift;
  place.getMatrix().getTransform(shift, turn, scale, ignored);
  place.getMatrix().multVecMatrix(camera->position.getValue(), eye);
  const SbRotation orientation = camera->orientation.getValue() * turn;
  float x, y, z, w;
  orientation.getValue(x, y, z, w);
  content.start = TeViewPose{{eye[0], eye[1], eye[2]}, glm::normalize(glm::dquat(w, x, y, z))};
  if (camera->isOfType(SoPerspectiveCamera::getClassTypeId()))
    content.heightAngle = static_cast<SoPerspectiveCamera*>(camera)->heightAngle.getValue();
  SoNode* parent = path->getNodeFromTail(1);
  if (parent->isOfType(SoGroup::getClassTypeId()))
    static_cast<SoGroup*>(parent)->replaceChild(camera, new SoGroup);
}

/// Whether y is up: as the option says, or the camera's own up is nearer to it than to z.
bool isYUp(const TeViewOptions& options, SoNode* scene) {
  if (!options.up.empty())
    return options.up == "y";
  SoSearchAction search;
  SoPath* path = firstOf(search, scene, SoCamera::getClassTypeId());
  if (!path)
    return false;
  SoGetMatrixAction place(kAnyViewport);
  place.apply(path);
  SbVec3f up;
  static_cast<SoCamera*>(path->getTail())->orientation.getValue().multVec(SbVec3f(0, 1, 0), up);
  place.getMatrix().multDirMatrix(up, up);
  return std::abs(up[1]) > std::abs(up[2]);
}

void findBox(TeViewContent& content) {
  SoGetBoundingBoxAction action(kAnyViewport);
  action.apply(content.root.get());
  const SbBox3f box = action.getBoundingBox();
  if (box.isEmpty())
    return;
  for (int axis = 0; axis < 3; ++axis) {
    content.low[axis] = box.getMin()[axis];
    content.high[axis] = box.getMax()[axis];
  }
}

TeViewContent contentOf(const TeTerrainScene& terrain, const std::string& description) {
  TeViewContent content;
  content.description = description;
  content.root = terrain.root;
  content.ground =
      std::make_unique<TeMapGround>(terrain.coarse, terrain.corner, terrain.spacing, terrain.heightScale);
  findBox(content);
  return content;
}

} // namespace

double TeViewContent::size() const {
  const glm::dvec3 sides = high - low;
  return std::max({sides.x, sides.y, sides.z, 1e-6});
}

TeResult<TeViewContent> TeViewContent::create(const TeViewOptions& options, bool quiet) {
  if (!options.scene.empty())
    return fromScene(options);
  return options.dem.empty() ? fromClipmaps(options) : fromDem(options, quiet);
}

TeResult<TeViewContent> TeViewContent::fromScene(const TeViewOptions& options) {
  const TeResult<TeNodePtr<SoSeparator>> scene = teReadScene(options.scene);
  if (!scene)
    return scene.error();
  TeViewContent content;
  content.description = options.scene;
  content.root = new SoSeparator;
  if (isYUp(options, scene->get())) {
    auto* turn = new SoRotation;
    turn->rotation = SbRotation(SbVec3f(0, 1, 0), SbVec3f(0, 0, 1));
    content.root->addChild(turn);
  }
  content.root->addChild(scene->get());
  takeCamera(content.root.get(), content);
  SoSearchAction search;
  content.lit = firstOf(search, content.root.get(), SoLight::getClassTypeId()) != nullptr;
  findBox(content);
  const double height = content.high.z - content.low.z, margin = 0.01 * content.size();
  content.ground =
      std::make_unique<TePickGround>(content.root.get(), content.high.z + margin, height + 2 * margin);
  return content;
}

TeResult<TeViewContent> TeViewContent::fromDem(const TeViewOptions& options, bool quiet) {
  const TeResult<TeElevationOptions> reading = options.reading.options();
  if (!reading)
    return reading.error();
  TeProgressLine progress("Reading heights", quiet);
  const TeResult<TeDemMap> dem =
      TeDemMap::read(options.dem, *reading, options.resolution, [&](double done) { progress.update(done); });
  if (!dem)
    return dem.error();
  const TeResult<TeTerrainScene> terrain = TeTerrainScene::fromMap(*dem, options);
  if (!terrain)
    return terrain.error();
  return contentOf(*terrain, options.dem);
}

TeResult<TeViewContent> TeViewContent::fromClipmaps(const TeViewOptions& options) {
  const TeResult<TeTerrainScene> terrain = TeTerrainScene::fromPyramid(options);
  if (!terrain)
    return terrain.error();
  return contentOf(*terrain, options.clipmaps);
}
