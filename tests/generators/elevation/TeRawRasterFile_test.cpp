#include "generators/elevation/TeRawRasterFile.h"

#include "generators/elevation/TeElevationFile.h"
#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <thread>
#include <vector>

namespace {

TeElevationOptions raw(int columns, int rows) {
  TeElevationOptions options;
  options.encoding = TeElevationEncoding::Raw;
  options.rawColumns = columns;
  options.rawRows = rows;
  return options;
}

} // namespace

TEST(TeRawRasterFile, ReadsBothByteOrdersAndSigns) {
  const TeTestFolder folder;
  const TeTestRaster raster{3, 2, {1, -2, 300, -400, 32767, -32767}};
  TeElevationOptions options = raw(3, 2);
  for (bool bigEndian : {false, true}) {
    options.rawBigEndian = bigEndian;
    const auto file = TeElevationFile::open(folder.write("a.raw", teRaw(raster, bigEndian)), options);
    ASSERT_TRUE(file) << file.error().message;
    for (int i = 0; i < 6; ++i)
      EXPECT_EQ(*(*file)->post(i % 3, i / 3), float(raster.samples[std::size_t(i)]));
  }
  options.rawSigned = false;
  EXPECT_EQ(*(*TeElevationFile::open(folder.path("a.raw"), options))->post(1, 0), 65534);
}

TEST(TeRawRasterFile, RefusesAnotherSizeThanTheFiles) {
  const TeTestFolder folder;
  const std::string path = folder.write("a.raw", std::string(12, 'x'));
  EXPECT_TRUE(TeElevationFile::open(path, raw(3, 2)));
  for (const TeElevationOptions& wrong :
       {raw(3, 3), raw(3, 1), raw(0, 2), raw(-3, -2), raw(2147483647, 2147483647)}) {
    const auto file = TeElevationFile::open(path, wrong);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().message.compare(0, path.size(), path), 0) << file.error().message;
  }
}

TEST(TeRawRasterFile, AFileThatShrinksIsAnErrorAndNoCrash) {
  const TeTestFolder folder;
  const std::string path = folder.write("a.raw", std::string(2 * 300 * 300, 'x'));
  const auto file = TeElevationFile::open(path, raw(300, 300));
  ASSERT_TRUE(file);
  EXPECT_TRUE((*file)->post(0, 0));
  ASSERT_EQ(truncate(path.c_str(), 1000), 0);
  EXPECT_FALSE((*file)->post(299, 299));
}

TEST(TeRawRasterFile, KeepsAtMost64MegabytesOfPosts) {
  const TeTestFolder folder;
  const std::string path = folder.write("big.raw", "");
  ASSERT_EQ(truncate(path.c_str(), 72000000), 0);
  const auto file = TeElevationFile::open(path, raw(6000, 6000));
  ASSERT_TRUE(file);
  std::size_t most = 0;
  for (int r = 0; r < 6000; r += 64)
    for (int c = 0; c < 6000; c += 64) {
      ASSERT_EQ(*(*file)->post(c, r), 0);
      most = std::max(most, (*file)->tiles().cachedBytes());
    }
  std::printf("144 MB of posts read, at most %zu MB kept\n", most >> 20);
  EXPECT_LE(most, TeElevationTiles::kCacheBytes);
  EXPECT_GT(most, TeElevationTiles::kCacheBytes / 2);
}

TEST(TeRawRasterFile, ManyThreadsShareOneFile) {
  const TeTestFolder folder;
  const std::string path = folder.write("a.raw", teRaw(TeTestRaster::ramp(600, 500), false));
  const auto file = TeElevationFile::open(path, raw(600, 500));
  ASSERT_TRUE(file) << file.error().message;
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 600 * 500; i += 97) {
        const int at = (i + t * 75000) % (600 * 500);
        const TeResult<float> height = (*file)->post(at % 600, at / 600);
        wrong += !height || *height != float(100 + 10 * (at / 600) + at % 600);
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(wrong, 0);
}
