#include "generators/elevation/TeElevationSource.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeRandom.h"
#include "generators/elevation/TeElevationGenerator.h"
#include "generators/elevation/TeElevationScan.h"
#include "generators/elevation/TeGdal.h"
#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"
#include "tests/generators/mapsInParts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <thread>

namespace {

class ElevationSource : public ::testing::Test {
protected:
  void SetUp() override {
    if (const auto gdal = TeGdal::module(); !gdal)
      GTEST_SKIP() << gdal.error().message;
  }

  /// Hills of some hundred metres, rough enough that no two posts agree.
  static TeTestRaster hills(int columns, int rows) {
    TeTestRaster raster{columns, rows, {}};
    TeRandom random(9, 9, {});
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        raster.samples.push_back(double(random.below(900)) + c % 50);
    return raster;
  }

  /// Hills of 300×260 posts 1/1200 of a degree apart; single precision.
  TeElevationFilePtr degrees(int fillDistance = 0) {
    TeTestTiff tiff;
    tiff.sample = TeTestSample::Float32;
    tiff.step = 1.0 / 1200;
    tiff.geographic = 4326;
    tiff.west = -121.9;
    tiff.north = 46.9;
    tiff.noData = "-9999";
    TeTestRaster raster = hills(300, 260);
    for (int i = 0; i < 40; ++i)
      raster.samples[std::size_t(i * 1931 + 17)] = -9999;
    TeElevationOptions options;
    options.fillDistance = fillDistance;
    return *TeElevationFile::open(folder.write("degrees.tif", teTiff(raster, tiff)), options);
  }

  /// The same in UTM, posts 30 m apart, without voids.
  TeElevationFilePtr metres(const TeTestRaster& raster) {
    TeTestTiff tiff;
    tiff.step = 30;
    tiff.projected = 32611;
    tiff.west = 400000;
    tiff.north = 3800000;
    return *TeElevationFile::open(folder.write("metres.tif", teTiff(raster, tiff)));
  }

  TeHeightSourcePtr source(const TeElevationFilePtr& file, const TeElevationPlacement& placement = {}) {
    auto source = TeElevationSource::create(file, placement);
    EXPECT_TRUE(source) << (source ? "" : source.error().message);
    return source ? *source : nullptr;
  }

  TeTestFolder folder;
};

bool sameBits(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }

} // namespace

TEST_F(ElevationSource, MapsAgreeWhereTheyOverlapAndWithScatteredPoints) {
  const TeHeightSourcePtr elevation = source(degrees());
  EXPECT_TRUE(elevation->fits());
  EXPECT_TRUE(elevation->pointEvaluable());
  const TeLattice lattice = *TeLattice::create(33, 41.7);
  const auto map = [&](std::int64_t x, std::int64_t y) {
    return *elevation->generate(TeMapRequest::sourceMap(lattice, 0, {x, y}));
  };
  std::int64_t compared = 0;
  std::int64_t present = 0;
  for (std::int64_t y = -3; y < 4; ++y)
    for (std::int64_t x = -3; x < 4; ++x) {
      const TeHeightMap here = map(x, y);
      const TeHeightMap east = map(x + 1, y);
      const TeHeightMap north = map(x, y + 1);
      for (int i = 0; i < 33; ++i)
        for (int j = 0; j <= 16; ++j, ++compared) {
          ASSERT_TRUE(sameBits(here.at(j + 16, i), east.at(j, i)));
          ASSERT_TRUE(sameBits(here.at(i, j + 16), north.at(i, j)));
        }
      const TeMapRequest request = TeMapRequest::sourceMap(lattice, 77, {x, y});
      TeRandom random(1, 5, {x, y});
      std::vector<TeMapSample> samples(100);
      for (TeMapSample& s : samples)
        s = {int(random.below(33)), int(random.below(33))};
      std::vector<float> heights(samples.size());
      ASSERT_TRUE(elevation->evaluate(request, samples.data(), samples.size(), heights.data()));
      for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_TRUE(sameBits(heights[i], here.at(samples[i].column, samples[i].row)));
        present += !TeHeightMap::isMissing(heights[i]);
      }
    }
  std::printf("%lld overlapping samples equal; %lld of 4900 scattered ones present\n",
              static_cast<long long>(compared), static_cast<long long>(present));
  EXPECT_GT(present, 3000);
}

