#include "nodes/terrain/TeLevelErrors.h"
#include "nodes/terrain/TeMeshDrawing.h"
#include "nodes/testWorld.h"
#include "render/TeRenderTest.h"
#include "render/comparePixels.h"
#include "render/magenta.h"
#include "render/meshScene.h"

#include <Inventor/actions/SoSearchAction.h>

#include <cmath>
#include <cstdio>
#include <set>

namespace {

constexpr int kWidth = 200, kHeight = 150;
constexpr int kPatches = 7;
constexpr int kMaps = 65;         ///< samples: patches of 32 cells of 1 m
constexpr int kFramesToFind = 20; ///< until all meshes in view have found their errors

/// A block of patches drawn around its centre: rough in the east, smooth in the west, one cliff.
class TeMeshLevels : public TeRenderTest {
protected:
  void SetUp() override {
    TeRenderTest::SetUp();
    m_block = std::make_unique<TeStaticBlock>(
        meshBlock(worldOf(std::make_shared<TeSampleFunction>(heights), kMaps), {0, 0}, kPatches));
    build(0);
  }

  static float heights(std::int64_t x, std::int64_t y) {
    const double rough = x > 0 ? 0.002 * double(x) : 0;
    const double noise = double((x * 7919 + y * 104729) % 13) / 13 - 0.5;
    return float(6 * std::sin(double(x) * 0.05) * std::cos(double(y) * 0.07) + rough * 8 * noise +
                 (y == 40 && x > -60 && x < 60 ? 12 : 0));
  }

  /// `pixels`: wanted when the meshes are made.
  void build(double pixels) {
    m_drawing = drawingOf(*m_block);
    m_drawing->setPixelError(pixels);
    m_graph = meshGraph(*m_block, m_drawing);
    m_scene = sideView(m_graph.get(), 150);
    m_camera = static_cast<SoPerspectiveCamera*>(m_scene->getChild(0));
    auto renderer = TeSceneRenderer::create(context(), kWidth, kHeight);
    ASSERT_TRUE(renderer) << renderer.error().message;
    m_renderer = std::move(*renderer);
    m_renderer->setBackground(SbColor(1, 0, 1));
  }

  void look(const SbVec3f& from, const SbVec3f& at) {
    m_camera->position = from;
    m_camera->pointAt(at, SbVec3f(0, 0, 1));
  }

  TePicture frame() {
    m_drawing->resetFrame();
    TeResult<TePicture> picture = m_renderer->render(m_scene.get());
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().message);
    return std::move(*picture);
  }

  std::vector<SoTeTerrainMesh*> meshes() {
    std::vector<SoTeTerrainMesh*> meshes;
    for (int i = 0; i < m_graph->getNumChildren(); i++)
      if (m_graph->getChild(i)->isOfType(SoTeTerrainMesh::getClassTypeId()))
        meshes.push_back(static_cast<SoTeTerrainMesh*>(m_graph->getChild(i)));
    return meshes;
  }
  std::vector<int> levels() {
    std::vector<int> levels;
    for (const SoTeTerrainMesh* mesh : meshes())
      levels.push_back(mesh->level());
    return levels;
  }

  std::unique_ptr<TeStaticBlock> m_block;
  std::shared_ptr<TeMeshDrawing> m_drawing;
  TeNodePtr<SoSeparator> m_graph;
  TeNodePtr<SoSeparator> m_scene;
  SoPerspectiveCamera* m_camera = nullptr;
  std::unique_ptr<TeSceneRenderer> m_renderer;
};

} // namespace

TEST_F(TeMeshLevels, NothingIsMadeUntilAnErrorIsWanted) {
  const TePicture before = frame();
  const std::size_t bytes = m_drawing->bufferBytes();
  const std::int64_t triangles = m_drawing->frame().triangles;
  EXPECT_EQ(m_drawing->frame().errorBound, 0);
  for (const SoTeTerrainMesh* mesh : meshes())
    EXPECT_TRUE(mesh->levelErrors().empty());
  m_drawing->setPixelError(8);
  for (int i = 0; i < kFramesToFind; i++)
    frame();
  EXPECT_LT(m_drawing->frame().triangles, triangles);
  // Of two sizes of grids that lie and stand, and one that is square.
  EXPECT_LE(m_drawing->bufferBytes() - bytes, 2u * 3 * (568 + 216 + 136 + 120 + 62 + 62));
  m_drawing->setPixelError(0);
  EXPECT_EQ(frame(), before);
  EXPECT_EQ(m_drawing->frame().triangles, triangles);
  EXPECT_EQ(m_drawing->frame().errorBound, 0);
}

TEST_F(TeMeshLevels, MeshesMadeWithAnErrorHaveTheirLevelsAtOnce) {
  m_drawing->setPixelError(4);
  for (int i = 0; i < kFramesToFind; i++)
    frame();
  const std::vector<int> later = levels();
  std::vector<std::vector<float>> errors;
  for (const SoTeTerrainMesh* mesh : meshes())
    errors.push_back(mesh->levelErrors());
  const TePicture picture = frame();
  build(4);
  EXPECT_EQ(frame(), picture);
  EXPECT_EQ(levels(), later);
  int found = 0;
  for (std::size_t i = 0; i < errors.size(); i++) {
    if (errors[i].size() < 2) // not in view, or too small to have levels
      continue;
    EXPECT_EQ(meshes()[i]->levelErrors(), errors[i]);
    found++;
  }
  EXPECT_GT(found, 40);
}

