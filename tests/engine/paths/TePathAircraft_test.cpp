#include "engine/paths/TePathAircraft.h"

#include "engine/paths/TeNamedPaths.h"
#include "generators/TeGeneratorRegistry.h"
#include "patchdb/TePatchDatabase.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

constexpr double kStep = 1.0 / 30;

/// An aircraft over a terrain whose patch below it is known before every step.
class TePathAircraftTest : public testing::Test {
protected:
  TePathAircraftTest() {
    const auto source = TeGeneratorRegistry::instance().source("function:z=\"20*sin(x/90)+30*cos(y/120)\"");
    EXPECT_TRUE(source);
    m_terrain = std::move(
        *TePatchDatabase::create({*TeLattice::create(65, 1), 0, std::make_shared<TeSingleSource>(*source)}));
  }

  static std::unique_ptr<TePathAircraft> aircraftOn(TeResult<TePath> path, double speed = 50) {
    EXPECT_TRUE(path) << (path ? "" : path.error().message);
    auto aircraft = std::make_unique<TePathAircraft>("test", TePathTraveller(std::move(*path), speed));
    EXPECT_TRUE(aircraft->setPosition(aircraft->traveller().place()));
    return aircraft;
  }

  void step(TePathAircraft& aircraft) {
    TePathTraveller ahead = aircraft.traveller();
    ahead.advance(kStep);
    const auto key = tePatchAt(m_terrain->lattice(), {ahead.place().x, ahead.place().y});
    ASSERT_TRUE(key && m_terrain->build(*key));
    stepBlindly(aircraft);
  }
  void stepBlindly(TePathAircraft& aircraft) {
    m_time += kStep;
    aircraft.update({kStep, m_time, *m_terrain});
  }

  double heightAboveGround(const TePathAircraft& aircraft) const {
    const glm::dvec3& p = aircraft.position();
    return p.z - m_terrain->heightAt({p.x, p.y}).value();
  }

private:
  std::unique_ptr<TePatchDatabase> m_terrain;
  double m_time = 0;
};

TEST_F(TePathAircraftTest, IsWhereTheTravellerIs) {
  const std::unique_ptr<TePathAircraft> aircraft = aircraftOn(teNamedPath("zigzag", {0, 0, 200}, false));
  TePathTraveller traveller = aircraft->traveller();
  for (int i = 0; i < 600; ++i) {
    step(*aircraft);
    traveller.advance(kStep);
    EXPECT_LT(glm::distance(aircraft->position(), traveller.place()), 1e-6);
    EXPECT_NEAR(glm::length(aircraft->velocity()), 50, 0.5);
  }
}

TEST_F(TePathAircraftTest, FollowsTheGroundAtTheHeightAsked) {
  const std::unique_ptr<TePathAircraft> aircraft = aircraftOn(teNamedPath("line", {0, 0, 60}, true));
  double lowest = 1e9, highest = -1e9, sum = 0;
  for (int i = 0; i < 1800; ++i) {
    step(*aircraft);
    if (i < 300)
      continue; // until it has come to its height
    lowest = std::min(lowest, heightAboveGround(*aircraft));
    highest = std::max(highest, heightAboveGround(*aircraft));
    sum += heightAboveGround(*aircraft) / 1500;
  }
  EXPECT_GT(lowest, 40);
  EXPECT_LT(highest, 80);
  EXPECT_NEAR(sum, 60, 5);
}

TEST_F(TePathAircraftTest, NeverFliesBelowItsClearance) {
  for (const bool aboveGround : {false, true}) {
    const std::unique_ptr<TePathAircraft> aircraft = aircraftOn(teNamedPath("line", {0, 0, 1}, aboveGround));
    for (int i = 0; i < 900; ++i) {
      step(*aircraft);
      EXPECT_GE(heightAboveGround(*aircraft), TeAircraft::kClearance - 1e-9);
    }
  }
}

TEST_F(TePathAircraftTest, JumpsAtOnceAndArrivesAtItsHeight) {
  const std::unique_ptr<TePathAircraft> aircraft =
      aircraftOn(TePath::parse("0 0 +60\n0 50 +60\njump 1e9 5e8 +80\n1e9 500000500 +80\n", "text"));
  while (aircraft->traveller().jumps() == 0)
    step(*aircraft);
  EXPECT_EQ(aircraft->position().x, 1e9);
  EXPECT_NEAR(heightAboveGround(*aircraft), 80, 1e-3);
  EXPECT_NEAR(glm::length(aircraft->velocity()), 50, 1e-9);
  step(*aircraft);
  EXPECT_NEAR(glm::length(aircraft->velocity()), 50, 1);
}

TEST_F(TePathAircraftTest, KeepsItsAltitudeOverUnknownGround) {
  const std::unique_ptr<TePathAircraft> aircraft = aircraftOn(teNamedPath("line", {0, 0, 60}, true));
  for (int i = 0; i < 30; ++i)
    stepBlindly(*aircraft);
  EXPECT_NEAR(aircraft->position().z, 60, 1e-9);
  EXPECT_NEAR(aircraft->position().y, 50, 1e-9);
}

TEST_F(TePathAircraftTest, RestsAtTheEnd) {
  const std::unique_ptr<TePathAircraft> aircraft = aircraftOn(TePath::parse("0 0 90\n0 100 90\n", "text"));
  while (aircraft->moving())
    step(*aircraft);
  EXPECT_EQ(aircraft->position().y, 100);
  EXPECT_EQ(aircraft->velocity(), glm::dvec3(0));
}

TEST_F(TePathAircraftTest, TheStateRepeats) {
  const std::unique_ptr<TePathAircraft> a = aircraftOn(teNamedPath("circle", {0, 0, 60}, true));
  const std::unique_ptr<TePathAircraft> b = aircraftOn(teNamedPath("circle", {0, 0, 60}, true));
  std::uint64_t before = 0;
  for (int i = 0; i < 200; ++i) {
    step(*a);
    step(*b);
    EXPECT_EQ(a->stateHash(), b->stateHash());
    EXPECT_NE(a->stateHash(), before);
    before = a->stateHash();
  }
}

} // namespace
