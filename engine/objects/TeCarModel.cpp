#include "engine/objects/TeCarModel.h"

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoIndexedFaceSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoTranslation.h>

#include <cmath>
#include <vector>

namespace {

using Geometry = TeCarGeometry;

constexpr float kHalfPi = 1.57079633f;

SoMaterial* material(const SbColor& colour, float shine = 0) {
  auto* material = new SoMaterial;
  material->diffuseColor = colour;
  material->ambientColor = colour;
  material->specularColor.setValue(shine, shine, shine);
  material->shininess = 0.4f;
  return material;
}

SoMaterial* lamp(const SbColor& colour) {
  SoMaterial* lamp = material(colour);
  lamp->emissiveColor = colour * 0.7f;
  return lamp;
}

SoSeparator* box(const SbVec3f& centre, const SbVec3f& size) {
  auto* part = new SoSeparator;
  auto* place = new SoTranslation;
  place->translation = centre;
  auto* cube = new SoCube;
  cube->width = size[0];
  cube->height = size[1];
  cube->depth = size[2];
  part->addChild(place);
  part->addChild(cube);
  return part;
}

/// Outlines of a hull, seen from above, one over the other: half widths and y of the back and front edges.
struct Section {
  float z, halfWidth, back, front;
};

/// A closed hull through sections from below to above.
SoSeparator* hull(const std::vector<Section>& sections) {
  auto* part = new SoSeparator;
  auto* points = new SoCoordinate3;
  auto* faces = new SoIndexedFaceSet;
  int count = 0, index = 0;
  for (const Section& s : sections) {
    points->point.set1Value(count++, -s.halfWidth, s.back, s.z);
    points->point.set1Value(count++, s.halfWidth, s.back, s.z);
    points->point.set1Value(count++, s.halfWidth, s.front, s.z);
    points->point.set1Value(count++, -s.halfWidth, s.front, s.z);
  }
  const auto face = [&](int a, int b, int c, int d) {
    for (const int corner : {a, b, c, d, -1})
      faces->coordIndex.set1Value(index++, corner);
  };
  for (int low = 0; low + 4 < count; low += 4)
    for (int side = 0; side < 4; ++side)
      face(low + side, low + (side + 1) % 4, low + 4 + (side + 1) % 4, low + 4 + side);
  face(3, 2, 1, 0);
  face(count - 4, count - 3, count - 2, count - 1);
  part->addChild(points);
  part->addChild(faces);
  return part;
}

void addBody(SoSeparator* body) {
  body->addChild(material(SbColor(0.72f, 0.16f, 0.08f), 0.3f));
  body->addChild(hull({{0.42f, 0.56f, -1.75f, 1.70f},
                       {0.62f, 0.64f, -1.95f, 1.95f},
                       {0.98f, 0.64f, -1.95f, 1.90f},
                       {1.04f, 0.58f, -1.90f, 0.75f}}));
  body->addChild(hull({{1.58f, 0.50f, -1.30f, 0.02f}, {1.66f, 0.46f, -1.22f, -0.05f}})); // roof
  body->addChild(material(SbColor(0.10f, 0.14f, 0.18f), 0.8f));
  body->addChild(hull({{1.04f, 0.57f, -1.50f, 0.55f}, {1.58f, 0.50f, -1.28f, 0.00f}})); // windows
  body->addChild(material(SbColor(0.13f, 0.13f, 0.14f), 0.2f));
  body->addChild(box({0, 2.00f, 0.62f}, {1.36f, 0.14f, 0.16f})); // bumpers
  body->addChild(box({0, -2.00f, 0.62f}, {1.36f, 0.14f, 0.16f}));
  body->addChild(box({0, 0, 0.42f}, {1.10f, 2.90f, 0.10f})); // frame
  body->addChild(box({0, 1.93f, 0.84f}, {0.60f, 0.04f, 0.14f}));
  body->addChild(box({0, 1.25f, 1.00f}, {0.46f, 0.50f, 0.09f}));      // air scoop
  body->addChild(box({-0.74f, 0.50f, 1.14f}, {0.20f, 0.07f, 0.14f})); // mirrors
  body->addChild(box({0.74f, 0.50f, 1.14f}, {0.20f, 0.07f, 0.14f}));
  body->addChild(lamp(SbColor(1.0f, 0.95f, 0.75f)));
  body->addChild(box({-0.48f, 1.93f, 0.84f}, {0.20f, 0.06f, 0.16f}));
  body->addChild(box({0.48f, 1.93f, 0.84f}, {0.20f, 0.06f, 0.16f}));
  body->addChild(lamp(SbColor(0.85f, 0.05f, 0.03f)));
  body->addChild(box({-0.52f, -1.95f, 0.86f}, {0.16f, 0.06f, 0.12f}));
  body->addChild(box({0.52f, -1.95f, 0.86f}, {0.16f, 0.06f, 0.12f}));
}

/// A wheel about its axle, which lies along x; spokes show that it turns.
SoSeparator* wheelShape() {
  auto* wheel = new SoSeparator;
  const auto radius = float(Geometry::kWheelRadius);
  const auto width = float(Geometry::kWheelWidth);
  auto* lay = new SoTransform;
  lay->rotation.setValue(SbVec3f(0, 0, 1), kHalfPi);
  auto* tyre = new SoCylinder;
  tyre->radius = radius;
  tyre->height = width;
  auto* rim = new SoCylinder;
  rim->radius = 0.62f * radius;
  rim->height = width + 0.02f;
  auto* round = new SoSeparator;
  round->addChild(lay);
  round->addChild(material(SbColor(0.07f, 0.07f, 0.07f)));
  round->addChild(tyre);
  round->addChild(material(SbColor(0.55f, 0.56f, 0.58f), 0.5f));
  round->addChild(rim);
  wheel->addChild(round);
  wheel->addChild(material(SbColor(0.20f, 0.20f, 0.21f)));
  wheel->addChild(box({0, 0, 0}, {width + 0.05f, 1.1f * radius, 0.07f}));
  wheel->addChild(box({0, 0, 0}, {width + 0.05f, 0.07f, 1.1f * radius}));
  return wheel;
}

} // namespace