TEST_F(ElevationSource, AnySlicingGivesTheSameBits) {
  const TeHeightSourcePtr elevation = source(degrees(20));
  const TeMapRequest request = TeMapRequest::sourceMap(*TeLattice::create(65, 55), 0, {1, 0});
  const TeHeightMap whole = *elevation->generate(request);
  for (int units : {1, 2, 7})
    expectMapInSlices(*elevation, request, units, whole);
}

TEST_F(ElevationSource, ManyThreadsShareOneFile) {
  const TeElevationFilePtr file = degrees(20);
  const TeHeightSourcePtr elevation = source(file);
  const TeLattice lattice = *TeLattice::create(65, 30);
  std::vector<TeHeightMap> maps(8);
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&, t] {
      maps[std::size_t(t)] = *elevation->generate(TeMapRequest::sourceMap(lattice, 0, {t % 4 - 2, 0}));
    });
  for (std::thread& thread : threads)
    thread.join();
  for (int t = 0; t < 4; ++t)
    EXPECT_EQ(maps[std::size_t(t)], maps[std::size_t(t) + 4]);
}

TEST_F(ElevationSource, SamplesLieWhereTheirPlaceOnTheEarthIs) {
  const TeElevationFilePtr file = degrees();
  const TeMapRequest request = TeMapRequest::sourceMap(*TeLattice::create(33, 200), 0, {0, 0});
  const TeHeightMap map = *source(file)->generate(request);
  int compared = 0;
  for (int y = 0; y < 33; ++y)
    for (int x = 0; x < 33; ++x) {
      if (TeHeightMap::isMissing(map.at(x, y)))
        continue;
      const TeGeographicPosition place = *file->toGeographic({request.x(x), request.y(y)});
      // Interpolated by hand in degrees; the first post lies half a step inside the tie point.
      const double u = (place.longitude + 121.9) * 1200 - 0.5;
      const double v = (46.9 - place.latitude) * 1200 - 0.5;
      const int c = int(std::floor(u));
      const int r = int(std::floor(v));
      if (c < 0 || r < 0 || c + 1 >= file->columns() || r + 1 >= file->rows())
        continue;
      const double north = (1 - (u - c)) * *file->post(c, r) + (u - c) * *file->post(c + 1, r);
      const double south = (1 - (u - c)) * *file->post(c, r + 1) + (u - c) * *file->post(c + 1, r + 1);
      EXPECT_NEAR(map.at(x, y), (1 - (v - r)) * north + (v - r) * south, 0.01);
      ++compared;
    }
  EXPECT_GT(compared, 500);
}

TEST_F(ElevationSource, NativeSamplesAreTheFilesPostsWithTheHighestAtTheOrigin) {
  TeTestRaster raster = hills(80, 60);
  raster.samples[20 * 80 + 31] = 5000;
  const TeElevationFilePtr file = metres(raster);
  TeElevationPlacement placement;
  placement.native = true;
  placement.nativeColumn = 31;
  placement.nativeRow = 20;
  const TeHeightSourcePtr native = source(file, placement);
  for (int samples : {17, 19}) {
    const TeMapRequest request = TeMapRequest::sourceMap(*TeLattice::create(samples, 30), 0, {0, 0});
    const TeHeightMap map = *native->generate(request);
    bool found = false;
    for (int y = 0; y < samples; ++y)
      for (int x = 0; x < samples; ++x) {
        const int column = 31 + int(std::floor(request.x(x) / 30 + 0.5));
        const int row = 20 - int(std::floor(request.y(y) / 30 + 0.5));
        ASSERT_EQ(map.at(x, y), float(raster.at(column, row)));
        found = found || map.at(x, y) == 5000;
      }
    EXPECT_TRUE(found);
  }
  const auto wrong = native->generate(TeMapRequest::sourceMap(*TeLattice::create(17, 31), 0, {0, 0}));
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("30.0"), std::string::npos) << wrong.error().message;
  EXPECT_FALSE(TeElevationSource::create(degrees(), placement));
}

