#include "generators/base/TeHash.h"
#include "generators/base/TeRandom.h"
#include "generators/elevation/TeElevationSource.h"
#include "generators/elevation/TeGdal.h"
#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

// Posts in degrees, brought to a plane and interpolated: the same bits with every compiler, optimisation and
// mathematics library, and whatever floating-point state the caller left.
TEST(HardCase, BitsElevation) {
  if (const auto gdal = TeGdal::module(); !gdal)
    GTEST_SKIP() << gdal.error().message;
  const TeTestFolder folder;
  TeTestRaster raster{200, 200, {}};
  TeRandom random(17, 17, {});
  for (int i = 0; i < 200 * 200; ++i)
    raster.samples.push_back(double(random.below(3000)));
  TeTestTiff tiff;
  tiff.geographic = 4326;
  tiff.step = 1.0 / 1200;
  tiff.west = -121.9;
  tiff.north = 46.9;
  const std::string path = folder.write("a.tif", teTiff(raster, tiff));

  const TeLattice lattice = *TeLattice::create(65, 71.3);
  const auto hashes = [&] {
    const auto source = TeElevationSource::create(*TeElevationFile::open(path), {});
    std::uint64_t hash = 0;
    for (std::int64_t y = -1; y <= 1; ++y)
      for (std::int64_t x = -1; x <= 1; ++x) {
        const TeHeightMap map = *(*source)->generate(TeMapRequest::sourceMap(lattice, 0, {x, y}));
        hash = teHashBytes(map.data(), map.bytes(), hash);
      }
    return hash;
  };
  const std::uint64_t hash = hashes();
  std::printf("nine maps from posts in degrees: %016" PRIx64 "\n", hash);
  EXPECT_EQ(hash, 0x2aebf824267e6fceull);
#if defined(__SSE2__)
  const unsigned before = _mm_getcsr();
  for (unsigned state : {0x8040u, 0x2000u}) { // denormals to zero, in and out; round down
    _mm_setcsr(before | state);
    const std::uint64_t inThatState = hashes();
    _mm_setcsr(before);
    EXPECT_EQ(inThatState, hash) << state;
  }
#endif
}
