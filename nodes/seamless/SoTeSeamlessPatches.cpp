#include "nodes/seamless/SoTeSeamlessPatches.h"

#include "nodes/TeCoinVectors.h"
#include "nodes/seamless/TeSeamlessSceneReader.h"
#include "nodes/terrain/SoTeTerrainDetail.h"

#include <Inventor/SbLine.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoRayPickAction.h>

#include <algorithm>

SO_NODE_SOURCE(SoTeSeamlessPatches)

void SoTeSeamlessPatches::initClass() {
  SoTeLodShape::initClass();
  if (classTypeId == SoType::badType())
    PRIVATE_COMMON_INIT_CODE(SoTeSeamlessPatches, "TeSeamlessPatches", &SoTeSeamlessPatches::createInstance,
                             SoTeLodShape);
}

SoTeSeamlessPatches::SoTeSeamlessPatches() : SoTeLodShape(0) {
  SO_NODE_CONSTRUCTOR(SoTeSeamlessPatches);
  SO_NODE_ADD_FIELD(resolution, (4096));
  SO_NODE_ADD_FIELD(minPatchResolution, (16));
  SO_NODE_ADD_FIELD(levels, (3));
  SO_NODE_ADD_FIELD(precision, (2));
  SO_NODE_ADD_FIELD(maxPatches, (20000));
  SO_NODE_ADD_FIELD(instancing, (TRUE));
  SO_NODE_ADD_FIELD(wholePatches, (TRUE));
  SO_NODE_DEFINE_ENUM_VALUE(HeightSource, FLAT);
  SO_NODE_DEFINE_ENUM_VALUE(HeightSource, HEIGHTMAP);
  SO_NODE_DEFINE_ENUM_VALUE(HeightSource, CLIPMAPS);
  SO_NODE_SET_SF_ENUM_TYPE(heightSource, HeightSource);
  SO_NODE_ADD_FIELD(heightSource, (FLAT));
  SO_NODE_ADD_FIELD(heights, (nullptr));
  SO_NODE_DEFINE_ENUM_VALUE(Coloring, PLAIN);
  SO_NODE_DEFINE_ENUM_VALUE(Coloring, TEXTURE);
  SO_NODE_DEFINE_ENUM_VALUE(Coloring, DETAIL);
  SO_NODE_DEFINE_ENUM_VALUE(Coloring, HEIGHT);
  SO_NODE_SET_SF_ENUM_TYPE(coloring, Coloring);
  SO_NODE_ADD_FIELD(coloring, (PLAIN));
  SO_NODE_ADD_FIELD(tileColor, (1, 1, 1));
  SO_NODE_ADD_FIELD(stripColor, (1, 0, 0));
  SO_NODE_ADD_FIELD(texture, (""));
  SO_NODE_ADD_FIELD(colors, (nullptr));
  SO_NODE_ADD_FIELD(mask, (""));
  SO_NODE_ADD_EMPTY_MFIELD(detailTextures);
  SO_NODE_ADD_FIELD(detailRepeat, (64));
  SO_NODE_ADD_EMPTY_MFIELD(groundColors);
  SO_NODE_ADD_EMPTY_MFIELD(groundHeights);
  SO_NODE_ADD_EMPTY_MFIELD(groundSlopes);
}

SoTeSeamlessPatches::~SoTeSeamlessPatches() = default;

bool SoTeSeamlessPatches::decidesHeights(const SoField* field) const {
  const SoField* const fields[] = {&resolution, &minPatchResolution, &levels, &heightSource, &heights};
  return inherited::decidesHeights(field) ||
         std::find(std::begin(fields), std::end(fields), field) != std::end(fields);
}

TeStatus SoTeSeamlessPatches::load(bool& isReported) {
  m_viewers.clear();
  m_content = {};
  TeResult<TeSeamlessContent> content = readContent(isReported);
  if (!content)
    return content.error();
  m_content = std::move(*content);
  return {};
}

