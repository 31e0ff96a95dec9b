#include "nodes/lod/SoTeLodShape.h"

#include "nodes/TeCoinVectors.h"
#include "nodes/TeSceneFile.h"

#include <Inventor/SoInput.h>
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

SO_NODE_ABSTRACT_SOURCE(SoTeLodShape)

void SoTeLodShape::initClass() {
  if (classTypeId == SoType::badType())
    PRIVATE_COMMON_INIT_CODE(SoTeLodShape, "TeLodShape", nullptr, SoShape);
}

SoTeLodShape::SoTeLodShape(float usualPixelError) {
  SO_NODE_CONSTRUCTOR(SoTeLodShape);
  SO_NODE_ADD_FIELD(heightFile, (""));
  SO_NODE_ADD_FIELD(verticalUnit, ("auto"));
  SO_NODE_ADD_FIELD(size, (256, 256, 10));
  SO_NODE_ADD_FIELD(pixelError, (usualPixelError));
  SO_NODE_ADD_FIELD(geomorph, (FALSE));
  SO_NODE_ADD_FIELD(wireframe, (FALSE));
  SO_NODE_ADD_FIELD(lodCamera, (nullptr));
  SO_NODE_ADD_FIELD(center, (0, 0, 0));
  SO_NODE_ADD_FIELD(origin, (0, 0, 0));
  m_redraw.setFunction([](void* node, SoSensor*) { static_cast<SoTeLodShape*>(node)->touch(); });
  m_redraw.setData(this);
}

SoTeLodShape::~SoTeLodShape() = default;

void SoTeLodShape::setHeights(std::shared_ptr<const TeHeightMap> map) {
  m_given = std::move(map);
  forgetHeights();
  touch();
}

const std::string& SoTeLodShape::getError() {
  update();
  return m_error;
}

void SoTeLodShape::forgetHeights() {
  m_isLoaded = false;
  m_isCurrent = false;
}

bool SoTeLodShape::decidesHeights(const SoField* field) const {
  return field == &heightFile || field == &verticalUnit;
}

void SoTeLodShape::notify(SoNotList* list) {
  const SoField* field = list->getLastField();
  if (field && field->getContainer() == this) {
    m_isCurrent = false;
    m_isLoaded = m_isLoaded && !decidesHeights(field);
  }
  inherited::notify(list);
}

SbBool SoTeLodShape::readInstance(SoInput* input, unsigned short flags) {
  if (const char* file = input->getCurFileName())
    m_folder = std::filesystem::path(file).parent_path().string();
  forgetHeights();
  return inherited::readInstance(input, flags);
}

void SoTeLodShape::copyContents(const SoFieldContainer* from, SbBool copyConnections) {
  inherited::copyContents(from, copyConnections);
  const auto* other = static_cast<const SoTeLodShape*>(from);
  m_folder = other->m_folder;
  m_given = other->m_given;
  forgetHeights();
}

bool SoTeLodShape::update() {
  if (m_isCurrent)
    return m_error.empty();
  m_isCurrent = true;
  const std::string before = std::move(m_error);
  m_error.clear();
  bool isReported = false;
  if (!m_isLoaded) {
    m_isLoaded = true;
    m_loaded = load(isReported);
  }
  if (const TeStatus status = m_loaded ? build(isReported) : m_loaded; !status) {
    m_error = status.error().message;
    if (m_error != before && !isReported)
      SoDebugError::postWarning(getTypeId().getName().getString(), "%s", m_error.c_str());
  }
  return m_error.empty();
}

TeResult<std::string> SoTeLodShape::heightPath() const {
  if (heightFile.getValue().getLength() == 0)
    return TeError{"heightFile: no file is named"};
  return teBesideScene(heightFile.getValue().getString(), m_folder);
}

TeResult<TeNodePtr<SoCamera>> SoTeLodShape::readLodCamera() const {
  SoNode* camera = lodCamera.getValue();
  if (camera && !camera->isOfType(SoCamera::getClassTypeId()))
    return TeError{std::string("lodCamera: a ") + camera->getTypeId().getName().getString() +
                   " is no camera"};
  return TeNodePtr<SoCamera>(static_cast<SoCamera*>(camera));
}

glm::dvec3 SoTeLodShape::middle() const { return teToGlm(center.getValue()) - teToGlm(origin.getValue()); }

void SoTeLodShape::GLRender(SoGLRenderAction* action) {
  if (!update())
    return;
  SoState* state = action->getState();
  // No display list may hold what this view sees.
  SoCacheElement::invalidate(state);
  SoGLCacheContextElement::shouldAutoCache(state, SoGLCacheContextElement::DONT_AUTO_CACHE);
  if (!shouldGLRender(action))
    return;
  const TeStatus status = draw(action);
  const std::string message = status ? "" : status.error().message;
  if (message != m_drawingError && !message.empty())
    SoDebugError::postWarning(getTypeId().getName().getString(), "%s", message.c_str());
  m_drawingError = message;
  if (wantsFrame())
    m_redraw.schedule();
}

void SoTeLodShape::sendMaterial(SoGLRenderAction* action) {
  SoMaterialBundle(action).sendFirst();
  SoGLLazyElement::sendVertexOrdering(action->getState(), SoLazyElement::CCW);
}

void SoTeLodShape::computeBBox(SoAction*, SbBox3f& box, SbVec3f& center) {
  if (!update())
    return;
  box = bounds();
  center = box.getCenter();
}

void SoTeLodShape::getPrimitiveCount(SoGetPrimitiveCountAction* action) {
  if (!update() || !shouldPrimitiveCount(action))
    return;
  const std::int64_t most = std::numeric_limits<int>::max() - std::int64_t(action->getTriangleCount());
  action->addNumTriangles(int(std::min(triangles(action), most)));
}

void SoTeLodShape::generatePrimitives(SoAction* action) {
  if (update())
    emitTriangles(action);
}

void SoTeLodShape::rayPick(SoRayPickAction* action) {
  if (!update() || !shouldRayPick(action))
    return;
  action->setObjectSpace();
  if (action->intersect(bounds(), TRUE))
    pickTriangles(action);
}
