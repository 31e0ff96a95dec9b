#pragma once

#include "engine/TeEngine.h"
#include "nodes/TeNodes.h"

#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <cassert>
#include <memory>
#include <string>

/// An object that goes where it is told, or where its velocity leads.
class TeProbe : public TeObject {
public:
  explicit TeProbe(const std::string& name = "probe") : TeObject(name) {}
};

/// An engine in a scene of its own, ready to be initialised.
struct TeEndlessWorld {
  explicit TeEndlessWorld(int samples = 33, float area = 64.0f)
      : engine(SbVec2s(short(samples), short(samples)), SbVec2f(area, area)) {
    TeNodes::init();
    scene = TeNodePtr<SoSeparator>(new SoSeparator);
    auto* camera = new SoPerspectiveCamera;
    scene->addChild(camera);
    engine.setSceneRoot(scene.get());
    engine.setSceneCamera(camera);
    object = engine.addObject(std::make_unique<TeProbe>());
    const TeStatus placed = object->setPosition({0, 0, 50});
    assert(placed);
    (void)placed;
    engine.setActiveObject(object);
  }
  double side() const { return engine.getDatabase()->lattice().patchSide(); }
  const TeStatistics& statistics() const { return engine.getStatistics(); }

  TeNodePtr<SoSeparator> scene; ///< goes last
  TeEngine engine;
  TeObject* object = nullptr;
};
