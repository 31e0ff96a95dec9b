#pragma once

#include "nodes/TeNodePtr.h"

#include <Inventor/nodes/SoGroup.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>

#include <glm/vec3.hpp>

#include <unordered_map>

class TeObject;

/// The draw models of objects, placed in the scene relative to a point of the world near the eye.
class TeObjectScene {
public:
  TeObjectScene();

  SoGroup* root() const { return m_root.get(); }
  /// An object without a draw model takes nothing.
  void add(TeObject& object, const glm::dvec3& origin);
  void remove(const TeObject& object);
  /// Writes the object's place and orientation; what has not changed is not written.
  /// True if it is drawn elsewhere than before.
  bool place(const TeObject& object, const glm::dvec3& origin);
  void placeAll(const glm::dvec3& origin);
  /// The one object that is not drawn, for the camera is inside it; null = all are.
  void setHidden(const TeObject* object);

private:
  struct Model {
    TeNodePtr<SoSwitch> shown;
    TeNodePtr<SoTransform> transform;
  };

  TeNodePtr<SoGroup> m_root;
  std::unordered_map<const TeObject*, Model> m_models;
  const TeObject* m_hidden = nullptr;
};
