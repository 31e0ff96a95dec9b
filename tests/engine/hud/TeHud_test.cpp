#include "engine/hud/TeHud.h"

#include <Inventor/SoDB.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/sensors/SoNodeSensor.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace {

using testing::ElementsAre;

class TeHudTest : public testing::Test {
protected:
  void SetUp() override {
    SoDB::init();
    m_root = new SoSeparator;
    m_camera = new SoOrthographicCamera;
    m_hud = std::make_unique<TeHud>();
    ASSERT_TRUE(m_hud->attach(m_root.get(), m_camera.get()));
    m_hud->setViewport(800, 600);
    m_sensor.setFunction([](void* data, SoSensor*) { ++*static_cast<int*>(data); });
    m_sensor.setData(&m_notified);
    m_sensor.setPriority(0);
    m_sensor.attach(m_root.get());
  }
  /// Whether something was notified or counted since the last call; both or none.
  bool changed() {
    const bool counted = m_hud->changes() != m_changes;
    const bool notified = m_notified > 0;
    m_changes = m_hud->changes();
    m_notified = 0;
    EXPECT_EQ(counted, notified);
    return notified;
  }

  TeNodePtr<SoSeparator> m_root;
  TeNodePtr<SoOrthographicCamera> m_camera;
  std::unique_ptr<TeHud> m_hud;
  SoNodeSensor m_sensor;
  int m_notified = 0;
  int m_changes = 0;
};

TEST_F(TeHudTest, NodesChangeOnlyWhenTextDoes) {
  m_changes = m_hud->changes();
  m_hud->setLines({"speed 1", "height 2"});
  EXPECT_TRUE(changed());
  m_hud->setLines({"speed 1", "height 2"});
  EXPECT_FALSE(changed());
  m_hud->setLines({"speed 1", "height 3"});
  EXPECT_TRUE(changed());
  m_hud->setViewport(800, 600);
  m_hud->setVisible(true);
  m_hud->showHelp(false);
  EXPECT_FALSE(changed());
  m_hud->setViewport(400, 300);
  EXPECT_TRUE(changed());
}

TEST_F(TeHudTest, WhatIsHiddenChangesWithoutARedraw) {
  m_hud->setLines({"speed 1"});
  m_hud->setVisible(false);
  m_changes = m_hud->changes();
  m_notified = 0;
  for (int i = 0; i < 10; ++i)
    m_hud->setLines({"speed " + std::to_string(i)});
  EXPECT_FALSE(changed());
  m_hud->showHelp(true);
  EXPECT_FALSE(changed());
  m_hud->setVisible(true);
  EXPECT_TRUE(changed());
  EXPECT_THAT(m_hud->lines(), ElementsAre("speed 9"));
}

TEST_F(TeHudTest, HelpTakesThePlaceOfTheLines) {
  m_hud->setLines({"speed 1"});
  m_hud->setHelp({"F1  help"});
  m_changes = m_hud->changes();
  m_notified = 0;
  m_hud->showHelp(true);
  EXPECT_TRUE(changed());
  m_hud->setLines({"speed 2"});
  EXPECT_FALSE(changed()) << "they are not seen now";
  m_hud->showHelp(false);
  EXPECT_TRUE(changed());
  m_hud->setHelp({"F1  other help"});
  EXPECT_FALSE(changed());
}

TEST_F(TeHudTest, ItsCameraShowsPixels) {
  for (const int width : {800, 1, 123}) {
    m_hud->setViewport(width, 60);
    SbVec3f corner;
    m_camera->getViewVolume(float(width) / 60).projectToScreen(SbVec3f(0, 0, 0), corner);
    EXPECT_NEAR(corner[0], 0, 1e-5);
    EXPECT_NEAR(corner[1], 0, 1e-5);
    m_camera->getViewVolume(float(width) / 60).projectToScreen(SbVec3f(float(width), 60, 0), corner);
    EXPECT_NEAR(corner[0], 1, 1e-5);
    EXPECT_NEAR(corner[1], 1, 1e-5);
  }
}

TEST_F(TeHudTest, ShowsWhatItCanOfAnyText) {
  m_hud->setLines({"90.0° wide", "ü€\t\x80\xff", std::string(500, 'x'), std::string("a\0b", 3)});
  EXPECT_THAT(m_hud->lines(),
              ElementsAre("90.0° wide", "?????", std::string(TeHud::kMaxColumns, 'x'), "a?b"));
  m_hud->setLines(std::vector<std::string>(1000, "line"));
  EXPECT_EQ(m_hud->lines().size(), std::size_t(TeHud::kMaxLines));
}

TEST_F(TeHudTest, NeedsARootAndACameraOnce) {
  TeHud hud;
  EXPECT_EQ(hud.attach(nullptr, m_camera.get()).error().message, "TeHud: no root given");
  EXPECT_EQ(hud.attach(m_root.get(), nullptr).error().message, "TeHud: no camera given");
  EXPECT_FALSE(m_hud->attach(m_root.get(), m_camera.get()));
  EXPECT_EQ(m_root->findChild(m_camera.get()), 0) << "the camera comes first";
}

TEST_F(TeHudTest, TextMayBeSetBeforeItHasARoot) {
  TeHud hud;
  hud.setViewport(100, 100);
  hud.setHelp({"F1  help"});
  hud.showHelp(true);
  hud.setLines({"speed"});
  const TeNodePtr<SoSeparator> root(new SoSeparator);
  const TeNodePtr<SoOrthographicCamera> camera(new SoOrthographicCamera);
  EXPECT_TRUE(hud.attach(root.get(), camera.get()));
  EXPECT_EQ(camera->height.getValue(), 100);
}

} // namespace