TeCarModel::TeCarModel() : m_root(new SoSeparator) {
  auto* hints = new SoShapeHints;
  hints->vertexOrdering = SoShapeHints::COUNTERCLOCKWISE;
  hints->shapeType = SoShapeHints::SOLID;
  hints->faceType = SoShapeHints::CONVEX;
  hints->creaseAngle = 0.4f;
  m_root->addChild(hints);
  auto* body = new SoSeparator;
  addBody(body);
  m_root->addChild(body);

  const TeNodePtr<SoSeparator> shape(wheelShape());
  for (int i = 0; i < Geometry::kWheels; ++i) {
    Wheel& wheel = m_wheels[i];
    wheel.hub = new SoTransform;
    wheel.axle = new SoTransform;
    auto* parts = new SoSeparator;
    parts->addChild(wheel.hub.get());
    parts->addChild(wheel.axle.get());
    parts->addChild(shape.get());
    m_root->addChild(parts);
    setWheel(i, 0, 0, 0);
  }
}

void TeCarModel::setWheel(int wheel, double travel, double steering, double turned) {
  const glm::dvec3 middle = Geometry::wheel(wheel) + glm::dvec3(0, 0, Geometry::kWheelRadius + travel);
  const SbVec3f place{float(middle.x), float(middle.y), float(middle.z)};
  const SbRotation direction(SbVec3f(0, 0, 1), float(std::atan(steering)));
  const SbRotation rolling(SbVec3f(1, 0, 0), float(-turned));
  const Wheel& moved = m_wheels[wheel];
  // Only what differs, so that a car at rest leaves the scene alone.
  if (moved.hub->translation.getValue() != place)
    moved.hub->translation = place;
  if (moved.hub->rotation.getValue() != direction)
    moved.hub->rotation = direction;
  if (moved.axle->rotation.getValue() != rolling)
    moved.axle->rotation = rolling;
}
