#include "render/TeSeamlessNodeTest.h"

#include "render/magenta.h"

#include <cmath>
#include <cstdio>

namespace {

constexpr int kFramesEach = 250;
constexpr float kTremble = 0.3f; ///< metres; the eye is held within 4 m
constexpr double kFieldOfView = 1.6;

/// Triangles that are chosen for an eye over the middle, without holding it.
std::int64_t chosen(const TeSeamlessTerrainPtr& terrain, const SbVec3f& eye, double pixelError) {
  TeSeamlessPlacement placement;
  placement.corner = {-512, -512, 0};
  placement.spacing = 8;
  placement.range = terrain->range;
  TeSeamlessAccuracy accuracy;
  accuracy.pixelError = pixelError;
  TeLodView view;
  view.eye = {eye[0], eye[1], eye[2]};
  view.focal = 36 / 2.0 / std::tan(kFieldOfView / 2);
  TeSeamlessSelection selection;
  terrain->selector.select(view, placement, accuracy, nullptr, selection);
  return selection.triangles;
}

SbVec3f trembling(float height, int frame) {
  const float angle = float(frame) * 2.39996f;
  return SbVec3f(10, -50, height) + SbVec3f(std::cos(angle), std::sin(angle), std::sin(3 * angle)) * kTremble;
}

int switchesWithoutHolding(const TeSeamlessTerrainPtr& terrain, float height, double pixelError) {
  int switches = 0;
  for (int i = 1; i < kFramesEach; i++)
    switches += chosen(terrain, trembling(height, i), pixelError) !=
                chosen(terrain, trembling(height, i - 1), pixelError);
  return switches;
}

} // namespace

// A camera that trembles, at heights where one more or less of it changes what is needed: the triangles stay
// the same, since the eye is held. No pixel within the terrain is empty, and the error that is stated stays
// within what is wanted.
TEST_F(HardCase, LodThrashSeamless) {
  const auto node = hillsNode(128, 1024);
  node->minPatchResolution = 4;
  const auto layout = TeSeamlessLayout::create(128, 4, 3);
  const auto terrain = TeSeamlessTerrain::create(*layout, std::make_shared<const TeHeightMap>(hillsMap(128)));
  ASSERT_TRUE(terrain);
  const auto scene = seenBy(SbVec3f(0, 0, 0), SbVec3f(0, 1, 0), node.get());
  addSun(scene.get());
  auto* camera = static_cast<SoPerspectiveCamera*>(scene->getChild(0));
  camera->orientation.setValue(SbVec3f(1, 0, 0), 0); // straight down, all of the terrain in view
  camera->heightAngle = float(kFieldOfView);
  auto renderer = TeSceneRenderer::create(context(), 48, 36);
  ASSERT_TRUE(renderer);
  int places = 0, frames = 0, mostSwitches = 0, unheld = 0;
  double largestBound = 0;
  for (const float pixelError : {0.0f, 0.15f}) {
    node->pixelError = pixelError;
    int found = 0;
    for (float height = 700; height < 4000 && found < 2; height += 0.5f) {
      const SbVec3f below = trembling(height, 0), above = below + SbVec3f(0, 0, 0.5f);
      if (chosen(*terrain, below, double(pixelError)) == chosen(*terrain, above, double(pixelError)))
        continue;
      found++;
      places++;
      height += 0.25f;
      unheld += switchesWithoutHolding(*terrain, height, double(pixelError));
      std::int64_t before = -1;
      int switches = 0;
      for (int i = 0; i < kFramesEach; i++, frames++) {
        camera->position = trembling(height, i);
        EXPECT_EQ(enclosedBackground(frame(**renderer, scene.get())), 0);
        const TeSeamlessStatistics& statistics = node->statistics();
        switches += before >= 0 && statistics.faces != before;
        before = statistics.faces;
        largestBound = std::max(largestBound, statistics.errorBound);
        if (pixelError > 0) {
          EXPECT_LE(statistics.errorBound, double(pixelError));
        }
      }
      EXPECT_LE(switches, 1);
      mostSwitches = std::max(mostSwitches, switches);
      height += 60;
    }
    EXPECT_EQ(found, 2);
  }
  EXPECT_EQ(frames, 1000);
  EXPECT_GT(unheld, 100);
  std::printf("%d frames at %d places, trembling by %g m: at most %d switches (without holding the eye %d in "
              "all), bound up to %.2f px\n",
              frames, places, double(kTremble), mostSwitches, unheld, largestBound);
}
