// The code of docs/gradient-noise.md, compiled and run.

#include "generators/TeGeneratorRegistry.h"

#include <gtest/gtest.h>

TEST(GradientNoisePage, MakesOneMapFarOut) {
  //! [map]
  const auto source =
      TeGeneratorRegistry::instance().source("noise:type=ridged,wavelength=800,amplitude=150,octaves=9");
  if (!source)
    return; // source.error().message tells why
  const TeLattice lattice = *TeLattice::create(65, 1.0);
  const TeMapKey farOut{std::int64_t(1) << 40, 0};
  const TeResult<TeHeightMap> map =
      (*source)->generate(TeMapRequest::sourceMap(lattice, /*worldSeed*/ 7, farOut));
  //! [map]
  ASSERT_TRUE(map.ok()) << map.error().message;
  const TeMapStatistics statistics = map->statistics();
  EXPECT_GT(statistics.maximum, statistics.minimum);
  EXPECT_LE(statistics.maximum, 150);
  EXPECT_GE(statistics.minimum, -150);
}
