#include "engine/TeStateHash.h"

#include <gtest/gtest.h>

namespace {

TEST(TeStateHash, EqualStatesHaveEqualHashes) {
  EXPECT_EQ(teHashState(1, 0.0), teHashState(1, -0.0));
  EXPECT_EQ(teHashState(1, glm::dvec3(0.0, -0.0, 2)), teHashState(1, glm::dvec3(-0.0, 0.0, 2)));
  TeKeyState first, second;
  for (const auto key : {SoKeyboardEvent::A, SoKeyboardEvent::B})
    first.change({key, true});
  for (const auto key : {SoKeyboardEvent::B, SoKeyboardEvent::C, SoKeyboardEvent::A})
    second.change({key, true});
  EXPECT_NE(teHashState(1, first), teHashState(1, second));
  second.change({SoKeyboardEvent::C, false});
  EXPECT_EQ(teHashState(1, first), teHashState(1, second)) << "in whatever order keys went down";
}

TEST(TeStateHash, EveryPartCounts) {
  EXPECT_NE(teHashState(1, glm::dvec3(1, 2, 3)), teHashState(1, glm::dvec3(1, 3, 2)));
  EXPECT_NE(teHashState(1, glm::dquat(1, 0, 0, 0)), teHashState(1, glm::dquat(0, 1, 0, 0)));
  EXPECT_NE(teHashState(1, glm::dquat(1, 0, 0, 0)), teHashState(1, glm::dquat(1, 0, 0, 1e-9)));
}

} // namespace