TEST_F(ElevationSource, OutsideTheFileStandsWhatWasAskedFor) {
  const TeTestRaster raster = hills(40, 40);
  const TeElevationFilePtr file = metres(raster);
  const TeLattice lattice = *TeLattice::create(9, 30);
  const TeMapRequest inside = TeMapRequest::sourceMap(lattice, 5, {0, 0});
  const TeMapRequest outside = TeMapRequest::sourceMap(lattice, 5, {100, 3});
  const TeMapRequest beyondTheEarth = TeMapRequest::sourceMap(lattice, 5, {std::int64_t(1) << 40, 0});
  const TeHeightSourcePtr hole = source(file);
  EXPECT_EQ(hole->generate(inside)->statistics().missing, 0);
  EXPECT_EQ(hole->generate(outside)->statistics().present, 0);

  TeElevationPlacement placement;
  placement.outside = TeElevationOutside::Constant;
  placement.outsideHeight = -12.5f;
  EXPECT_EQ(source(file, placement)->generate(outside)->statistics().maximum, -12.5f);

  placement.outside = TeElevationOutside::Clamp;
  for (const TeElevationFilePtr& f : {file, degrees(50)})
    for (const TeMapRequest& request : {outside, beyondTheEarth}) {
      const TeMapStatistics clamped = source(f, placement)->generate(request)->statistics();
      EXPECT_EQ(clamped.missing, 0);
      EXPECT_GE(clamped.minimum, 0);
      EXPECT_LE(clamped.maximum, 1000);
    }

  const TeHeightSourcePtr faults = *TeGeneratorRegistry::instance().source("faults");
  placement.outside = TeElevationOutside::Generator;
  EXPECT_FALSE(TeElevationSource::create(file, placement));
  placement.outsideSource = faults;
  const TeHeightSourcePtr both = source(file, placement);
  EXPECT_EQ(*both->generate(outside), *faults->generate(outside));
  EXPECT_EQ(*both->generate(inside), *hole->generate(inside));
  EXPECT_FALSE(both->fits());
  EXPECT_NE(both->fingerprint(), hole->fingerprint());
}

TEST_F(ElevationSource, VoidsFilledInTilesHaveTheBitsOfTheWholeFilledAtOnce) {
  // Voids across the borders of tiles (512 posts) and in their corner.
  const int side = 700;
  TeTestRaster raster = hills(side, side);
  std::vector<float> whole;
  TeRandom random(4, 4, {});
  for (int i = 0; i < 60; ++i) {
    const int column = 480 + int(random.below(64));
    const int row = int(random.below(side - 8));
    for (int r = 0; r < 8; ++r)
      for (int c = 0; c < 8; ++c) {
        raster.samples[std::size_t(row + r) * side + std::size_t(column + c)] = -32768;
        raster.samples[std::size_t(column + c) * side + std::size_t(row + r)] = -32768;
      }
  }
  for (double sample : raster.samples)
    whole.push_back(sample == -32768 ? TeHeightMap::missing() : float(sample));
  ASSERT_TRUE((*TeGdal::module())->fillVoids(whole.data(), side, side, 30));

  TeElevationOptions options;
  options.fillDistance = 30;
  const std::string path = folder.write("a.tif", teTiff(raster, {}));
  const TeElevationFilePtr file = *TeElevationFile::open(path, options);
  int filled = 0;
  for (int r = side - 1; r >= 0; --r)
    for (int c = 0; c < side; ++c) {
      ASSERT_TRUE(sameBits(*file->post(c, r), whole[std::size_t(r) * side + std::size_t(c)]))
          << c << "," << r;
      filled += raster.at(c, r) == -32768;
      ASSERT_FALSE(TeHeightMap::isMissing(*file->post(c, r)));
    }
  std::printf("%d voids filled with the same bits\n", filled);
}

