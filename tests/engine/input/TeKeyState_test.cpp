#include "engine/input/TeKeyState.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using Key = SoKeyboardEvent::Key;

TEST(TeKeyState, RepetitionsSayNothingNew) {
  TeKeyState keys;
  EXPECT_FALSE(keys.any());
  EXPECT_FALSE(keys.change({Key::A, false})) << "it was not down";
  EXPECT_TRUE(keys.change({Key::A, true}));
  EXPECT_FALSE(keys.change({Key::A, true}));
  EXPECT_FALSE(keys.change({Key::A, true, true})) << "nor with another modifier";
  EXPECT_TRUE(keys.isDown(Key::A));
  EXPECT_TRUE(keys.change({Key::A, false}));
  EXPECT_FALSE(keys.isDown(Key::A));
}

TEST(TeKeyState, HoldsManyKeysInOrder) {
  TeKeyState keys;
  for (const Key key : {Key::UP_ARROW, Key::A, Key::PAD_8, Key::SPACE})
    EXPECT_TRUE(keys.change({key, true}));
  EXPECT_THAT(keys.down(), testing::ElementsAre(Key::SPACE, Key::A, Key::UP_ARROW, Key::PAD_8));
  EXPECT_TRUE(keys.change({Key::A, false}));
  EXPECT_FALSE(keys.isDown(Key::A));
  EXPECT_TRUE(keys.isDown(Key::PAD_8));
  keys.clear();
  EXPECT_FALSE(keys.any());
  EXPECT_TRUE(keys.change({Key::PAD_8, true}));
}

} // namespace
