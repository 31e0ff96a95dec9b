#pragma once

#include <Inventor/sensors/SoNodeSensor.h>

/// Counts the changes of a scene, by any of its nodes.
class SceneChanges {
public:
  explicit SceneChanges(SoNode* root)
      : m_sensor([](void* self, SoSensor*) { ++static_cast<SceneChanges*>(self)->count; }, this) {
    m_sensor.setPriority(0);
    m_sensor.attach(root);
  }
  SceneChanges(const SceneChanges&) = delete;
  SceneChanges& operator=(const SceneChanges&) = delete;

  int count = 0;

private:
  SoNodeSensor m_sensor;
};
