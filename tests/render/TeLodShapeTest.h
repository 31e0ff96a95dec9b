#pragma once

#include "nodes/askScene.h"
#include "nodes/lod/lodShape.h"
#include "render/TeGlNeighbour.h"
#include "render/TeSeamlessNodeTest.h"
#include "render/comparePixels.h"
#include "render/glObjects.h"
#include "render/magenta.h"

#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

/// What must be true of pictures of any SoTeLodShape of hills, 1000 m wide.
class TeLodShapeTest : public TeSeamlessNodeTest {
protected:
  static constexpr int kWidth = 320, kHeight = 240; ///< of pictures, if nothing else is said
  inline static const SbViewportRegion kPicture{kWidth, kHeight};

  /// Two cones above the terrain; `between` stands between them.
  static TeNodePtr<SoSeparator> cones(SoNode* between) {
    TeNodePtr<SoSeparator> group(new SoSeparator);
    for (const float x : {-150.0f, 150.0f}) {
      auto* part = new SoSeparator;
      auto* place = new SoTransform;
      place->translation.setValue(x, -300, 400);
      place->scaleFactor.setValue(90, 90, 90);
      auto* colour = new SoMaterial;
      colour->diffuseColor.setValue(0, x > 0 ? 1.0f : 0.2f, 1);
      part->addChild(colour);
      part->addChild(place);
      part->addChild(new SoCone);
      group->addChild(part);
      if (between && x < 0)
        group->addChild(between);
    }
    return group;
  }

  /// The rim of the square is all that may be seen of the background, from anywhere close to the ground.
  /// `prepare`: before each view.
  void expectNoBackgroundWithin(SoNode* node, int views, const std::function<void(int view)>& prepare) {
    std::mt19937 numbers(9);
    std::uniform_real_distribution<float> number(-1, 1);
    int covered = 0;
    for (int i = 0; i < views; i++) {
      prepare(i);
      const SbVec3f eye(430 * number(numbers), 430 * number(numbers), 160 + 60 * number(numbers));
      const SbVec3f ahead(number(numbers), number(numbers), -1.2f);
      const auto scene = seenBy(eye, eye + ahead, node);
      static_cast<SoPerspectiveCamera*>(scene->getChild(0))->nearDistance = 0.1f;
      const TePicture picture = show(scene.get(), "", 200, 150);
      EXPECT_EQ(enclosedBackground(picture), 0) << i;
      covered += 200 * 150 - countMagenta(picture);
    }
    EXPECT_GT(covered, views * 200 * 150 / 3);
  }

  /// The primitives that actions get, drawn by Coin in the node's place, cover the same pixels.
  void expectCoinDrawsAlike(SoTeLodShape* node, bool stretched, const std::string& name = "") {
    auto* transform = new SoTransform;
    if (stretched) {
      transform->scaleFactor.setValue(1, 0.5f, 3);
      transform->rotation.setValue(SbVec3f(1, 0, 1), 0.3f);
    }
    TeNodePtr<SoSeparator> group(new SoSeparator);
    group->addChild(transform);
    group->addChild(node);
    const auto scene = overview(group.get());
    TePicture ours;
    settle(scene.get(), ours);
    const std::vector<EmittedTriangle> mesh = emitted(scene.get(), kPicture);
    EXPECT_EQ(std::int64_t(mesh.size()), statisticsOf(*node).triangles);
    auto* points = new SoCoordinate3;
    points->point.setValues(0, 3 * int(mesh.size()), mesh.front().data());
    auto* faces = new SoFaceSet;
    const std::vector<std::int32_t> threes(mesh.size(), 3);
    faces->numVertices.setValues(0, int(threes.size()), threes.data());
    group->replaceChild(1, points);
    group->addChild(faces);
    const TePicture coins = show(scene.get(), name);
    int differ = 0;
    for (int y = 0; y < kHeight; y++) {
      for (int x = 0; x < kWidth; x++)
        differ += (ours.pixel(x, y) == kMagenta) != (coins.pixel(x, y) == kMagenta);
    }
    EXPECT_LE(differ, 10) << stretched; // a pixel's middle may lie on an edge
    EXPECT_GT(kWidth * kHeight - countMagenta(ours), 10000);
  }

