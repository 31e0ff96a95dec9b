#include "engine/objects/TeCar.h"

#include "engine/objects/TeDriveTrain.h"
#include "engine/objects/TeObjects.h"
#include "engine/objects/TeTestRoad.h"
#include "tests/engine/TeEndlessWorld.h"

#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGetBoundingBoxAction.h>
#include <Inventor/nodes/SoSeparator.h>

#include <cstdio>

namespace {

using Key = SoKeyboardEvent::Key;

constexpr const char* kFlat = "function:z=0";
constexpr double kMillimetre = 1e-3;

TeKeyEvent keyEvent(Key key, bool down) {
  TeKeyEvent event;
  event.key = key;
  event.down = down;
  return event;
}

/// Everything that a program sees of where a car is.
bool samePlace(const TeCar& car, const glm::dvec3& position, const glm::dquat& orientation) {
  return car.position() == position && car.orientation() == orientation;
}

class TeCarOnTerrain : public testing::TestWithParam<const char*> {};

// From the south-west across the borders of patches at negative keys, past the origin.
TEST_P(TeCarOnTerrain, EveryWheelIsOnTheSurfaceInEveryFrame) {
  TeTestRoad road(GetParam());
  road.start({-150, -170}, {0.6, 0.8});
  road.car().setAuto(true);
  road.drive(30);
  std::printf("%s: %.0f m, %d patches, wheels within %.1e m, travel up to %.2f m\n", GetParam(),
              road.car().distanceDriven(), road.patchesVisited, road.worstGap, road.worstTravel);
  EXPECT_LE(road.worstGap, kMillimetre);
  EXPECT_LE(road.worstTravel, TeCarGeometry::kTravel);
  EXPECT_GE(road.patchesVisited, 3);
}

INSTANTIATE_TEST_SUITE_P(Generators, TeCarOnTerrain,
                         testing::Values("faults:profile=smooth", "noise", "noise:type=ridged", "circles",
                                         "midpoint:displacement=2", "function:z=\"6*sin(x/17)*cos(y/13)\""));

TEST(TeCar, WheelsAreOnTheSurfaceFarFromTheOrigin) {
  for (const double distance : {1e6, 1e9}) {
    TeTestRoad road("noise");
    road.start({distance, -distance});
    road.car().setAuto(true);
    road.drive(8);
    std::printf("%.0e m out: %.0f m driven, wheels within %.1e m\n", distance, road.car().distanceDriven(),
                road.worstGap);
    EXPECT_LE(road.worstGap, kMillimetre);
    EXPECT_GT(road.car().distanceDriven(), 50);
  }
}

// Steps of faults are as steep as two samples allow: walls and precipices.
TEST(TeCar, SteepFaultsStopItWithAllWheelsOnTheSurface) {
  TeTestRoad road("faults:profile=step,faults=40");
  road.start({3, 3});
  ASSERT_TRUE(road.car().setThrottle(1));
  road.drive(20);
  EXPECT_TRUE(road.car().blocked());
  EXPECT_EQ(road.car().velocity(), glm::dvec3(0));
  EXPECT_LE(road.worstGap, kMillimetre);
  const double driven = road.car().distanceDriven();
  ASSERT_TRUE(road.car().setThrottle(-1));
  road.drive(1);
  EXPECT_GT(road.car().distanceDriven(), driven) << "it can back out";
  EXPECT_LE(road.worstGap, kMillimetre);
}

// Wherever it is put, even where the ground is rougher than the suspension takes.
TEST(TeCar, PlacedOnRoughGroundItsWheelsReachTheSurface) {
  TeTestRoad road("midpoint:displacement=40,fall=0.8");
  bool beyondTravel = false;
  for (int i = 0; i < 40; ++i) {
    road.start({37.3 * i, -11.7 * i});
    road.step(0.01);
    beyondTravel = beyondTravel || road.worstTravel > TeCarGeometry::kTravel;
  }
  EXPECT_TRUE(beyondTravel) << "the test shows nothing on ground as smooth as this";
  EXPECT_LE(road.worstGap, kMillimetre);
}

TEST(TeCar, StopsBeforeAHoleInTheGround) {
  // No data north of y = 20.
  TeTestRoad road("function:z=\"sqrt(20 - y)*0\"");
  road.start({0, 0});
  ASSERT_TRUE(road.car().setThrottle(1));
  road.drive(5);
  EXPECT_TRUE(road.car().blocked());
  EXPECT_EQ(road.car().velocity(), glm::dvec3(0));
  EXPECT_GT(road.car().position().y, 15);
  EXPECT_LT(road.car().wheelContact(TeCarGeometry::FrontLeft).y, 20);
  EXPECT_LE(road.worstGap, kMillimetre);
  ASSERT_TRUE(road.car().setThrottle(0));
  road.drive(1);
  EXPECT_FALSE(road.car().moving()) << "it sleeps there";
  ASSERT_TRUE(road.car().setThrottle(-1));
  road.drive(1);
  EXPECT_LT(road.car().speed(), 0);
}

TEST(TeCar, PlacedOverAHoleItStaysAndSleeps) {
  TeTestRoad road("function:z=\"sqrt(20 - y)*0\"");
  road.buildAround({0, 20});
  road.start({0, 20.5});
  ASSERT_TRUE(road.car().setThrottle(1));
  for (int i = 0; i < 10; ++i)
    road.car().update({0.05, 0, road.terrain()});
  EXPECT_EQ(road.car().position().y, 20.5);
  EXPECT_FALSE(road.car().onGround(TeCarGeometry::FrontLeft));
  EXPECT_TRUE(road.car().onGround(TeCarGeometry::RearLeft));
  ASSERT_TRUE(road.car().setThrottle(0));
  road.car().update({0.05, 0, road.terrain()});
  EXPECT_FALSE(road.car().moving());
}

// Its front wheels stand on a patch that is not there yet.
TEST(TeCar, WaitsForTheGroundBelowEachWheel) {
  TeTestRoad road("noise");
  const double border = 0.5 * road.terrain().lattice().patchSide();
  ASSERT_TRUE(road.terrain().build({0, 0, 0}));
  road.start({0, border - 0.5});
  const auto update = [&] { road.car().update({0.02, 0, road.terrain()}); };
  update();
  EXPECT_TRUE(road.car().moving());
  EXPECT_FALSE(road.car().onGround(TeCarGeometry::FrontLeft));
  ASSERT_TRUE(road.terrain().build({0, 1, 0}));
  update();
  EXPECT_TRUE(road.car().onGround(TeCarGeometry::FrontLeft));
  EXPECT_FALSE(road.car().moving());
}

TEST(TeCar, LeftAloneItComesToExactRest) {
  TeTestRoad road("noise");
  road.start({-20, 10});
  ASSERT_TRUE(road.car().setThrottle(1));
  ASSERT_TRUE(road.car().setSteering(0.4));
  road.drive(4);
  ASSERT_GT(road.car().speed(), 3);
  ASSERT_TRUE(road.car().setThrottle(0));
  ASSERT_TRUE(road.car().setSteering(0));
  road.drive(30);
  EXPECT_FALSE(road.car().moving());
  EXPECT_EQ(road.car().velocity(), glm::dvec3(0));
  const glm::dvec3 position = road.car().position();
  const glm::dquat orientation = road.car().orientation();
  const std::uint64_t hash = road.car().stateHash();
  road.drive(1);
  EXPECT_TRUE(samePlace(road.car(), position, orientation));
  EXPECT_EQ(road.car().stateHash(), hash);
}

TEST(TeCar, FrameRatesAgree) {
  const auto end = [](double dt) {
    TeTestRoad road("function:z=\"6*sin(x/17)*cos(y/13)\"");
    road.start({0, 0});
    EXPECT_TRUE(road.car().setThrottle(0.6));
    EXPECT_TRUE(road.car().setSteering(0.2));
    road.drive(6, dt);
    EXPECT_GT(road.car().distanceDriven(), 30);
    return road.car().position();
  };
  const glm::dvec3 fine = end(1.0 / 240);
  for (const double dt : {1.0 / 60, 1.0 / 30, 0.1})
    EXPECT_LT(glm::length(end(dt) - fine), 0.5) << dt;
}

TEST(TeCar, LongTicksAreSimulatedInShortSteps) {
  TeTestRoad road("noise");
  for (int i = -10; i <= 10; ++i)
    road.buildAround({0, 16.0 * i});
  TeObjects objects;
  auto* car = static_cast<TeCar*>(*objects.add(std::make_unique<TeCar>("car")));
  ASSERT_TRUE(car->setThrottle(1));
  const glm::dvec3 before = car->position();
  const auto tick = objects.update(50, road.terrain());
  ASSERT_TRUE(tick);
  EXPECT_EQ(tick->simulated, TeObjects::kLongestTick);
  EXPECT_GT(car->position().y, before.y + 1);
  EXPECT_LT(car->position().y, before.y + 5) << "a second's drive, no more";
  for (int i = 0; i < TeCarGeometry::kWheels; ++i) {
    const glm::dvec3 contact = car->wheelContact(i);
    EXPECT_NEAR(contact.z, *road.terrain().heightAt({contact.x, contact.y}), kMillimetre);
  }
}

TEST(TeCar, DrivesTheCircleThatItsWheelsAreTurnedTo) {
  TeTestRoad road(kFlat);
  road.start({0, 0});
  ASSERT_TRUE(road.car().setSteering(-1));
  road.drive(1);
  ASSERT_EQ(road.car().steeringTangent(), TeCarGeometry::kSteering);
  // The middle of the rear axle goes round a centre to its left.
  const double radius = TeCarGeometry::kWheelbase / TeCarGeometry::kSteering;
  const glm::dvec2 centre(-radius, -0.5 * TeCarGeometry::kWheelbase);
  ASSERT_TRUE(road.car().setThrottle(0.1));
  for (int i = 0; i < 300; ++i) {
    road.step(0.02);
    const TeCar& car = road.car();
    const glm::dvec3 forward = car.orientation() * glm::dvec3(0, 1, 0);
    const glm::dvec2 axle(car.position() - 0.5 * TeCarGeometry::kWheelbase * forward);
    EXPECT_NEAR(glm::length(axle - centre), radius, 0.02);
  }
  EXPECT_GT(road.car().distanceDriven(), 5);
}

TEST(TeCar, FastCarsSteerLess) {
  TeTestRoad road(kFlat);
  road.start({0, 0});
  ASSERT_TRUE(road.car().setVelocity({0, 25, 0}));
  ASSERT_TRUE(road.car().setThrottle(0.5));
  ASSERT_TRUE(road.car().setSteering(1));
  road.drive(2);
  const double speed = road.car().speed();
  const double sideways = speed * speed * -road.car().steeringTangent() / TeCarGeometry::kWheelbase;
  EXPECT_GT(sideways, 0.5 * TeCar::kSideways);
  EXPECT_LE(sideways, 1.01 * TeCar::kSideways);
}

TEST(TeCar, KeysDrive) {
  TeTestRoad road(kFlat);
  road.start({0, 0});
  TeCar& car = road.car();
  EXPECT_FALSE(car.handleEvent(keyEvent(SoKeyboardEvent::F1, true)));
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::UP_ARROW, true)));
  road.drive(2);
  const double fast = car.speed();
  EXPECT_GT(fast, 5);
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::W, true)));
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::UP_ARROW, false)));
  road.drive(0.5);
  EXPECT_GT(car.speed(), fast) << "the other key for the same is still held";
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::W, false)));
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::S, true)));
  road.drive(0.5);
  EXPECT_LT(car.speed(), fast);
  EXPECT_GT(car.speed(), 0) << "brakes first";
  road.drive(4);
  EXPECT_LT(car.speed(), -3) << "then drives in reverse";
  EXPECT_GE(car.speed(), -TeDriveTrain::kReverseSpeed - 0.1);
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::S, false)));
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::SPACE, true)));
  road.drive(3);
  EXPECT_EQ(car.speed(), 0);
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::SPACE, false)));
  EXPECT_FALSE(car.moving());
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::LEFT_ARROW, true)));
  road.drive(1);
  EXPECT_GT(car.steeringTangent(), 0.3);
  EXPECT_TRUE(car.handleEvent(keyEvent(SoKeyboardEvent::LEFT_ARROW, false)));
  road.drive(1);
  EXPECT_EQ(car.steeringTangent(), 0);
}

