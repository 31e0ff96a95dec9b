#include "engine/input/TeKeyNames.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using Key = SoKeyboardEvent::Key;

TEST(TeKeyNames, AreThoseOfInventor) {
  EXPECT_EQ(teKeyName(Key::A), "A");
  EXPECT_EQ(teKeyName(Key::Z), "Z");
  EXPECT_EQ(teKeyName(Key::NUMBER_7), "7");
  EXPECT_EQ(teKeyName(Key::F12), "F12");
  EXPECT_EQ(teKeyName(Key::PAD_8), "PAD_8");
  EXPECT_EQ(teKeyName(Key::UP_ARROW), "UP_ARROW");
  EXPECT_EQ(teKeyName(Key(0x1a2b)), "0x1a2b");
}

TEST(TeKeyNames, EveryKeyIsFoundByItsNameAlone) {
  std::set<std::string> names;
  for (int code = 0; code <= 0xFFFF; ++code) {
    const std::string name = teKeyName(Key(code));
    ASSERT_EQ(teKeyNamed(name), Key(code)) << name;
    ASSERT_TRUE(names.insert(name).second) << name;
    ASSERT_EQ(name.find_first_of(" /+-"), std::string::npos) << name;
  }
}

TEST(TeKeyNames, OtherTextIsNoKey) {
  for (const char* text : {"", "a", "AA", "F0", "F13", "F01", "0x61", "0x1A2B", "0x01a2b", "0x10000", "0x",
                           "PAD_", "pad_8", "10", " A", "A ", "F1x"})
    EXPECT_FALSE(teKeyNamed(text)) << text;
}

} // namespace
