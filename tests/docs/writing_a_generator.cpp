// The examples of docs/writing-a-generator.md.

//! [source]
#include "generators/TeGenerator.h"
#include "generators/base/TeFloatEnvironment.h"
#include "generators/base/TeHash.h"
#include "generators/base/TeMath.h"

/// Parallel dunes: the recipe, with the parameters it was made with.
class DuneSource final : public TePointSource {
public:
  DuneSource(double height, double wavelength) : m_height(height), m_wavelength(wavelength) {}

  std::string name() const override { return "dunes"; }
  std::uint64_t fingerprint() const override {
    return teHashDouble(teHashDouble(teHashText("dunes"), m_height), m_wavelength);
  }
  bool fits() const override { return true; } // a height depends on its place alone

  TeStatus evaluate(const TeMapRequest& request, const TeMapSample* samples, std::size_t count,
                    float* heights) const override {
    const TeFloatEnvironment environment;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = request.x(samples[i].column);
      const double y = request.y(samples[i].row);
      const double bend = 0.2 * m_wavelength * teSin(y / m_wavelength);
      heights[i] = float(m_height * (1.0 + teCos((x + bend) * 6.283185307179586 / m_wavelength)) / 2.0);
    }
    return {};
  }

private:
  double m_height;
  double m_wavelength;
};
//! [source]

//! [generator]
/// The same with public parameters.
class Dunes final : public TeGenerator {
public:
  Dunes() { setDefaults(); }
  std::string name() const override { return "dunes"; }
  TeParameters parameters() override {
    return {{"height", &height, 0, 1000, {}, "metres from trough to crest"},
            {"wavelength", &wavelength, 1, 1e6, {}, "metres from crest to crest"}};
  }

  double height;
  double wavelength;

protected:
  void setDefaults() override {
    height = 8;
    wavelength = 60;
  }
  TeResult<TeHeightSourcePtr> makeSource() const override {
    return TeHeightSourcePtr(std::make_shared<DuneSource>(height, wavelength));
  }
};
//! [generator]

//! [register]
#include "generators/TeGeneratorRegistry.h"

TeStatus addDunes() {
  return TeGeneratorRegistry::instance().addGenerator("dunes", "parallel dunes",
                                                      [] { return std::make_unique<Dunes>(); });
}
//! [register]

#include "engine/TeEngine.h"
#include "engine/objects/TeAircraft.h"
#include "nodes/TeNodes.h"

#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

//! [step]
/// Makes a map a little at a time, as a frame loop does.
TeResult<TeHeightMap> makeInSlices(TeGenerator& generator, const TeMapRequest& request) {
  if (TeStatus ok = generator.start(request); !ok)
    return ok.error();
  bool complete = false;
  while (!complete) {
    TeAllowance slice = TeAllowance::seconds(0.002);
    complete = generator.genStep(slice);
  }
  if (generator.progress() == TeProgress::Failed)
    return generator.error();
  return generator.takeMap();
}
//! [step]

TEST(WritingAGenerator, TheExampleIsAGeneratorLikeOurs) {
  ASSERT_TRUE(addDunes().ok() || TeGeneratorRegistry::instance().help("dunes") == "parallel dunes");
  const auto source = TeGeneratorRegistry::instance().source("dunes:wavelength=40", {"matrix"});
  ASSERT_TRUE(source.ok());
  EXPECT_TRUE((*source)->fits());
  EXPECT_FALSE(TeGeneratorRegistry::instance().source("dunes:wavelength=0").ok());

  Dunes dunes;
  const TeMapRequest request = TeMapRequest::sourceMap(TeLattice::create(65, 1).value(), 1, {3, 4});
  const auto map = makeInSlices(dunes, request);
  ASSERT_TRUE(map.ok());
  EXPECT_TRUE(*map == dunes.source()->generate(request).value());
  const TeMapStatistics statistics = map->statistics();
  EXPECT_GE(statistics.minimum, 0);
  EXPECT_LE(statistics.maximum, 8);
  EXPECT_GT(statistics.maximum - statistics.minimum, 7);
}

// Nothing of the engine knows of dunes.
TEST(WritingAGenerator, TheEngineMakesEndlessTerrainWithIt) {
  TeNodes::init();
  ASSERT_TRUE(addDunes().ok() || TeGeneratorRegistry::instance().help("dunes") == "parallel dunes");
  const TeNodePtr<SoSeparator> scene(new SoSeparator);
  auto* camera = new SoPerspectiveCamera;
  scene->addChild(camera);
  TeEngine engine(SbVec2s(33, 33), SbVec2f(64.0f, 64.0f));
  engine.setSceneRoot(scene.get());
  engine.setSceneCamera(camera);
  auto aircraft = std::make_unique<TeAircraft>("mine");
  ASSERT_TRUE(aircraft->setPosition({0, 0, 30}) && aircraft->setVelocity({0, 60, 0}));
  engine.setActiveObject(engine.addObject(std::move(aircraft)));
  //! [engine]
  engine.setGenerator("dunes:height=12,wavelength=40");
  engine.initialize();
  //! [engine]
  ASSERT_TRUE(engine.isInitialized()) << engine.lastError();
  for (int tick = 0; tick < 60; ++tick)
    engine.timeTick(1.0 / 30);
  EXPECT_EQ(engine.getStatistics().framesWithoutGround, 0);
  EXPECT_GT(engine.getActiveObject()->position().y, 100);

  double lowest = INFINITY, highest = -INFINITY;
  for (double x = -20; x <= 20; x += 0.5)
    if (const auto height = engine.getDatabase()->heightAt({x, 118.0})) {
      lowest = std::min(lowest, *height);
      highest = std::max(highest, *height);
    }
  EXPECT_GE(lowest, 0);
  EXPECT_LE(highest, 12);
  EXPECT_GT(highest - lowest, 9) << "a dune from trough to crest";
}

} // namespace