TEST(TeCar, AKeyTakesOverFromTheAutomaticDriver) {
  TeTestRoad road(kFlat);
  road.start({0, 0});
  road.car().setAuto(true);
  road.drive(3);
  EXPECT_GT(road.car().speed(), 5);
  EXPECT_TRUE(road.car().handleEvent(keyEvent(SoKeyboardEvent::UP_ARROW, false)));
  EXPECT_TRUE(road.car().isAuto());
  EXPECT_TRUE(road.car().handleEvent(keyEvent(SoKeyboardEvent::SPACE, true)));
  EXPECT_FALSE(road.car().isAuto());
  road.drive(5);
  EXPECT_EQ(road.car().speed(), 0);
  EXPECT_TRUE(road.car().handleEvent(keyEvent(SoKeyboardEvent::T, true)));
  EXPECT_TRUE(road.car().handleEvent(keyEvent(SoKeyboardEvent::T, false)));
  EXPECT_TRUE(road.car().isAuto());
  road.drive(3);
  EXPECT_GT(road.car().speed(), 5);
}

TEST(TeCar, ALostKeyboardReleasesItsKeys) {
  TeTestRoad road(kFlat);
  road.start({0, 0});
  road.car().handleEvent(keyEvent(SoKeyboardEvent::UP_ARROW, true));
  road.drive(1);
  road.car().releaseKeys();
  road.drive(10);
  EXPECT_FALSE(road.car().moving());
  ASSERT_TRUE(road.car().setThrottle(0.5));
  road.car().releaseKeys();
  road.drive(1);
  EXPECT_GT(road.car().speed(), 1) << "what a program has set is no key";
}

