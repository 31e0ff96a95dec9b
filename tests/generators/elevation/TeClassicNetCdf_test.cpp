#include "generators/elevation/TeClassicNetCdf.h"

#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"

#include <gtest/gtest.h>

namespace {

std::string words(std::initializer_list<std::uint32_t> values) {
  std::string bytes;
  for (std::uint32_t value : values)
    for (int shift = 24; shift >= 0; shift -= 8)
      bytes += char(value >> shift & 0xFF);
  return bytes;
}

/// Variable "z" of 16 bit samples over dimensions "t" (of records) × side × side, its data right behind the
/// header and none there.
std::string recordFile(std::uint32_t records, std::uint32_t side) {
  const std::string t("t\0\0\0", 4), a("a\0\0\0", 4), b("b\0\0\0", 4), z("z\0\0\0", 4);
  return "CDF\1" + words({records, 10, 3, 1}) + t + words({0, 1}) + a + words({side, 1}) + b + words({side}) +
         words({0, 0, 11, 1, 1}) + z + words({3, 0, 1, 2, 0, 0, 3, 0, 112});
}

} // namespace

TEST(TeClassicNetCdf, AFileIsAsLongAsItsVariablesOrCutOff) {
  const TeTestFolder folder;
  const std::string whole = teNetCdf(TeTestRaster::ramp(5, 4), 10, 50, 0.01, "m", -1, 1);
  EXPECT_TRUE(teCheckClassicNetCdf(folder.write("a.nc", whole)));
  EXPECT_FALSE(teCheckClassicNetCdf(folder.write("b.nc", whole.substr(0, whole.size() - 1))));
  EXPECT_FALSE(teCheckClassicNetCdf(folder.write("c.nc", whole.substr(0, 40))));

  const std::string records = recordFile(2, 6);
  EXPECT_TRUE(teCheckClassicNetCdf(folder.write("d.nc", records + std::string(144, 'x'))));
  EXPECT_FALSE(teCheckClassicNetCdf(folder.write("e.nc", records + std::string(143, 'x'))));
  EXPECT_TRUE(teCheckClassicNetCdf(folder.write("f.nc", recordFile(0, 6))));
}

// Two records of 2^63 bytes are more than 64 bits count, and no file has them.
TEST(TeClassicNetCdf, SizesBeyond64BitsDoNotWrapRound) {
  const TeTestFolder folder;
  for (std::uint32_t records : {1u, 2u, 3u, 4u})
    for (std::uint32_t side : {0x40000000u, 0x80000000u, 0xFFFFFFFFu}) {
      const std::string file = folder.write("a.nc", recordFile(records, side) + std::string(1000, 'x'));
      EXPECT_FALSE(teCheckClassicNetCdf(file)) << records << " " << side;
    }
}
