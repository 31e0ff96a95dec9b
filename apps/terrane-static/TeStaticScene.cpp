#include "apps/terrane-static/TeStaticScene.h"

#include "apps/common/TeLight.h"
#include "nodes/context/TeViewer.h"
#include "nodes/terrain/TeBlockGraph.h"

#include <Inventor/SbBox3f.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoPolygonOffset.h>

#include <algorithm>
#include <cmath>

namespace {

constexpr float kFieldOfView = 0.6f; ///< radians, of the shorter side
constexpr float kFilled = 0.94f;     ///< of the picture

/// Of what is drawn: cells with missing corners count nothing.
SbBox3f boxOf(SoNode* graph) {
  SoGetBoundingBoxAction action(SbViewportRegion(1, 1));
  action.apply(graph);
  const SbBox3f box = action.getBoundingBox();
  return box.isEmpty() ? SbBox3f(-1, -1, -1, 1, 1, 1) : box;
}

/// Where the box lies in the picture: the extremes of its corners in units of the half sides.
struct Framing {
  SbVec2f minimum{1e30f, 1e30f};
  SbVec2f maximum{-1e30f, -1e30f};
};

Framing framingOf(const SbBox3f& box, const SbVec3f& eye, const SbVec3f axes[3], const SbVec2f& tangents) {
  Framing framing;
  for (int corner = 0; corner < 8; ++corner) {
    SbVec3f point;
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = (corner >> axis & 1 ? box.getMax() : box.getMin())[axis] - eye[axis];
    for (int axis = 0; axis < 2; ++axis) {
      const float place = point.dot(axes[axis]) / (point.dot(axes[2]) * tangents[axis]);
      framing.minimum[axis] = std::min(framing.minimum[axis], place);
      framing.maximum[axis] = std::max(framing.maximum[axis], place);
    }
  }
  return framing;
}

/// Looks along `direction` with `up` upwards, from where the box fills the picture.
SoCamera* cameraAround(const SbBox3f& box, SbVec3f direction, SbVec3f up, float aspect) {
  direction.normalize();
  SbVec3f right = direction.cross(up);
  right.normalize();
  up = right.cross(direction);
  const SbVec3f axes[3] = {right, up, direction};
  // heightAngle is that of the shorter side in Coin's default mapping.
  const float tangent = std::tan(0.5f * kFieldOfView);
  const SbVec2f tangents(tangent * std::max(1.0f, aspect), tangent * std::max(1.0f, 1 / aspect));

  SbVec3f target = box.getCenter();
  const float radius = 0.5f * (box.getMax() - box.getMin()).length();
  float distance = radius / std::sin(0.5f * kFieldOfView);
  for (int round = 0; round < 20; ++round) {
    const Framing framing = framingOf(box, target - direction * distance, axes, tangents);
    const SbVec2f middle = (framing.minimum + framing.maximum) * 0.5f;
    const SbVec2f half = (framing.maximum - framing.minimum) * 0.5f;
    target += (right * (middle[0] * tangents[0]) + up * (middle[1] * tangents[1])) * distance;
    distance = std::max(distance * std::max(half[0], half[1]) / kFilled, radius * 1.01f);
  }

  SoPerspectiveCamera* camera = new SoPerspectiveCamera;
  camera->heightAngle = kFieldOfView;
  camera->position = target - direction * distance;
  camera->focalDistance = distance;
  SbMatrix rotation = SbMatrix::identity();
  for (int axis = 0; axis < 3; ++axis) {
    rotation[0][axis] = right[axis];
    rotation[1][axis] = up[axis];
    rotation[2][axis] = -direction[axis];
  }
  camera->orientation = SbRotation(rotation);
  return camera;
}

/// The lines of the triangles in their colours. What lies behind the surface is hidden by the surface itself
/// in the colour of the sky.
SoSeparator* wireframeOf(SoSeparator* graph) {
  SoSeparator* both = new SoSeparator;
  SoLightModel* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  both->addChild(unlit);

  SoSeparator* surface = new SoSeparator;
  surface->addChild(new SoPolygonOffset);
  SoBaseColor* sky = new SoBaseColor;
  sky->rgb = TeViewerOptions().background;
  sky->setOverride(TRUE);
  surface->addChild(sky);
  SoMaterialBinding* binding = new SoMaterialBinding;
  binding->value = SoMaterialBinding::OVERALL;
  binding->setOverride(TRUE);
  surface->addChild(binding);
  surface->addChild(graph);
  both->addChild(surface);

  SoSeparator* lines = new SoSeparator;
  SoDrawStyle* style = new SoDrawStyle;
  style->style = SoDrawStyle::LINES;
  lines->addChild(style);
  lines->addChild(graph);
  both->addChild(lines);
  return both;
}

} // namespace

TeResult<TeNodePtr<SoSeparator>> teStaticScene(const TeStaticBlock& block, const TeStaticOptions& options,
                                               float aspect) {
  TeBlockStyle style;
  style.showParts = options.parts;
  style.verticalScale = float(options.verticalScale);
  if (options.water)
    style.water = float(*options.water);
  if (!options.drape.empty()) {
    TeResult<TePicture> image = TePicture::readPng(options.drape);
    if (!image)
      return image.error();
    style.image = std::move(*image);
  }
  const TeResult<TeNodePtr<SoSeparator>> graph = teBlockGraph(block, style);
  if (!graph)
    return graph.error();

  const TeNodePtr<SoSeparator> scene(new SoSeparator);
  const SbBox3f box = boxOf(graph->get());
  scene->addChild(options.top ? cameraAround(box, SbVec3f(0, 0, -1), SbVec3f(0, 1, 0), aspect)
                              : cameraAround(box, SbVec3f(-0.3f, 0.85f, -0.5f), SbVec3f(0, 0, 1), aspect));
  // The sun low in the west, and the sky.
  teAddLight(*scene, SbVec3f(0.8f, -0.3f, -0.5f), SbColor(1.0f, 0.96f, 0.88f), 1.0f);
  teAddLight(*scene, SbVec3f(0, 0, -1), SbColor(0.8f, 0.9f, 1.0f), 0.4f);
  scene->addChild(options.wireframe ? wireframeOf(graph->get()) : graph->get());
  return scene;
}
