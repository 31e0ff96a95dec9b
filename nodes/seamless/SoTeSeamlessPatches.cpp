#include "nodes/seamless/SoTeSeamlessPatches.h"

#include "nodes/TeSceneFile.h"
#include "nodes/seamless/TeSeamlessSceneReader.h"
#include "nodes/terrain/SoTeTerrainDetail.h"

#include <Inventor/SbLine.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/bundles/SoMaterialBundle.h>
#include <Inventor/elements/SoCacheElement.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoGLLazyElement.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/misc/SoState.h>

#include <algorithm>
#include <filesystem>
#include <limits>

SO_NODE_SOURCE(SoTeSeamlessPatches)

namespace {

glm::dvec3 toGlm(const SbVec3d& vector) { return {vector[0], vector[1], vector[2]}; }

} // namespace

void SoTeSeamlessPatches::initClass() {
  if (classTypeId == SoType::badType())
    PRIVATE_COMMON_INIT_CODE(SoTeSeamlessPatches, "TeSeamlessPatches", &SoTeSeamlessPatches::createInstance,
                             SoShape);
}

SoTeSeamlessPatches::SoTeSeamlessPatches() {
  SO_NODE_CONSTRUCTOR(SoTeSeamlessPatches);
  SO_NODE_ADD_FIELD(size, (256, 256, 10));
  SO_NODE_ADD_FIELD(resolution, (4096));
  SO_NODE_ADD_FIELD(minPatchResolution, (16));
  SO_NODE_ADD_FIELD(levels, (3));
  SO_NODE_ADD_FIELD(precision, (2));
  SO_NODE_ADD_FIELD(pixelError, (0));
  SO_NODE_ADD_FIELD(maxPatches, (20000));
  SO_NODE_ADD_FIELD(geomorph, (FALSE));
  SO_NODE_ADD_FIELD(instancing, (TRUE));
  SO_NODE_ADD_FIELD(wholePatches, (TRUE));
  SO_NODE_ADD_FIELD(wireframe, (FALSE));
  SO_NODE_DEFINE_ENUM_VALUE(HeightSource, FLAT);
  SO_NODE_DEFINE_ENUM_VALUE(HeightSource, HEIGHTMAP);
  SO_NODE_DEFINE_ENUM_VALUE(HeightSource, CLIPMAPS);
  SO_NODE_SET_SF_ENUM_TYPE(heightSource, HeightSource);
  SO_NODE_ADD_FIELD(heightSource, (FLAT));
  SO_NODE_ADD_FIELD(heightFile, (""));
  SO_NODE_ADD_FIELD(verticalUnit, ("auto"));
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
  SO_NODE_ADD_FIELD(lodCamera, (nullptr));
  SO_NODE_ADD_FIELD(center, (0, 0, 0));
  SO_NODE_ADD_FIELD(origin, (0, 0, 0));
  m_redraw.setFunction([](void* node, SoSensor*) { static_cast<SoTeSeamlessPatches*>(node)->touch(); });
  m_redraw.setData(this);
}

SoTeSeamlessPatches::~SoTeSeamlessPatches() = default;

void SoTeSeamlessPatches::setHeights(std::shared_ptr<const TeHeightMap> map) {
  m_given = std::move(map);
  m_isLoaded = false;
  m_isCurrent = false;
  touch();
}

const std::string& SoTeSeamlessPatches::getError() {
  update();
  return m_error;
}

bool SoTeSeamlessPatches::decidesHeights(const SoField* field) const {
  const SoField* const fields[] = {&resolution, &minPatchResolution, &levels, &heightSource,
                                   &heightFile, &verticalUnit,       &heights};
  return std::find(std::begin(fields), std::end(fields), field) != std::end(fields);
}

void SoTeSeamlessPatches::notify(SoNotList* list) {
  const SoField* field = list->getLastField();
  if (field && field->getContainer() == this) {
    m_isCurrent = false;
    m_isLoaded = m_isLoaded && !decidesHeights(field);
  }
  inherited::notify(list);
}

SbBool SoTeSeamlessPatches::readInstance(SoInput* input, unsigned short flags) {
  if (const char* file = input->getCurFileName())
    m_folder = std::filesystem::path(file).parent_path().string();
  m_isLoaded = false;
  m_isCurrent = false;
  return inherited::readInstance(input, flags);
}