TEST(TeCar, SettersSayWhatTheyRefuse) {
  TeTestRoad road(kFlat);
  TeCar& car = road.car();
  EXPECT_FALSE(car.setThrottle(NAN));
  EXPECT_FALSE(car.setSteering(INFINITY));
  EXPECT_FALSE(car.setVelocity({0, NAN, 0}));
  EXPECT_FALSE(car.setPosition({INFINITY, 0, 0}));
  EXPECT_TRUE(car.setThrottle(7));
  EXPECT_TRUE(car.setVelocity({1e300, 1e300, 0}));
  road.drive(0.2);
  EXPECT_TRUE(std::isfinite(car.position().y));
  EXPECT_LE(car.speed(), 100);
}

TEST(TeCar, PlaceHeadingAndSpeedCanBeSet) {
  TeTestRoad road("noise");
  road.start({40, -8}, {1, 0});
  ASSERT_TRUE(road.car().setVelocity({6, 6, 0}));
  road.step(1e-3);
  const glm::dvec3 forward = road.car().orientation() * glm::dvec3(0, 1, 0);
  EXPECT_GT(forward.x, 0.8);
  EXPECT_NEAR(forward.y, 0, 1e-9);
  EXPECT_NEAR(road.car().speed(), 6, 1) << "only the part along the heading";
  EXPECT_NEAR(road.car().position().x, 40, 0.01);
  EXPECT_LE(road.worstGap, kMillimetre);
}

