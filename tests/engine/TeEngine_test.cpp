#include "engine/TeEngine.h"

#include "generators/base/TeLog.h"

#include <Inventor/SoDB.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

const float kNaN = std::numeric_limits<float>::quiet_NaN();
const float kInfinity = std::numeric_limits<float>::infinity();

TEST(TeEngine, AMapsAreaIsTwicePatchSide) {
  TeEngine engine(SbVec2s(65, 65), SbVec2f(64.0f, 64.0f));
  ASSERT_TRUE(engine.isValid()) << engine.lastError();
  TePatch* patch = engine.getPatch(SbVec2f(32.0f, -64.0f));
  ASSERT_NE(patch, nullptr);
  EXPECT_EQ(patch->getKey(), (TePatchKey{1, -2, 0}));
  EXPECT_EQ(patch->getCentre(), SbVec2d(32, -64));
}

TEST(TeEngine, AnyPointOfAPatchGivesThePatch) {
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64.0f, 64.0f));
  TePatch* patch = engine.getPatch(SbVec2f(0, 0));
  EXPECT_EQ(engine.getPatch(SbVec2f(-16, -16)), patch);
  EXPECT_EQ(engine.getPatch(SbVec2d(15.999, 15.999)), patch);
  EXPECT_EQ(engine.getPatch(TePatchKey{0, 0, 0}), patch);
  EXPECT_NE(engine.getPatch(SbVec2f(16, 0)), patch);
}

TEST(TeEngine, PointsFarOutNeedDoubles) {
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64.0f, 64.0f));
  TePatch* patch = engine.getPatch(SbVec2d(32e9 + 32, 0));
  ASSERT_NE(patch, nullptr);
  EXPECT_EQ(patch->getKey(), (TePatchKey{1000000001, 0, 0}));
}

TEST(TeEngine, BadArgumentsOfTheConstructorAreNamed) {
  const struct {
    SbVec2s samples;
    SbVec2f area;
  } cases[] = {
      {SbVec2s(64, 64), SbVec2f(64, 64)},
      {SbVec2s(65, 33), SbVec2f(64, 64)},
      {SbVec2s(0, 0), SbVec2f(64, 64)},
      {SbVec2s(1, 1), SbVec2f(64, 64)},
      {SbVec2s(-65, -65), SbVec2f(64, 64)},
      {SbVec2s(32767, 32767), SbVec2f(64, 64)},
      {SbVec2s(65, 65), SbVec2f(64, 32)},
      {SbVec2s(65, 65), SbVec2f(0, 0)},
      {SbVec2s(65, 65), SbVec2f(-1, -1)},
      {SbVec2s(65, 65), SbVec2f(kNaN, kNaN)},
      {SbVec2s(65, 65), SbVec2f(kInfinity, kInfinity)},
  };
  for (const auto& [samples, area] : cases) {
    TeEngine engine(samples, area);
    EXPECT_FALSE(engine.isValid()) << samples[0] << " " << area[0];
    EXPECT_FALSE(engine.lastError().empty());
    EXPECT_EQ(engine.lastError().find('\n'), std::string::npos);
    EXPECT_EQ(engine.getPatch(SbVec2f(0, 0)), nullptr);
    EXPECT_FALSE(engine.setGenerator("faults"));
    EXPECT_FALSE(engine.setSeed(1));
  }
}

TEST(TeEngine, PointsOutsideTheWorldAreAnError) {
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64.0f, 64.0f));
  for (const float bad : {kNaN, kInfinity, -kInfinity, 1e30f}) {
    EXPECT_EQ(engine.getPatch(SbVec2f(bad, 0)), nullptr);
    EXPECT_EQ(engine.getPatch(SbVec2f(0, bad)), nullptr);
    EXPECT_FALSE(engine.lastError().empty());
  }
}

TEST(TeEngine, BlendsAsAskedForUntilThereArePatches) {
  double heights[2];
  for (TeBlendProfile profile : {TeBlendProfile::Linear, TeBlendProfile::Smooth}) {
    TeEngine engine(SbVec2s(33, 33), SbVec2f(32.0f, 32.0f));
    ASSERT_TRUE(engine.setBlending(profile));
    TePatch* patch = engine.getPatch(SbVec2f(0, 0));
    ASSERT_TRUE(patch->prepareBuildMaps() && patch->buildHMapFromBuildMaps());
    heights[int(profile)] = *engine.getDatabase()->heightAt({-4, -4});
    EXPECT_FALSE(engine.setBlending(TeBlendProfile::Linear));
  }
  EXPECT_NE(heights[0], heights[1]);
}

