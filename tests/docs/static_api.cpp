// The code of docs/writing-an-application.md, compiled and run.

#include "engine/TeEngine.h"
#include "generators/faults/TeFaultGenerator.h"

#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <cstdio>

namespace {

int trianglesOf(SoNode* node) {
  SoGetPrimitiveCountAction count;
  count.apply(node);
  return count.getTriangleCount();
}

TEST(StaticApi, AsInTheDocument) {
  SoDB::init();
  SoSeparator* root = new SoSeparator;
  root->ref();

  //! [document]
  TeEngine* engine = new TeEngine(SbVec2s(65, 65), SbVec2f(64.0f, 64.0f));

  TePatch* tmp = NULL;
  tmp = engine->getPatch(SbVec2f(0.0f, 0.0f));
  tmp->prepareBuildMaps();
  tmp->buildHMapFromBuildMaps();
  root->addChild(tmp->getPatchGraph());
  //! [document]
  EXPECT_EQ(trianglesOf(root), 30 * 30 * 2);

  EXPECT_EQ(tmp->getSeamGraph(TePatch::EAST), nullptr) << "the east neighbour does not exist yet";
  EXPECT_FALSE(engine->lastError().empty());

  //! [seam]
  TePatch* east = engine->getPatch(SbVec2f(32.0f, 0.0f));
  east->prepareBuildMaps();
  east->buildHMapFromBuildMaps();
  root->addChild(east->getPatchGraph());
  root->addChild(tmp->getSeamGraph(TePatch::EAST));
  //! [seam]
  EXPECT_EQ(trianglesOf(root), 2 * 30 * 30 * 2 + 2 * 30 * 2);
  root->unref();
  delete engine;
}

TEST(StaticApi, NinePatches) {
  SoDB::init();
  //! [nine]
  TeEngine engine(SbVec2s(65, 65), SbVec2f(64.0f, 64.0f));
  engine.setSeed(7);
  engine.setGenerator("faults:faults=200");

  SoSeparator* root = new SoSeparator;
  root->ref();
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++) {
      TePatch* patch = engine.getPatch(TePatchKey{x, y, 0});
      if (!patch->prepareBuildMaps() || !patch->buildHMapFromBuildMaps())
        std::fprintf(stderr, "%s\n", engine.lastError().c_str());
    }
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++) {
      TePatch* patch = engine.getPatch(TePatchKey{x, y, 0});
      root->addChild(patch->getPatchGraph());
      // Seams and corners lie to the east and north of a patch; beyond the rim there is no neighbour.
      if (x < 1)
        root->addChild(patch->getSeamGraph(TePatch::EAST));
      if (y < 1)
        root->addChild(patch->getSeamGraph(TePatch::NORTH));
      if (x < 1 && y < 1)
        root->addChild(patch->getSeamGraph(TePatch::NORTH_EAST));
    }
  //! [nine]
  EXPECT_TRUE(engine.lastError().empty()) << engine.lastError();
  EXPECT_EQ(trianglesOf(root), (3 * 32 - 2) * (3 * 32 - 2) * 2);
  root->unref();
}

TEST(StaticApi, Queries) {
  TeEngine engine(SbVec2s(65, 65), SbVec2f(64.0f, 64.0f));
  TePatch* patch = engine.getPatch(SbVec2f(0.0f, 0.0f));
  patch->prepareBuildMaps();
  patch->buildHMapFromBuildMaps();
  //! [queries]
  const TePatchDatabase* terrain = engine.getDatabase();
  const auto height = terrain->heightAt({3.5, -2.25});
  const auto normal = terrain->normalAt({3.5, -2.25});
  const auto hit = terrain->intersect({0, 0, 1000}, {0.001, 0, -1}, 2000);
  if (height && normal && hit)
    std::printf("%.3f m here; the ray hits at %.3f m\n", *height, hit->position.z);
  //! [queries]
  ASSERT_TRUE(height && normal && hit);
  EXPECT_GE(*height, patch->getData().minimum());
  EXPECT_LE(*height, patch->getData().maximum());
}

TEST(StaticApi, ParametersWhileRunning) {
  TeEngine engine(SbVec2s(65, 65), SbVec2f(64.0f, 64.0f));
  //! [parameters]
  auto generator = std::make_unique<TeFaultGenerator>();
  TeFaultGenerator& faults = *generator;
  engine.setGenerator(std::move(generator));
  faults.faults = 40; // for maps made from now on
  //! [parameters]
  EXPECT_TRUE(engine.lastError().empty());
  EXPECT_EQ(&engine.getGenerator(), &faults);
}

} // namespace