TEST(TeCar, EqualDrivesHaveEqualHashes) {
  const auto hashes = [](double steering) {
    TeTestRoad road("noise");
    road.start({0, 0});
    EXPECT_TRUE(road.car().setThrottle(0.5));
    EXPECT_TRUE(road.car().setSteering(steering));
    std::vector<std::uint64_t> all;
    for (int i = 0; i < 60; ++i) {
      road.step(1.0 / 30);
      all.push_back(road.car().stateHash());
    }
    return all;
  };
  const auto first = hashes(0.25);
  EXPECT_EQ(first, hashes(0.25));
  const auto other = hashes(0.5);
  for (std::size_t i = 0; i < first.size(); ++i)
    EXPECT_NE(first[i], other[i]) << i;
}

TEST(TeCar, HashesTellTurnedWheelsApart) {
  TeTestRoad a(kFlat), b(kFlat);
  for (TeTestRoad* road : {&a, &b})
    road->start({0, 0});
  ASSERT_TRUE(b.car().setSteering(1));
  a.step(0.02);
  b.step(0.02);
  EXPECT_TRUE(samePlace(a.car(), b.car().position(), b.car().orientation()));
  EXPECT_NE(a.car().stateHash(), b.car().stateHash());
}

TEST(TeCar, ItsModelStandsOnItsWheels) {
  SoDB::init();
  TeTestRoad road("noise");
  road.start({13, 5});
  road.step(0.01);
  SoNode* model = road.car().drawModel();
  ASSERT_NE(model, nullptr);
  const auto lowest = [&] {
    SoGetBoundingBoxAction action(SbViewportRegion(1, 1));
    action.apply(model);
    return double(action.getBoundingBox().getMin()[2]);
  };
  for (int i = 0; i < 4; ++i) {
    double travel = INFINITY;
    for (int wheel = 0; wheel < TeCarGeometry::kWheels; ++wheel)
      travel = std::min(travel, road.car().travel(wheel));
    // The box of a lying cylinder that is turned about its axle is a little larger than the cylinder.
    EXPECT_LE(lowest(), travel + 1e-3);
    EXPECT_GE(lowest(), travel - 0.45 * TeCarGeometry::kWheelRadius);
    road.start({13.0 + 9 * i, 5});
    road.step(0.01);
  }
  const auto id = model->getNodeId();
  road.step(0.01);
  EXPECT_EQ(model->getNodeId(), id) << "a car at rest leaves the scene alone";
  ASSERT_TRUE(road.car().setThrottle(1));
  road.drive(0.5);
  EXPECT_NE(model->getNodeId(), id);
}

