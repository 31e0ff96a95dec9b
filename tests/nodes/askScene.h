#pragma once

#include <Inventor/SbBox3f.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/nodes/SoShape.h>

#include <array>
#include <vector>

// What Coin's actions tell of a scene.

inline const SbViewportRegion kViewport(640, 480);

inline int triangles(SoNode* root) {
  SoGetPrimitiveCountAction count(kViewport);
  count.apply(root);
  return count.getTriangleCount();
}

inline SbBox3f boxOf(SoNode* root) {
  SoGetBoundingBoxAction bounds(kViewport);
  bounds.apply(root);
  return bounds.getBoundingBox();
}

/// The first node of a class; null: there is none.
template <class Node> Node* firstOf(SoNode* root) {
  SoSearchAction search;
  search.setType(Node::getClassTypeId());
  if (root)
    search.apply(root);
  return search.getPath() ? static_cast<Node*>(search.getPath()->getTail()) : nullptr;
}

/// What a ray straight down meets first; null: nothing.
inline const SoPickedPoint* pickDown(SoRayPickAction& action, SoNode* root, float x, float y) {
  action.setRay(SbVec3f(x, y, 5000), SbVec3f(0, 0, -1));
  action.apply(root);
  return action.getPickedPoint();
}

using EmittedTriangle = std::array<SbVec3f, 3>;

/// What SoCallbackAction gets, in the coordinates of each shape.
inline std::vector<EmittedTriangle> emitted(SoNode* root, const SbViewportRegion& viewport = kViewport) {
  std::vector<EmittedTriangle> result;
  SoCallbackAction action(viewport);
  action.addTriangleCallback(
      SoShape::getClassTypeId(),
      [](void* data, SoCallbackAction*, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b,
         const SoPrimitiveVertex* c) {
        static_cast<std::vector<EmittedTriangle>*>(data)->push_back(
            {a->getPoint(), b->getPoint(), c->getPoint()});
      },
      &result);
  action.apply(root);
  return result;
}

inline double areaFromAbove(const std::vector<EmittedTriangle>& mesh) {
  double area = 0;
  for (const EmittedTriangle& t : mesh)
    area += 0.5 * (double(t[1][0] - t[0][0]) * double(t[2][1] - t[0][1]) -
                   double(t[2][0] - t[0][0]) * double(t[1][1] - t[0][1]));
  return area;
}
