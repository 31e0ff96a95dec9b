#include "nodes/terrain/SoTeTerrainMesh.h"

#include "nodes/terrain/SoTeTerrainDetail.h"
#include "nodes/terrain/TeLevelErrors.h"
#include "nodes/terrain/TeMeshVertices.h"

#include <Inventor/SbLine.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/bundles/SoMaterialBundle.h>
#include <Inventor/elements/SoCacheElement.h>
#include <Inventor/elements/SoCullElement.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoGLLazyElement.h>
#include <Inventor/elements/SoOverrideElement.h>
#include <Inventor/misc/SoState.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cassert>
#include <limits>

SO_NODE_SOURCE(SoTeTerrainMesh)

namespace {

SbVec3f toCoin(const glm::vec3& vector) { return {vector.x, vector.y, vector.z}; }

} // namespace

void SoTeTerrainMesh::initClass() {
  if (classTypeId == SoType::badType())
    PRIVATE_COMMON_INIT_CODE(SoTeTerrainMesh, "TeTerrainMesh", &SoTeTerrainMesh::createInstance, SoShape);
}

SoTeTerrainMesh::SoTeTerrainMesh() { SO_NODE_CONSTRUCTOR(SoTeTerrainMesh); }

SoTeTerrainMesh::~SoTeTerrainMesh() {
  if (m_drawing)
    m_drawing->forget(this);
}

void SoTeTerrainMesh::setMesh(TePatchMeshPtr mesh, std::vector<std::uint32_t> colours,
                              std::shared_ptr<TeMeshDrawing> drawing) {
  if (m_drawing)
    m_drawing->forget(this);
  m_mesh = drawing ? std::move(mesh) : nullptr;
  m_drawing = std::move(drawing);
  m_colours = std::move(colours);
  if (!m_mesh || m_colours.size() != m_mesh->positions.size())
    m_colours.clear();
  m_triangles = m_mesh ? teTriangleCount(*m_mesh) : 0;
  m_errors.clear();
  m_levels = nullptr;
  m_level = 0;
  if (!isEmpty())
    findBox();
  touch();
}

void SoTeTerrainMesh::copyContents(const SoFieldContainer* from, SbBool copyConnections) {
  inherited::copyContents(from, copyConnections);
  const auto* other = static_cast<const SoTeTerrainMesh*>(from);
  setMesh(other->m_mesh, other->m_colours, other->m_drawing);
  m_errors = other->m_errors;
  m_levels = other->m_levels;
}

void SoTeTerrainMesh::setLevelErrors(std::vector<float> errors) {
  m_levels = m_drawing->gridLevels(m_mesh->columns, m_mesh->rows);
  assert(int(errors.size()) == m_levels->count() + 1);
  m_errors = std::move(errors);
}

bool SoTeTerrainMesh::findErrors() {
  if (m_errors.empty() && !teIsWholeGrid(*m_mesh))
    m_errors = {0};
  if (m_errors.empty() && m_drawing->mayFindErrors(m_mesh->positions.size())) {
    TeLevelErrors errors(*m_mesh, m_drawing->gridLevels(m_mesh->columns, m_mesh->rows));
    TeAllowance all = TeAllowance::unlimited();
    errors.step(all);
    setLevelErrors(errors.take());
  }
  return m_errors.size() > 1;
}

int SoTeTerrainMesh::chooseLevel(SoState* state) {
  const double wanted = m_drawing->pixelError();
  TeMeshEye& eye = m_drawing->m_eye;
  if (!(wanted > 0) || !findErrors() || !eye.update(state))
    return 0;
  const double distance = eye.distance(box());
  const auto pixels = [&](int level) { return eye.pixels(double(m_errors[std::size_t(level)]), distance); };
  int coarsest = m_levels->count();
  while (pixels(coarsest) > wanted)
    --coarsest;
  int level = coarsest;
  while (level > m_level && kSwitch * pixels(level) > wanted)
    --level;
  double& bound = m_drawing->m_frame.errorBound;
  bound = std::max(bound, pixels(level));
  return level;
}

void SoTeTerrainMesh::findBox() {
  // Vertices without a triangle have no height.
  m_lowest = glm::vec3(std::numeric_limits<float>::max());
  m_highest = -m_lowest;
  for (const std::int32_t vertex : m_mesh->strips) {
    if (vertex < 0)
      continue;
    m_lowest = glm::min(m_lowest, m_mesh->positions[std::size_t(vertex)]);
    m_highest = glm::max(m_highest, m_mesh->positions[std::size_t(vertex)]);
  }
}

std::size_t SoTeTerrainMesh::uploadBytes() const {
  return isEmpty() ? 0 : TeMeshBuffers::addedBytes(*m_mesh);
}

