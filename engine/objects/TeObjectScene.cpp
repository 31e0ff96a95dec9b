#include "engine/objects/TeObjectScene.h"

#include "engine/objects/TeObject.h"

#include <Inventor/nodes/SoSeparator.h>

#include <glm/common.hpp>

namespace {

constexpr double kFarthest = 1e30; ///< metres, so that floats stay finite

} // namespace

TeObjectScene::TeObjectScene() : m_root(new SoGroup) { m_root->setName("TerraneObjects"); }

void TeObjectScene::add(TeObject& object, const glm::dvec3& origin) {
  const TeNodePtr<SoNode> drawn(object.drawModel());
  if (!drawn)
    return;
  Model model{TeNodePtr<SoSwitch>(new SoSwitch), TeNodePtr<SoTransform>(new SoTransform)};
  auto* separator = new SoSeparator;
  separator->addChild(model.transform.get());
  separator->addChild(drawn.get());
  model.shown->whichChild = SO_SWITCH_ALL;
  model.shown->addChild(separator);
  m_root->addChild(model.shown.get());
  m_models.emplace(&object, std::move(model));
  place(object, origin);
}

void TeObjectScene::remove(const TeObject& object) {
  const auto found = m_models.find(&object);
  if (found == m_models.end())
    return;
  m_root->removeChild(found->second.shown.get());
  m_models.erase(found);
  if (m_hidden == &object)
    m_hidden = nullptr;
}

bool TeObjectScene::place(const TeObject& object, const glm::dvec3& origin) {
  const auto found = m_models.find(&object);
  if (found == m_models.end())
    return false;
  SoTransform& transform = *found->second.transform;
  const glm::vec3 place(glm::clamp(object.position() - origin, -kFarthest, kFarthest));
  const SbVec3f translation(place.x, place.y, place.z);
  const glm::quat turn(object.orientation());
  const SbRotation rotation(turn.x, turn.y, turn.z, turn.w);
  const bool moved = transform.translation.getValue() != translation;
  const bool turned = transform.rotation.getValue() != rotation;
  if (moved)
    transform.translation = translation;
  if (turned)
    transform.rotation = rotation;
  return moved || turned;
}

void TeObjectScene::placeAll(const glm::dvec3& origin) {
  for (const auto& [object, model] : m_models)
    place(*object, origin);
}

void TeObjectScene::setHidden(const TeObject* object) {
  if (object == m_hidden)
    return;
  if (const auto found = m_models.find(m_hidden); found != m_models.end())
    found->second.shown->whichChild = SO_SWITCH_ALL;
  m_hidden = object;
  if (const auto found = m_models.find(m_hidden); found != m_models.end())
    found->second.shown->whichChild = SO_SWITCH_NONE;
}