TeStatus SoTeSeamlessPatches::build(bool& isReported) {
  TeSeamlessSceneReader reader(*this, folder(), m_pictures);
  TeResult<TeSeamlessScene> scene = reader.read(m_content, middle());
  isReported = reader.isReported();
  if (!scene)
    return scene.error();
  const TeResult<TeNodePtr<SoCamera>> camera = readLodCamera();
  if (!camera)
    return camera.error();
  scene->lodCamera = *camera;
  m_viewers.setScene(std::move(*scene));
  return {};
}

TeResult<TeSeamlessContent> SoTeSeamlessPatches::readContent(bool& isReported) const {
  const TeSeamlessContent::Sizes sizes{resolution.getValue(), minPatchResolution.getValue(),
                                       levels.getValue()};
  switch (heightSource.getValue()) {
  case FLAT:
    return TeSeamlessContent::flat(sizes);
  case HEIGHTMAP: {
    if (givenHeights())
      return TeSeamlessContent::ofMap(givenHeights(), sizes);
    const TeResult<std::string> path = heightPath();
    if (!path)
      return path.error();
    return TeSeamlessContent::ofFile(*path, verticalUnit.getValue().getString(), sizes);
  }
  case CLIPMAPS:
    return TeSeamlessContent::ofClipmap(heights.getValue(), sizes, isReported);
  }
  return TeError{"heightSource " + std::to_string(heightSource.getValue()) + " is none of the three"};
}

TeStatus SoTeSeamlessPatches::draw(SoGLRenderAction* action) {
  sendMaterial(action);
  return m_viewers.draw(action);
}

void SoTeSeamlessPatches::emitTriangles(SoAction* action) {
  const SbBox3f box = m_viewers.box();
  const float side = box.getMax()[0] - box.getMin()[0];
  SoPrimitiveVertex primitive;
  beginShape(action, TRIANGLES);
  m_viewers.forEachPatch(action, nullptr, [&](const TeSeamlessPatch& patch, TeSeamlessSurface& surface) {
    for (const TeSeamlessSurface::Triangle& triangle : surface.triangles(patch)) {
      primitive.setNormal(triangle.normal());
      for (const SbVec3f& corner : triangle.corners) {
        primitive.setPoint(corner);
        primitive.setTextureCoords(
            SbVec4f((corner[0] - box.getMin()[0]) / side, (corner[1] - box.getMin()[1]) / side, 0, 1));
        shapeVertex(&primitive);
      }
    }
  });
  endShape();
}

void SoTeSeamlessPatches::pickTriangles(SoRayPickAction* action) {
  const SbLine along = action->getLine();
  m_viewers.forEachPatch(action, &along, [&](const TeSeamlessPatch& patch, TeSeamlessSurface& surface) {
    if (!action->intersect(surface.box(patch), TRUE))
      return;
    for (const TeSeamlessSurface::Triangle& triangle : surface.triangles(patch))
      pickTriangle(action, patch, triangle);
  });
}

void SoTeSeamlessPatches::pickTriangle(SoRayPickAction* action, const TeSeamlessPatch& patch,
                                       const TeSeamlessSurface::Triangle& triangle) {
  SbVec3f point;
  SbVec3f barycentric;
  SbBool isFront;
  if (!action->intersect(triangle.corners[0], triangle.corners[1], triangle.corners[2], point, barycentric,
                         isFront) ||
      !action->isBetweenPlanes(point))
    return;
  SoPickedPoint* picked = action->addIntersection(point);
  if (!picked)
    return;
  const SbVec3f normal = triangle.normal();
  picked->setObjectNormal(normal);
  TeRayHit hit;
  hit.distance = double((point - action->getLine().getPosition()).length());
  hit.position = teToGlm(origin.getValue()) + teToGlm(point);
  hit.normal = teToGlm(normal);
  hit.key = {patch.x, patch.y, m_content.terrain->layout.depth() - 1 - patch.level};
  picked->setDetail(new SoTeTerrainDetail(hit), this);
}