TEST(TeEngine, UnknownGeneratorLeavesTheFormerOne) {
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64.0f, 64.0f));
  const std::string former = engine.getGenerator().name();
  EXPECT_FALSE(engine.setGenerator("no-such-generator"));
  EXPECT_NE(engine.lastError().find("no-such-generator"), std::string::npos) << engine.lastError();
  EXPECT_FALSE(engine.setGenerator("faults:faults=-3"));
  EXPECT_FALSE(engine.setGenerator("faults", {"no-such-filter"}));
  EXPECT_FALSE(engine.setGenerator(std::unique_ptr<TeGenerator>()));
  EXPECT_EQ(engine.getGenerator().name(), former);
}

TEST(TeEngine, SeedMakesTheWorld) {
  const auto heightsOf = [](std::uint64_t seed) {
    TeEngine engine(SbVec2s(17, 17), SbVec2f(64.0f, 64.0f));
    EXPECT_TRUE(engine.setSeed(seed));
    TePatch* patch = engine.getPatch(SbVec2f(0, 0));
    EXPECT_TRUE(patch->prepareBuildMaps() && patch->buildHMapFromBuildMaps());
    return patch->getData().heights();
  };
  EXPECT_EQ(heightsOf(3), heightsOf(3));
  EXPECT_NE(heightsOf(3), heightsOf(4));
}

TEST(TeEngine, SeedCannotChangeUnderPatches) {
  TeEngine engine(SbVec2s(17, 17), SbVec2f(64.0f, 64.0f));
  engine.getPatch(SbVec2f(0, 0));
  EXPECT_FALSE(engine.setSeed(4));
  EXPECT_NE(engine.lastError().find("seed"), std::string::npos);
}

TEST(TeEngine, ParametersTakeEffectWithNewMapsOnly) {
  TeEngine engine(SbVec2s(17, 17), SbVec2f(64.0f, 64.0f));
  ASSERT_TRUE(engine.setGenerator("faults")) << engine.lastError();
  TePatch* before = engine.getPatch(TePatchKey{0, 0, 0});
  ASSERT_TRUE(before->prepareBuildMaps());
  ASSERT_TRUE(teSetParameter(engine.getGenerator().parameters(), "faults", "faults", "3"));
  TePatch* beside = engine.getPatch(TePatchKey{1, 0, 0});
  ASSERT_TRUE(beside->prepareBuildMaps());
  ASSERT_TRUE(before->buildHMapFromBuildMaps() && beside->buildHMapFromBuildMaps());

  EXPECT_EQ(before->getData().map(1).get(), beside->getData().map(0).get());
  EXPECT_EQ(before->getData().map(3).get(), beside->getData().map(2).get());
  EXPECT_NE(beside->getData().map(0)->source->fingerprint(), beside->getData().map(1)->source->fingerprint());
  const int n = 8;
  for (int row = 0; row <= n; row++)
    EXPECT_EQ(before->getData().heights().at(n, row), beside->getData().heights().at(0, row));
}

TEST(TeEngine, UnusableParametersAreAnErrorOfTheNextMap) {
  TeEngine engine(SbVec2s(17, 17), SbVec2f(64.0f, 64.0f));
  ASSERT_TRUE(engine.setGenerator("faults"));
  for (const TeParameter& parameter : engine.getGenerator().parameters())
    if (parameter.name == "faults")
      *std::get<int*>(parameter.value) = -1;
  TePatch* patch = engine.getPatch(SbVec2f(0, 0));
  EXPECT_FALSE(patch->prepareBuildMaps());
  EXPECT_NE(engine.lastError().find("faults"), std::string::npos) << engine.lastError();
}

TEST(TeEngine, ErrorsGoToTheLogToo) {
  std::string logged;
  TeLog::setSink([&](TeLog::Level, const std::string& message) { logged = message; });
  TeEngine engine(SbVec2s(64, 64), SbVec2f(64.0f, 64.0f));
  TeLog::setSink({});
  EXPECT_EQ(logged, engine.lastError());
}

TEST(TeEngine, GraphsOutliveTheEngine) {
  SoDB::init();
  auto* engine = new TeEngine(SbVec2s(17, 17), SbVec2f(64.0f, 64.0f));
  TePatch* patch = engine->getPatch(SbVec2f(0, 0));
  ASSERT_TRUE(patch->prepareBuildMaps() && patch->buildHMapFromBuildMaps());
  SoSeparator* root = new SoSeparator;
  root->ref();
  root->addChild(patch->getPatchGraph());
  delete engine;
  EXPECT_GT(static_cast<SoSeparator*>(root->getChild(0))->getNumChildren(), 0);
  root->unref();
}

} // namespace
