#include "engine/objects/TeAircraft.h"
#include "engine/objects/TeObjects.h"
#include "engine/objects/TeTestGround.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

// An aircraft in a climbing turn and a falling stone live through ticks of 0 s, 5 s, 1 h and a year: never
// more than ten steps of 0.1 s each, nowhere that a second of flight does not lead. Times that are none are
// refused and change nothing.
TEST(HardCase, TimeSpikesEngine) {
  const double kInfinity = std::numeric_limits<double>::infinity();
  const auto terrain = teNoGround();
  TeObjects objects;
  auto& aircraft = static_cast<TeAircraft&>(**objects.add(std::make_unique<TeAircraft>("mine")));
  TeObject& stone = **objects.add(std::make_unique<TeObject>("stone"));
  ASSERT_TRUE(aircraft.setVelocity({0, 200, 0}));
  ASSERT_TRUE(stone.setVelocity({0, 0, -9}));
  aircraft.handleEvent({SoKeyboardEvent::E, true});
  aircraft.handleEvent({SoKeyboardEvent::RIGHT_ARROW, true});

  int refused = 0;
  double longest = 0;
  double dropped = 0;
  std::int64_t updates = 0;
  for (const double dt :
       {0.0, 0.016, 5.0, 0.0, 3600.0, 5e-324, 0.033, 3.2e7, std::numeric_limits<double>::max()}) {
    for (const double bad : {-0.001, -3600.0, std::nan(""), kInfinity, -kInfinity}) {
      const std::uint64_t state = objects.stateHash();
      const double time = objects.time();
      ASSERT_FALSE(objects.update(bad, *terrain));
      ASSERT_EQ(objects.stateHash(), state);
      ASSERT_EQ(objects.time(), time);
      ++refused;
    }
    const glm::dvec3 before = aircraft.position();
    const auto tick = objects.update(dt, *terrain);
    ASSERT_TRUE(tick);
    ASSERT_TRUE(tick->errors.empty());
    ASSERT_LE(tick->steps, 10);
    ASSERT_EQ(tick->updates, 2 * tick->steps);
    ASSERT_EQ(tick->simulated, std::min(dt, TeObjects::kLongestTick));
    ASSERT_EQ(tick->dropped, dt - tick->simulated);
    const double moved = glm::length(aircraft.position() - before);
    ASSERT_LE(moved, 200 * tick->simulated + 1e-9) << dt;
    ASSERT_NEAR(aircraft.speed(), 200, 1e-6);
    ASSERT_NEAR(stone.position().z, -9 * objects.time(), 1e-9);
    longest = std::max(longest, moved);
    dropped += dt < 1e8 ? tick->dropped : 0;
    updates += tick->updates;
  }
  std::printf(
      "9 ticks up to 1.8e308 s: %lld updates, at most %.1f m in a tick, %.0f s dropped of the first 8, "
      "%d times refused\n",
      (long long)updates, longest, dropped, refused);
}
