#include "engine/hud/TeHud.h"

#include "nodes/TeNodePtr.h"
#include "render/TeRenderTest.h"

#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <algorithm>
#include <memory>
#include <string>

namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 320;

/// A scene with a HUD after it in one picture.
class TeHudRenderTest : public TeRenderTest {
protected:
  void SetUp() override {
    TeRenderTest::SetUp();
    m_root = new SoSeparator;
    m_scene = new SoSeparator;
    m_root->addChild(m_scene.get());
    m_hudRoot = new SoSeparator;
    m_root->addChild(m_hudRoot.get());
    auto* camera = new SoPerspectiveCamera;
    camera->position.setValue(0, 0, 6);
    m_scene->addChild(camera);
    m_scene->addChild(new SoDirectionalLight);
    auto* cube = new SoSeparator; // fills the middle, in front of where a HUD at its own depth would be
    auto* material = new SoMaterial;
    material->diffuseColor.setValue(0.2f, 0.6f, 0.3f);
    cube->addChild(material);
    cube->addChild(new SoCube);
    m_scene->addChild(cube);

    m_hud = std::make_unique<TeHud>();
    const TeStatus attached = m_hud->attach(m_hudRoot.get(), new SoOrthographicCamera);
    ASSERT_TRUE(attached);
    m_hud->setViewport(kWidth, kHeight);
    m_hud->setLines(
        {"mine", "position  -12345.6  98765.4  123.4 m", "speed     60.0 m/s  216 km/h", "heading   270.0°"});
    m_hud->setHelp({"Up/Down, R/F    faster, slower", "Left/Right, A/D turn", "H               these lines"});
  }
  TePicture drawAll(const std::string& name, const SbColor& background = SbColor(0.5f, 0.7f, 0.9f)) {
    return draw(m_root.get(), kWidth, kHeight, name, background);
  }

  TeNodePtr<SoSeparator> m_root;
  TeNodePtr<SoSeparator> m_scene;
  TeNodePtr<SoSeparator> m_hudRoot;
  std::unique_ptr<TeHud> m_hud;
};

/// The smallest rectangle of pixels that differ: left, right, bottom, top; right < left if none do.
struct Area {
  int left = kWidth;
  int right = -1;
  int bottom = kHeight;
  int top = -1;
};

Area difference(const TePicture& a, const TePicture& b) {
  Area area;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (a.pixel(x, y) != b.pixel(x, y)) {
        area.left = std::min(area.left, x);
        area.right = std::max(area.right, x);
        area.bottom = std::min(area.bottom, y);
        area.top = std::max(area.top, y);
      }
  return area;
}

int brightness(const TePicture::Pixel& pixel) { return (pixel[0] + pixel[1] + pixel[2]) / 3; }

} // namespace

TEST_F(TeHudRenderTest, CoversItsPanelsAndNothingElse) {
  m_hud->setVisible(false);
  const TePicture without = drawAll("hud-hidden");
  m_hud->setVisible(true);
  const TePicture with = drawAll("hud");
  ASSERT_FALSE(without.rgba.empty() || with.rgba.empty());
  // 10 pixels from the corner; 36 columns and 4 lines.
  const Area lines = difference(without, with);
  EXPECT_EQ(lines.left, 10);
  EXPECT_EQ(lines.top, kHeight - 11);
  EXPECT_EQ(lines.right, 10 + 36 * 8 + 16 - 1);
  EXPECT_EQ(lines.bottom, kHeight - 10 - 4 * 17 - 16);
  m_hud->showHelp(true);
  const Area help = difference(without, drawAll("hud-help"));
  EXPECT_NEAR(help.left + help.right, kWidth, 2) << "in the middle";
  EXPECT_NEAR(help.bottom + help.top, kHeight, 2);
  EXPECT_EQ(help.right - help.left, 30 * 8 + 16 - 1);
}

TEST_F(TeHudRenderTest, AHiddenHudLeavesTheSceneAsItIs) {
  m_hud->setVisible(false);
  const TePicture hidden = drawAll("hud-hidden");
  m_root->removeChild(m_hudRoot.get());
  const TePicture alone = drawAll("hud-none");
  ASSERT_FALSE(hidden.rgba.empty());
  EXPECT_EQ(hidden.rgba, alone.rgba);
}

TEST_F(TeHudRenderTest, CanBeReadOverBrightAndDark) {
  m_root->removeChild(m_scene.get());
  for (const float shade : {0.0f, 0.5f, 1.0f}) {
    const TePicture picture =
        drawAll("hud-over-" + std::to_string(int(shade * 255)), SbColor(shade, shade, shade));
    ASSERT_FALSE(picture.rgba.empty());
    const int panel = brightness(picture.pixel(13, kHeight - 13));
    int lightest = 0;
    int light = 0;
    for (int y = kHeight - 94; y < kHeight - 10; ++y)
      for (int x = 10; x < 314; ++x) {
        lightest = std::max(lightest, brightness(picture.pixel(x, y)));
        light += brightness(picture.pixel(x, y)) > panel + 60;
      }
    EXPECT_GE(lightest, 220) << shade;
    EXPECT_GE(lightest - panel, 110) << shade;
    EXPECT_GT(light, 1000) << "pixels of text, shade " << shade;
    EXPECT_LT(light, 5000) << shade;
  }
}

// What a scene leaves behind when it is no separator: fog, lines in place of faces, lights, objects in front.
TEST_F(TeHudRenderTest, TheScenesStateDoesNotReachIt) {
  m_root->removeChild(m_scene.get());
  const TePicture plain = drawAll("hud-plain");
  auto* fog = new SoEnvironment;
  fog->fogType = SoEnvironment::FOG;
  fog->fogColor.setValue(1, 0, 0);
  fog->fogVisibility = 1;
  m_root->insertChild(fog, 0);
  auto* lines = new SoDrawStyle;
  lines->style = SoDrawStyle::LINES;
  m_root->insertChild(lines, 0);
  m_root->insertChild(new SoDirectionalLight, 0);
  const TePicture changed = drawAll("hud-in-fog");
  ASSERT_FALSE(plain.rgba.empty());
  EXPECT_EQ(plain.rgba, changed.rgba);
}
