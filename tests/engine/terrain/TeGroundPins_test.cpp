#include "engine/terrain/TeGroundPins.h"

#include "engine/objects/TeObject.h"

#include <gtest/gtest.h>

namespace {

const TeLattice kLattice = *TeLattice::create(65, 1.0);

struct Thing : TeObject {
  Thing() : TeObject("thing") {}
};

TEST(TeGroundPins, APatchIsHeldAsLongAsAnyObjectIsOverIt) {
  TeGroundPins pins;
  Thing a, b;
  EXPECT_TRUE(pins.place(a, kLattice));
  EXPECT_TRUE(pins.place(b, kLattice));
  EXPECT_FALSE(pins.place(a, kLattice)) << "it has not moved";
  EXPECT_TRUE(pins.holds({0, 0, 0}));

  ASSERT_TRUE(a.setPosition({40, 0, 0}));
  EXPECT_TRUE(pins.place(a, kLattice));
  EXPECT_TRUE(pins.holds({1, 0, 0}));
  EXPECT_TRUE(pins.holds({0, 0, 0})) << "the other one is still there";
  pins.remove(b);
  EXPECT_FALSE(pins.holds({0, 0, 0}));
  pins.remove(a);
  pins.remove(a);
  EXPECT_FALSE(pins.holds({1, 0, 0}));
}

TEST(TeGroundPins, AMovingObjectHoldsThePatchThatItWillBeOver) {
  TeGroundPins pins;
  Thing thing;
  ASSERT_TRUE(thing.setVelocity({0, 60, 0}));
  pins.place(thing, kLattice);
  EXPECT_TRUE(pins.holds({0, 0, 0}));
  EXPECT_TRUE(pins.holds({0, 1, 0})) << "on the way";
  EXPECT_TRUE(pins.holds({0, 2, 0}));
}

// A car near a corner of its patch has wheels on four.
TEST(TeGroundPins, AllPatchesThatAnObjectStandsOnAreHeld) {
  struct Wide : TeObject {
    Wide() : TeObject("wide") {}
    double groundReach() const override { return 2; }
  };
  TeGroundPins pins;
  Wide wide;
  ASSERT_TRUE(wide.setPosition({15, -15, 0}));
  pins.place(wide, kLattice);
  for (const TePatchKey key :
       {TePatchKey{0, 0, 0}, TePatchKey{1, 0, 0}, TePatchKey{0, -1, 0}, TePatchKey{1, -1, 0}})
    EXPECT_TRUE(pins.holds(key)) << key.text();
  ASSERT_TRUE(wide.setPosition({0, -15, 0}));
  EXPECT_TRUE(pins.place(wide, kLattice));
  EXPECT_FALSE(pins.holds({1, 0, 0}));
  EXPECT_TRUE(pins.holds({0, -1, 0}));
  pins.remove(wide);
  EXPECT_FALSE(pins.holds({0, 0, 0}));
}

TEST(TeGroundPins, HoweverFastItHoldsFewPatches) {
  TeGroundPins pins;
  Thing thing;
  for (const double speed : {1e3, 1e9, 1e200}) {
    ASSERT_TRUE(thing.setVelocity({speed, 0, 0}));
    pins.place(thing, kLattice);
    int held = 0;
    pins.forEach([&held](const TePatchKey&) { ++held; });
    EXPECT_GE(held, 1) << speed;
    EXPECT_LE(held, 2 * TeGroundPins::kPatchesAhead + 1) << speed;
  }
}

TEST(TeGroundPins, OutsideTheWorldNothingIsHeld) {
  TeGroundPins pins;
  Thing thing;
  pins.place(thing, kLattice);
  ASSERT_TRUE(thing.setPosition({1e300, 0, 0}));
  EXPECT_TRUE(pins.place(thing, kLattice));
  EXPECT_FALSE(pins.holds({0, 0, 0}));
}

} // namespace
