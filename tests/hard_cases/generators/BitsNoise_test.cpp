#include "generators/base/TeHash.h"
#include "generators/noise/TeNoiseSource.h"

#include <gtest/gtest.h>

#include <cstdio>

// The same land from every compiler, optimisation and processor: worlds are stored as seeds.
TEST(HardCase, BitsNoise) {
  const std::uint64_t expected[] = {0xce25189e54443bb4, 0x6f5ca715d3e400c8, 0x5ce44a1b15e63f17};
  const TeLattice lattice = *TeLattice::create(65, 1.0);
  for (TeNoiseType type : {TeNoiseType::Fbm, TeNoiseType::Ridged, TeNoiseType::Warp})
    for (const TeNoiseKernel& kernel : TeNoiseKernel::available()) {
      TeNoiseSettings settings;
      settings.type = type;
      std::uint64_t hash = 0;
      for (std::int64_t key : {std::int64_t(0), std::int64_t(-1), std::int64_t(1) << 40}) {
        const TeMapRequest request = TeMapRequest::sourceMap(lattice, 2026, {key, -3 * key});
        const TeHeightMap map = *(*TeNoiseSource::create(settings, kernel))->generate(request);
        for (int y = 0; y < map.height(); ++y)
          for (int x = 0; x < map.width(); ++x)
            hash = teHashDouble(hash, double(map.at(x, y)));
      }
      std::printf("noise type %d, %s: %016llx\n", int(type), kernel.name,
                  static_cast<unsigned long long>(hash));
      EXPECT_EQ(hash, expected[int(type)]);
    }
}
