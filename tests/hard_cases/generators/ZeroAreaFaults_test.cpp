#include "generators/faults/TeFaultFormation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

// Two equal points make no line. On a map of one sample, 256×256 places for a point, every 65,536th pair is
// one, and every 256th lies along the row: all must make a fault, and the job must end.
TEST(HardCase, ZeroAreaFaults) {
  TeFaultParameters parameters;
  parameters.faults = 100000;
  std::int64_t coincident = 0;
  std::int64_t level = 0;
  for (const char* profile : {"step", "smooth"}) {
    parameters.profile = profile;
    const auto source = *TeFaultFormation::create(parameters);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const TeMapRequest request = *TeMapRequest::standalone(1, 1, 1.0, seed);
      const TeRandom random = source->random(request);
      for (int f = 0; f < source->faults(); ++f) {
        const TeFaultLine line = source->line(request, random, f);
        ASSERT_NE(line.ay, line.by);
        // What was moved is seen from where it came: one step north of the first point's row.
        const bool moved = line.by == line.ay + 1;
        level += moved ? 1 : 0;
        coincident += moved && line.ax == line.bx ? 1 : 0;
        ASSERT_GT(source->plane(request, random, f).east, 0);
      }
      const TeHeightMap map = *source->generate(request);
      EXPECT_TRUE(std::isfinite(map.at(0, 0)));
    }
  }
  EXPECT_GT(coincident, 0);
  std::printf(
      "ZeroAreaFaults: 1,000,000 faults, %lld of points in or next to one row, %lld of points one above "
      "the other or the same: all made\n",
      static_cast<long long>(level), static_cast<long long>(coincident));
}
