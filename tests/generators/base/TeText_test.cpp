#include "generators/base/TeText.h"

#include <gtest/gtest.h>

namespace {

TEST(TeText, IsFormattedAsByPrintfAndCutNotOverrun) {
  EXPECT_EQ(teFormat("%+.1f m, %s, %lld", -2.25, "north", 5LL), "-2.2 m, north, 5");
  EXPECT_EQ(teFormat("%f", 1e300).size(), std::size_t(kTeMostFormatted));
}

TEST(TeText, HexadecimalNumbersHaveAllTheirDigits) {
  EXPECT_EQ(teHexText(0), "0000000000000000");
  EXPECT_EQ(teHexText(0xFEDCBA9876543210), "fedcba9876543210");
}

} // namespace