  /// Side by side: more is covered, without a gap. How many frames it took.
  int expectTwiceInOneScene(SoNode* node) {
    TeNodePtr<SoSeparator> both(new SoSeparator);
    both->addChild(node);
    auto* aside = new SoTranslation;
    aside->translation.setValue(1200, 500, 0);
    both->addChild(aside);
    both->addChild(node);
    const auto scene = overview(both.get());
    TePicture picture, one;
    const int frames = settle(scene.get(), picture);
    EXPECT_EQ(enclosedBackground(picture), 0);
    settle(overview(node).get(), one);
    EXPECT_LT(countMagenta(picture), countMagenta(one) - 1000);
    show(scene.get());
    return frames;
  }

  /// OpenGL's state stays as a neighbour has left it.
  void expectStateStays(TeGlNeighbour& neighbour, SoNode* node) {
    const int looks = neighbour.looks;
    TeNodePtr<SoSeparator> group(new SoSeparator);
    group->addChild(neighbour.before().get());
    group->addChild(node);
    group->addChild(neighbour.after().get());
    show(overview(group.get()).get());
    EXPECT_EQ(neighbour.looks, looks + 1);
    EXPECT_EQ(neighbour.changes, 0);
  }

  /// Coin's own shapes before and after look as they do alone.
  void expectConesLookAsAlone(SoNode* node, const std::string& name = "") {
    const TePicture alone = show(overview(cones(nullptr).get()).get());
    const TePicture together = show(overview(cones(node).get()).get(), name);
    int compared = 0, differ = 0;
    for (int y = 0; y < kHeight; y++) {
      for (int x = 0; x < kWidth; x++) {
        if (alone.pixel(x, y) == kMagenta)
          continue;
        compared++;
        differ += alone.pixel(x, y) != together.pixel(x, y);
      }
    }
    EXPECT_GT(compared, 1000);
    EXPECT_EQ(differ, 0);
  }

  /// What a node has in OpenGL goes when it is not needed, in every context. `live`: number of the objects
  /// that hold it. `tolerance`: of colours, as another context may move what vertices are relative to.
  /// `changeHeights` gives the node others, of which it has as much in OpenGL as before.
  void expectNothingIsLeft(const std::function<TeNodePtr<SoTeLodShape>()>& make, std::int64_t (*live)(),
                           int tolerance,
                           const std::function<void(SoTeLodShape& node, SoNode* scene)>& changeHeights) {
    TeNodePtr<SoSeparator> empty(new SoSeparator);
    empty->addChild(new SoPerspectiveCamera);
    show(empty.get());
    const int before = glObjects(context());
    const std::int64_t none = live();
    {
      const auto node = make();
      const auto scene = overview(node.get());
      TePicture picture;
      settle(scene.get(), picture);
      const int drawn = glObjects(context());
      EXPECT_GT(drawn, before);
      changeHeights(*node, scene.get());
      settle(scene.get(), picture);
      show(scene.get());
      EXPECT_EQ(glObjects(context()), drawn);
      // A second context, and its end.
      const std::int64_t alive = live();
      {
        auto other = TeContext::create(s_kind, 64, 64);
        ASSERT_TRUE(other);
        ASSERT_TRUE((*other)->makeCurrent());
        auto renderer = TeSceneRenderer::create(**other, 64, 64);
        ASSERT_TRUE(renderer);
        EXPECT_TRUE((*renderer)->render(scene.get()));
        EXPECT_GT(glObjects(**other), 0);
        EXPECT_GT(live(), alive);
        renderer->reset();
      }
      EXPECT_EQ(live(), alive);
      ASSERT_TRUE(context().makeCurrent());
      EXPECT_EQ(glObjects(context()), drawn);
      EXPECT_LE(comparePixels(show(scene.get()), picture).largest, tolerance);
    }
    // The node is gone; its objects go with the next frame in their context.
    show(empty.get());
    EXPECT_EQ(glObjects(context()), before);
    EXPECT_EQ(live(), none);
  }

  /// One scene in two contexts, each with what it needs; after `frames` of them the picture is the same.
  /// `check`: after those in the second one.
  void expectContextsTakeTurns(SoNode* scene, int frames, const std::function<void(int turn)>& check) {
    TePicture first;
    settle(scene, first);
    auto other = TeContext::create(s_kind, 64, 64);
    ASSERT_TRUE(other);
    for (int turn = 0; turn < 3; turn++) {
      ASSERT_TRUE((*other)->makeCurrent());
      {
        auto renderer = TeSceneRenderer::create(**other, kWidth, kHeight);
        ASSERT_TRUE(renderer);
        TePicture second;
        for (int i = 0; i < frames; i++)
          second = frame(**renderer, scene);
        EXPECT_EQ(second, first);
        check(turn);
      }
      ASSERT_TRUE(context().makeCurrent());
      EXPECT_EQ(show(scene), first);
    }
  }
};
