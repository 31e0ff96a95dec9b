// The example of docs/objects-and-cameras.md.

#include "engine/TeEngine.h"
#include "engine/objects/TeObject.h"
#include "engine/objects/TeObjects.h"
#include "generators/base/TeHash.h"
#include "patchdb/TePatchDatabase.h"

#include <Inventor/SoDB.h>
#include <Inventor/nodes/SoSphere.h>

#include <gtest/gtest.h>

namespace {

//! [balloon]
/// A balloon that rises and sinks by keys and drifts with the wind.
class Balloon final : public TeObject {
public:
  explicit Balloon(const glm::dvec2& wind) : TeObject("balloon"), m_wind(wind) {}

  void update(const TeUpdate& update) override {
    move({m_wind, 2.0 * m_burner});
    place(position() + velocity() * update.dt);
    const auto ground = update.terrain.heightAt({position().x, position().y});
    if (ground && position().z < *ground) {
      place({position().x, position().y, *ground});
      move(glm::dvec3(0));
    }
  }
  bool handleEvent(const TeKeyEvent& event) override {
    if (event.key != SoKeyboardEvent::UP_ARROW && event.key != SoKeyboardEvent::DOWN_ARROW)
      return false;
    m_burner = !event.down ? 0 : event.key == SoKeyboardEvent::UP_ARROW ? 1 : -1;
    wake();
    return true;
  }
  SoNode* drawModel() override { return new SoSphere; }
  std::vector<std::string> helpLines() const override { return {"Up, Down  rise, sink"}; }
  std::uint64_t stateHash() const override {
    return teHashCombine(TeObject::stateHash(), std::uint64_t(m_burner + 1));
  }

private:
  glm::dvec2 m_wind;
  int m_burner = 0;
};
//! [balloon]

TEST(ObjectsAndCameras, ABalloonRisesDriftsAndLands) {
  SoDB::init();
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64.0f, 64.0f));
  for (int x = 0; x < 3; ++x) {
    TePatch* patch = engine.getPatch(TePatchKey{x, 0, 0});
    ASSERT_TRUE(patch->prepareBuildMaps() && patch->buildHMapFromBuildMaps());
  }
  TeObjects objects;
  TeObject* balloon = *objects.add(std::make_unique<Balloon>(glm::dvec2(2, 0)));
  ASSERT_TRUE(balloon->setPosition({0, 0, 100}));
  TeKeyEvent key;
  key.key = SoKeyboardEvent::UP_ARROW;
  key.down = true;
  EXPECT_TRUE(balloon->handleEvent(key));
  ASSERT_TRUE(objects.update(1, *engine.getDatabase()));
  EXPECT_NEAR(balloon->position().z, 102, 1e-9);
  EXPECT_NEAR(balloon->position().x, 2, 1e-9);
  key.key = SoKeyboardEvent::DOWN_ARROW;
  EXPECT_TRUE(balloon->handleEvent(key));
  ASSERT_TRUE(balloon->setPosition({10, 0, *engine.getDatabase()->heightAt({10, 0})}));
  ASSERT_TRUE(objects.update(0.1, *engine.getDatabase()));
  EXPECT_EQ(balloon->velocity(), glm::dvec3(0)) << "landed";
  EXPECT_FALSE(balloon->awake());
}

} // namespace