// Far away from the active object the engine keeps only the patches that an object needs.
TEST(TeCar, GroundComesToItsWheelsWhereverItDrives) {
  TeEndlessWorld world;
  ASSERT_TRUE(world.engine.setGenerator("noise"));
  auto* car = static_cast<TeCar*>(world.engine.addObject(std::make_unique<TeCar>("car")));
  ASSERT_TRUE(car->setPosition({5000, -7000, 0}));
  ASSERT_TRUE(world.engine.initialize()) << world.engine.lastError();
  car->setAuto(true);
  double worstGap = 0;
  for (int i = 0; i < 600; ++i) {
    ASSERT_TRUE(world.engine.timeTick(1.0 / 30));
    for (int wheel = 0; wheel < TeCarGeometry::kWheels && car->distanceDriven() > 0; ++wheel) {
      const glm::dvec3 contact = car->wheelContact(wheel);
      const auto ground = world.engine.getDatabase()->heightAt({contact.x, contact.y});
      ASSERT_TRUE(ground) << i;
      worstGap = std::max(worstGap, std::fabs(contact.z - *ground));
    }
  }
  EXPECT_GT(car->distanceDriven(), 100);
  EXPECT_LE(worstGap, kMillimetre);
}

TEST(TeCar, TheAutomaticDriverKeepsGoing) {
  for (const char* generator : {"noise", "circles"}) {
    TeTestRoad road(generator);
    road.start({0, 0});
    road.car().setAuto(true);
    road.drive(60);
    std::printf("%s: %.0f m in a minute\n", generator, road.car().distanceDriven());
    EXPECT_GT(road.car().distanceDriven(), 250) << generator;
    EXPECT_LE(road.worstGap, kMillimetre);
  }
}

} // namespace
