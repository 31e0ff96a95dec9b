#include "generators/base/TeText.h"

#include <gtest/gtest.h>

namespace {

TEST(TeText, IsFormattedAsByPrintfHoweverLong) {
  EXPECT_EQ(teFormat("%+.1f m, %s, %lld", -2.25, "north", 5LL), "-2.2 m, north, 5");
  EXPECT_EQ(teFormat("%.1f", 1e300).size(), 303u) << "however long";
  EXPECT_EQ(teFormat("%s %d", std::string(1000, 'x').c_str(), 7), std::string(1000, 'x') + " 7");
}

TEST(TeText, HexadecimalNumbersHaveAllTheirDigits) {
  EXPECT_EQ(teHexText(0), "0000000000000000");
  EXPECT_EQ(teHexText(0xFEDCBA9876543210), "fedcba9876543210");
}

} // namespace