TEST_F(ElevationSource, TheScanFindsTheHighestPostInAnySlicing) {
  TeTestRaster raster = hills(300, 200);
  raster.samples[150 * 300 + 7] = raster.samples[90 * 300 + 280] = 4000;
  raster.samples[5] = -32768;
  const TeElevationFilePtr file = metres(raster);
  TeElevationScan scan(file);
  int slices = 1;
  for (TeAllowance one = TeAllowance::units(1); scan.step(one) == TeProgress::Working; ++slices)
    one = TeAllowance::units(1);
  EXPECT_EQ(slices, 6);
  EXPECT_EQ(scan.summary().maximum, 4000);
  EXPECT_EQ(scan.summary().highestColumn, 280);
  EXPECT_EQ(scan.summary().highestRow, 90);
  EXPECT_EQ(scan.summary().missing, 1);
  EXPECT_EQ(scan.summary().present, 300 * 200 - 1);
  EXPECT_EQ(TeElevationScan::summarise(file)->highestColumn, 280);
}

TEST_F(ElevationSource, IsAGeneratorWithParameters) {
  TeTestRaster raster = hills(40, 40);
  raster.samples[10 * 40 + 30] = 3000;
  const std::string path = metres(raster)->path();
  TeElevationGenerator generator;
  EXPECT_FALSE(generator.updateParams());
  generator.file = path;
  ASSERT_TRUE(generator.start(TeMapRequest::sourceMap(*TeLattice::create(9, 30), 0, {0, 0})));
  const TeElevationFilePtr opened = generator.elevationFile();
  ASSERT_TRUE(generator.generate());
  EXPECT_EQ(generator.takeMap().statistics().missing, 0);
  generator.native = true;
  ASSERT_TRUE(generator.start(TeMapRequest::sourceMap(*TeLattice::create(9, 30), 0, {0, 0})));
  EXPECT_EQ(generator.elevationFile(), opened) << "read again for nothing";
  ASSERT_TRUE(generator.generate());
  EXPECT_EQ(generator.takeMap().at(6, 6), 3000);
  generator.native = false;
  generator.fill = "voids";
  ASSERT_TRUE(generator.updateParams());
  EXPECT_NE(generator.elevationFile(), opened);
}

TEST_F(ElevationSource, SpecificationsAreCheckedInOneLine) {
  const std::string path = metres(hills(10, 10))->path();
  TeGeneratorRegistry& registry = TeGeneratorRegistry::instance();
  for (const char* right :
       {"vertical-unit=ft", "fill=voids,fill-distance=5", "outside=clamp",
        "outside=constant,outside-height=-3", "outside=generator,outside-generator=faults",
        "origin=south-west", "origin=\"-118.08,34.33\"", "native=on", "no-data=\"0, 999\"", "posts=10",
        "horizontal-unit=feet"}) {
    const auto source = registry.source("elevation:file=" + path + "," + right);
    EXPECT_TRUE(source) << right << ": " << (source ? "" : source.error().message);
  }
  for (const char* wrong : {"vertical-unit=furlong",
                            "fill=everything",
                            "fill-distance=0",
                            "outside=sea",
                            "outside-height=nan",
                            "outside=generator",
                            "outside=generator,outside-generator=nothing",
                            "outside=generator,outside-generator=joined",
                            "origin=here",
                            "origin=\"1,2,3\"",
                            "origin=\"0,91\"",
                            "posts=-1",
                            "posts=nan",
                            "no-data=x",
                            "band=7",
                            "encoding=raw",
                            "encoding=raw,raw-size=0x4",
                            "encoding=raw,raw-size=4",
                            "encoding=raw,raw-size=-1x1",
                            "encoding=terrarium",
                            "variable=z",
                            "native=perhaps",
                            "colour=red"}) {
    const auto source = registry.source("elevation:file=" + path + "," + wrong);
    ASSERT_FALSE(source) << wrong;
    EXPECT_EQ(source.error().message.find('\n'), std::string::npos);
  }
}