SbVec3f SoTeTerrainMesh::position(std::size_t vertex) const {
  return toCoin(teVertexPosition(*m_mesh, m_mesh->positions[vertex], m_drawing->anchor()));
}

SbBox3f SoTeTerrainMesh::box() const {
  return {toCoin(teVertexPosition(*m_mesh, m_lowest, m_drawing->anchor())),
          toCoin(teVertexPosition(*m_mesh, m_highest, m_drawing->anchor()))};
}

bool SoTeTerrainMesh::setColours(SoState* state) {
  if (m_colours.empty() || SoOverrideElement::getDiffuseColorOverride(state))
    return false;
  SoLazyElement::setPacked(state, this, std::int32_t(m_colours.size()), m_colours.data(), FALSE);
  return true;
}

void SoTeTerrainMesh::GLRender(SoGLRenderAction* action) {
  if (isEmpty())
    return;
  SoState* state = action->getState();
  // No display list may hold what was culled, or buffers that go with the anchor.
  SoCacheElement::invalidate(state);
  SoGLCacheContextElement::shouldAutoCache(state, SoGLCacheContextElement::DONT_AUTO_CACHE);
  TeMeshBuffers& buffers = m_drawing->buffers(std::uint32_t(SoGLCacheContextElement::get(state)));
  // Also for what is not in view: turning the camera must not be a burst of uploads.
  const TeMeshBuffers::Mesh* mesh = m_drawing->prepare(buffers, this, *m_mesh, m_colours);
  if (!mesh)
    return;
  if (SoCullElement::cullTest(state, box())) {
    m_drawing->m_frame.meshesCulled++;
    return;
  }

  state->push();
  const bool hasColours = setColours(state);
  if (shouldGLRender(action)) {
    SoMaterialBundle materials(action);
    materials.sendFirst();
    m_level = chooseLevel(state);
    if (m_level > 0)
      m_drawing->prepareLevel(buffers, *mesh, *m_levels, m_level);
    buffers.draw(*mesh, hasColours, m_level);
    if (hasColours)
      SoGLLazyElement::getInstance(state)->reset(state, SoLazyElement::DIFFUSE_MASK);
    m_drawing->m_frame.meshesDrawn++;
    m_drawing->m_frame.triangles += m_level > 0 ? m_levels->triangles(m_level) : m_triangles;
  }
  state->pop();
}

void SoTeTerrainMesh::computeBBox(SoAction* action, SbBox3f& box, SbVec3f& center) {
  // Moves with the anchor, of which caches know nothing.
  SoCacheElement::invalidate(action->getState());
  if (isEmpty())
    return;
  box = this->box();
  center = box.getCenter();
}

void SoTeTerrainMesh::getPrimitiveCount(SoGetPrimitiveCountAction* action) {
  if (shouldPrimitiveCount(action))
    action->addNumTriangles(int(m_triangles));
}

void SoTeTerrainMesh::generatePrimitives(SoAction* action) {
  if (isEmpty())
    return;
  SoState* state = action->getState();
  state->push();
  const bool hasColours = setColours(state);
  SoPrimitiveVertex primitive;
  const auto give = [&](std::size_t vertex) {
    primitive.setPoint(position(vertex));
    primitive.setNormal(toCoin(m_mesh->normals[vertex]));
    if (hasColours)
      primitive.setMaterialIndex(int(vertex));
    shapeVertex(&primitive);
  };
  beginShape(action, TRIANGLES);
  teForEachTriangle(*m_mesh, [&](std::size_t a, std::size_t b, std::size_t c) {
    give(a);
    give(b);
    give(c);
  });
  endShape();
  state->pop();
}

void SoTeTerrainMesh::rayPick(SoRayPickAction* action) {
  if (isEmpty() || !shouldRayPick(action))
    return;
  action->setObjectSpace();
  if (!action->intersect(box(), TRUE))
    return;
  teForEachTriangle(*m_mesh, [&](std::size_t a, std::size_t b, std::size_t c) {
    SbVec3f point;
    SbVec3f barycentric;
    SbBool isFront;
    const SbVec3f corners[] = {position(a), position(b), position(c)};
    if (!action->intersect(corners[0], corners[1], corners[2], point, barycentric, isFront) ||
        !action->isBetweenPlanes(point))
      return;
    SoPickedPoint* picked = action->addIntersection(point);
    if (!picked)
      return;
    SbVec3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    normal.normalize();
    picked->setObjectNormal(normal);
    TeRayHit hit;
    hit.distance = (point - action->getLine().getPosition()).length();
    hit.position = {m_drawing->anchor().x + point[0], m_drawing->anchor().y + point[1], point[2]};
    hit.normal = {normal[0], normal[1], normal[2]};
    hit.key = m_mesh->key;
    picked->setDetail(new SoTeTerrainDetail(hit), this);
  });
}