TEST_F(TeMeshLevels, LeaveNoCrack) {
  build(1);
  const SbVec3f eyes[] = {{100, -110, 60}, {-100, 60, 30}, {-40, 10, 15}, {0, 1, 250}, {90, 90, 20}};
  std::set<int> seen;
  for (const SbVec3f& eye : eyes) {
    look(eye, SbVec3f(0, 0, 0));
    m_drawing->setPixelError(0);
    const TePicture full = frame();
    ASSERT_EQ(enclosedBackground(full), 0);
    for (const double pixels : {0.25, 1.0, 4.0, 16.0, 200.0}) {
      m_drawing->setPixelError(pixels);
      const TePicture picture = frame();
      EXPECT_EQ(enclosedBackground(picture), 0) << pixels << " px from " << eye[0] << ", " << eye[1];
      for (const int level : levels())
        seen.insert(level);
    }
  }
  EXPECT_EQ(seen.size(), 5u) << "levels 0 to 4";
}

// With any two levels beside each other: straight from above no background shows anywhere within the block.
TEST_F(TeMeshLevels, FitBesideEachOther) {
  build(1e-3);
  look(SbVec3f(0, 0, 250), SbVec3f(0, 0.001f, 0));
  frame();
  for (const double pixels : {0.05, 0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 9.0}) {
    m_drawing->setPixelError(pixels);
    const TePicture picture = frame();
    std::set<int> now;
    for (const int level : levels())
      now.insert(level);
    EXPECT_EQ(enclosedBackground(picture), 0);
    std::printf("%.2f px: %zu levels, %lld triangles, error %.3f px\n", pixels, now.size(),
                (long long)m_drawing->frame().triangles, m_drawing->frame().errorBound);
  }
}

TEST_F(TeMeshLevels, TheBoundHoldsAndTrianglesFallWithTheError) {
  build(1);
  m_drawing->setPixelError(0);
  frame();
  std::int64_t before = m_drawing->frame().triangles;
  for (const double pixels : {0.1, 0.5, 1.0, 2.0, 4.0, 8.0, 32.0}) {
    m_drawing->setPixelError(pixels);
    frame();
    EXPECT_LE(m_drawing->frame().errorBound, pixels);
    EXPECT_LE(m_drawing->frame().triangles, before);
    before = m_drawing->frame().triangles;
    // What each mesh has is at most what its nearest sample allows.
    const double focal = kHeight / 2 / std::tan(double(m_camera->heightAngle.getValue()) / 2);
    const SbVec3f eye = m_camera->position.getValue();
    for (const SoTeTerrainMesh* mesh : meshes()) {
      if (mesh->level() == 0)
        continue;
      double nearest = 1e9;
      for (const glm::vec3& position : mesh->mesh()->positions) {
        const SbVec3f place(float(mesh->mesh()->origin.x) + position.x,
                            float(mesh->mesh()->origin.y) + position.y, position.z);
        nearest = std::min(nearest, double((place - eye).length()));
      }
      EXPECT_LE(double(mesh->levelErrors()[std::size_t(mesh->level())]) * focal / nearest, pixels * 1.0001);
    }
  }
}

TEST_F(TeMeshLevels, AnEyeThatTremblesChangesNothing) {
  build(2);
  int most = 0;
  for (int run = 0; run < 3; run++) {
    const SbVec3f eye(100 - 13.7f * float(run), -110, 60 - 9.3f * float(run));
    look(eye, SbVec3f(0, 0, 0));
    frame();
    std::vector<int> before = levels();
    std::vector<int> switches(before.size(), 0);
    for (int i = 0; i < 12; i++) {
      look(eye + SbVec3f(0.4f, -0.3f, 0.5f) * (i % 2 ? 1.0f : -1.0f), SbVec3f(0, 0, 0));
      frame();
      const std::vector<int> now = levels();
      for (std::size_t k = 0; k < now.size(); k++)
        switches[k] += now[k] != before[k];
      before = now;
    }
    most = std::max(most, *std::max_element(switches.begin(), switches.end()));
  }
  EXPECT_LE(most, 1);
}

TEST_F(TeMeshLevels, StayWithTheAnchor) {
  build(2);
  const TePicture before = frame();
  const std::vector<int> levelsBefore = levels();
  m_drawing->beginAnchor(m_drawing->anchor() + glm::dvec2(512, -256));
  for (int i = 0; i < 200 && !m_drawing->nextAnchorReady(); i++) {
    m_drawing->resetFrame(20000);
    ASSERT_TRUE(m_renderer->render(m_scene.get()));
  }
  ASSERT_TRUE(m_drawing->nextAnchorReady());
  m_drawing->commitAnchor();
  const TePicture after = frame();
  EXPECT_EQ(enclosedBackground(after), 0);
  EXPECT_LE(comparePixels(before, after).pixels, kWidth * kHeight / 100) << "positions are rounded anew";
  EXPECT_EQ(levels(), levelsBefore);
}