void SoTeSeamlessPatches::copyContents(const SoFieldContainer* from, SbBool copyConnections) {
  inherited::copyContents(from, copyConnections);
  const auto* other = static_cast<const SoTeSeamlessPatches*>(from);
  m_folder = other->m_folder;
  m_given = other->m_given;
  m_isLoaded = false;
  m_isCurrent = false;
}

bool SoTeSeamlessPatches::update() {
  if (m_isCurrent)
    return m_error.empty();
  m_isCurrent = true;
  const std::string before = std::move(m_error);
  m_error.clear();
  m_isReported = false;
  if (TeStatus status = build(); !status) {
    m_error = status.error().message;
    if (m_error != before && !m_isReported)
      SoDebugError::postWarning("TeSeamlessPatches", "%s", m_error.c_str());
  }
  return m_error.empty();
}

TeStatus SoTeSeamlessPatches::build() {
  if (!m_isLoaded) {
    m_isLoaded = true;
    m_viewers.clear();
    m_content = load();
  }
  if (!m_content)
    return m_content.error();
  TeSeamlessSceneReader reader(*this, m_folder, m_pictures);
  TeResult<TeSeamlessScene> scene = reader.read(*m_content);
  m_isReported = reader.isReported();
  if (!scene)
    return scene.error();
  m_viewers.setScene(std::move(*scene));
  return {};
}

TeResult<TeSeamlessContent> SoTeSeamlessPatches::load() {
  const TeSeamlessContent::Sizes sizes{resolution.getValue(), minPatchResolution.getValue(),
                                       levels.getValue()};
  switch (heightSource.getValue()) {
  case FLAT:
    return TeSeamlessContent::flat(sizes);
  case HEIGHTMAP:
    if (m_given)
      return TeSeamlessContent::ofMap(m_given, sizes);
    if (heightFile.getValue().getLength() == 0)
      return TeError{"heightFile: no file is named"};
    return TeSeamlessContent::ofFile(teBesideScene(heightFile.getValue().getString(), m_folder),
                                     verticalUnit.getValue().getString(), sizes);
  case CLIPMAPS:
    return TeSeamlessContent::ofClipmap(heights.getValue(), sizes, m_isReported);
  }
  return TeError{"heightSource " + std::to_string(heightSource.getValue()) + " is none of the three"};
}

void SoTeSeamlessPatches::GLRender(SoGLRenderAction* action) {
  if (!update())
    return;
  SoState* state = action->getState();
  // No display list may hold what this view sees.
  SoCacheElement::invalidate(state);
  SoGLCacheContextElement::shouldAutoCache(state, SoGLCacheContextElement::DONT_AUTO_CACHE);
  if (!shouldGLRender(action))
    return;
  SoMaterialBundle materials(action);
  materials.sendFirst();
  // Its triangles are counter-clockwise, whatever hints a neighbour needs.
  SoGLLazyElement::sendVertexOrdering(state, SoLazyElement::CCW);
  const TeStatus status = m_viewers.draw(action);
  const std::string message = status ? "" : status.error().message;
  if (message != m_drawingError && !message.empty())
    SoDebugError::postWarning("TeSeamlessPatches", "%s", message.c_str());
  m_drawingError = message;
  if (m_viewers.isWaiting())
    m_redraw.schedule();
}

void SoTeSeamlessPatches::computeBBox(SoAction*, SbBox3f& box, SbVec3f& center) {
  if (!update())
    return;
  box = m_viewers.box();
  center = box.getCenter();
}

void SoTeSeamlessPatches::getPrimitiveCount(SoGetPrimitiveCountAction* action) {
  if (!update() || !shouldPrimitiveCount(action))
    return;
  const std::int64_t most = std::numeric_limits<int>::max() - std::int64_t(action->getTriangleCount());
  action->addNumTriangles(int(std::min(m_viewers.triangles(action), most)));
}

void SoTeSeamlessPatches::generatePrimitives(SoAction* action) {
  if (!update())
    return;
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

void SoTeSeamlessPatches::rayPick(SoRayPickAction* action) {
  if (!update() || !shouldRayPick(action))
    return;
  action->setObjectSpace();
  if (!action->intersect(m_viewers.box(), TRUE))
    return;
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
  hit.position = toGlm(origin.getValue()) + glm::dvec3(point[0], point[1], point[2]);
  hit.normal = {normal[0], normal[1], normal[2]};
  hit.key = {patch.x, patch.y, m_content->terrain->layout.depth() - 1 - patch.level};
  picked->setDetail(new SoTeTerrainDetail(hit), this);
}
