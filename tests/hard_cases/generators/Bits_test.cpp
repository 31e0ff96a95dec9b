#include "tests/hard_cases/generators/TeGoldenHashes.h"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <cstring>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

// The golden bits with this build's compiler and options; bits.sh tries others.
TEST(HardCase, Bits) {
  int chains = 0;
  for (const TeChainUnderTest& chain : teEveryGenerator()) {
    const std::uint64_t hash = teHashOf(chain);
    char line[120];
    std::snprintf(line, sizeof line, "{\"%s\", 0x%016" PRIX64 "},", chain.name().c_str(), hash);
    EXPECT_NE(hash, 0u) << chain.name() << ": no map";
    EXPECT_EQ(hash, teGoldenHashOf(chain)) << "goldenHashes.h should have, if the change is meant:\n" << line;
    ++chains;
  }
  std::printf("%d generators and chains have their golden bits\n", chains);
}

#if defined(__x86_64__)
// A host that flushes denormals to zero, or rounds in another direction, must not change the terrain.
TEST(HardCase, BitsGeneratorsInAHostileHost) {
  const unsigned before = _mm_getcsr();
  constexpr unsigned kFlushAndDenormalsAreZero = 0x8040;
  constexpr unsigned kRoundDown = 0x2000;
  constexpr unsigned kFlags = 0x3F; // of exceptions that happened
  const TeLattice lattice = TeLattice::create(33, 7.5).value();
  std::vector<TeMapSample> samples;
  for (int i = 0; i < 33; ++i)
    samples.push_back({i, (i * 5) % 33});
  std::vector<float> heights(samples.size());
  for (unsigned state : {kFlushAndDenormalsAreZero, kRoundDown})
    for (const TeChainUnderTest& chain : teEveryGenerator()) {
      const auto source = TeGeneratorRegistry::instance().source(chain.generator, chain.filters).value();
      for (const TeMapKey& key :
           {TeMapKey{0, 0}, TeMapKey{-3, 7}, TeMapKey{(std::int64_t(1) << 40) + 5, -7}}) {
        const TeMapRequest request = TeMapRequest::sourceMap(lattice, 2007, key);
        const TeHeightMap expected = source->generate(request).value();
        _mm_setcsr(before | state);
        const auto map = source->generate(request);
        const bool points = source->evaluate(request, samples.data(), samples.size(), heights.data()).ok();
        const unsigned after = _mm_getcsr();
        _mm_setcsr(before);
        EXPECT_EQ(after & ~kFlags, (before | state) & ~kFlags) << "the host's state is not given back";
        ASSERT_TRUE(map.ok());
        EXPECT_TRUE(*map == expected) << chain.name() << " with MXCSR bits " << state;
        for (std::size_t i = 0; points && i < samples.size(); ++i)
          ASSERT_EQ(0,
                    std::memcmp(&heights[i], &expected.row(samples[i].row)[samples[i].column], sizeof(float)))
              << chain.name() << " at points with MXCSR bits " << state;
      }
    }
}
#endif
