#include "generators/TeHeightMap.h"
#include "generators/base/TeRandom.h"
#include "generators/elevation/TeElevationScan.h"
#include "generators/elevation/TeElevationSource.h"
#include "generators/elevation/TeGdal.h"
#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"
#include "hard_cases/generators/TeChildRun.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>

namespace {

enum Outcome { kValid = 0, kError = 1, kWrong = 2 };

/// Opens a file and does with it what a program does: looks for its highest post, and makes maps with and
/// without filled voids. Wrong = a height that is none.
Outcome use(const std::string& path) {
  for (int fill : {0, 20}) {
    TeElevationOptions options;
    options.fillDistance = fill;
    const auto file = TeElevationFile::open(path, options);
    if (!file)
      return file.error().message.find('\n') == std::string::npos ? kError : kWrong;
    const auto source = TeElevationSource::create(*file, {});
    const auto spacing = (*file)->coveringSpacing(1, 65);
    if (!source || !spacing)
      return kWrong;
    const auto map =
        (*source)->generate(TeMapRequest::sourceMap(*TeLattice::create(65, *spacing), 0, {0, 0}));
    if (!map)
      return kError;
    for (int y = 0; y < map->height(); ++y)
      for (int x = 0; x < map->width(); ++x)
        if (!TeHeightMap::isMissing(map->at(x, y)) && !(std::fabs(map->at(x, y)) <= 100000))
          return kWrong;
    if (!TeElevationScan::summarise(*file))
      return kError;
  }
  return kValid;
}

/// All posts of a file, or nothing if it is an error.
std::optional<std::vector<float>> posts(const std::string& path) {
  const auto file = TeElevationFile::open(path);
  if (!file)
    return {};
  std::vector<float> heights;
  for (int r = 0; r < (*file)->rows(); ++r)
    for (int c = 0; c < (*file)->columns(); ++c) {
      const auto height = (*file)->post(c, r);
      if (!height)
        return {};
      heights.push_back(*height);
    }
  return heights;
}

std::string patched(std::string bytes, std::size_t at, std::uint64_t value, int count, bool big) {
  for (int i = 0; i < count; ++i)
    bytes[at + std::size_t(i)] = char(value >> (8 * (big ? count - 1 - i : i)));
  return bytes;
}

/// Replaces the value of a TIFF's tag (in its first directory, if it is held there).
std::string patchedTag(std::string bytes, int tag, std::uint32_t value) {
  const auto number = [&bytes](std::size_t at, int count) {
    std::uint32_t n = 0;
    for (int i = 0; i < count; ++i)
      n |= std::uint32_t(static_cast<unsigned char>(bytes[at + std::size_t(i)])) << (8 * i);
    return n;
  };
  const std::size_t directory = number(4, 4);
  for (std::size_t i = 0; i < number(directory, 2); ++i)
    if (const std::size_t entry = directory + 2 + 12 * i; number(entry, 2) == std::uint32_t(tag))
      return patched(std::move(bytes), entry + 8, value, 4, false);
  return bytes;
}

/// Files that claim to be huge, negative or nothing.
void writeHostileFiles(const TeTestFolder& folder, std::vector<std::string>& paths) {
  const TeTestRaster ramp = TeTestRaster::ramp(7, 5);
  const auto add = [&](const std::string& name, const std::string& bytes) {
    paths.push_back(folder.write(name, bytes));
  };
  const std::uint64_t sizes[] = {0, 1, 8, 65536, 100000, 0x3fffffff, 0x7fffffff, 0xffffffff};
  int n = 0;
  for (std::uint64_t a : sizes)
    for (std::uint64_t b : {std::uint64_t(5), a}) {
      const std::string mark = std::to_string(n++);
      const std::string tiff = teTiff(ramp, {});
      add("width" + mark + ".tif",
          patchedTag(patchedTag(tiff, 256, std::uint32_t(a)), 257, std::uint32_t(b)));
      add("strip" + mark + ".tif",
          patchedTag(patchedTag(tiff, 257, std::uint32_t(a)), 278, std::uint32_t(b)));
      add("width" + mark + ".bt",
          patched(patched(teBinaryTerrain(ramp, 0, 0, 30), 10, a, 4, false), 14, b, 4, false));
      add("size" + mark + ".png", patched(patched(tePng16(ramp), 16, a, 4, true), 20, b, 4, true));
      add("size" + mark + ".nc",
          patched(patched(teNetCdf(ramp, 0, 0, 1, "m", -1, 1), 24, a, 4, true), 36, b, 4, true));
      const auto text = std::to_string(std::int64_t(a) - 1);
      add("size" + mark + ".asc", "ncols " + text + "\nnrows " + std::to_string(b) +
                                      "\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n4 5 6\n");
      add("size" + mark + ".dem", teUsgsDem(ramp, 399990, 3799980, 30, std::int64_t(a % 1000000) - 1));
    }
  add("sparse.tif",
      patchedTag(patchedTag(patchedTag(teTiff(ramp, {}), 256, 100000), 257, 100000), 278, 100000));
  add("cell.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize nan\n1 2 3\n4 5 6\n");
  add("digits.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n" + std::string(20 << 20, '1'));
  add("blank.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n" + std::string(20 << 20, ' '));
  add("line.asc", "ncols " + std::string(20 << 20, '1'));
  add("step.dem", teUsgsDem(ramp, 0, 0, 1e-30, 7));
  add("steps.dem", teUsgsDem(ramp, -1e300, 1e300, 1e290, 7));
}

/// Sanitizers keep memory of their own, several times the program's.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr long kMostKilobytes = 4 * 1024 * 1024;
#else
constexpr long kMostKilobytes = 512 * 1024;
#endif

bool haveGdal() { return TeGdal::module().ok(); }

} // namespace

// Malformed and hostile files: an error or a valid map, in under 10 s and 512 MB each.
TEST(HardCase, BadDem) {
  if (!haveGdal())
    GTEST_SKIP() << "no GDAL";
  const TeTestFolder folder;
  std::vector<std::string> paths;
  writeHostileFiles(folder, paths);
  const std::size_t made = paths.size();
  if (const std::string data = teTestData("malformed"); !data.empty())
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data))
      if (entry.is_regular_file())
        paths.push_back(entry.path().string());

  int valid = 0;
  double slowest = 0;
  long largest = 0;
  std::string slowestName;
  std::string largestName;
  for (const std::string& path : paths) {
    const TeChildRun run = TeChildRun::of([&path] { return int(use(path)); }, 10);
    EXPECT_TRUE(run.status == kValid || run.status == kError)
        << path << ": status " << run.status << ", signal " << run.signal << ", " << run.seconds << " s";
    EXPECT_LT(run.peakKilobytes, kMostKilobytes) << path;
    valid += run.status == kValid;
    if (run.seconds > slowest) {
      slowest = run.seconds;
      slowestName = path.substr(path.rfind('/') + 1);
    }
    if (run.peakKilobytes > largest) {
      largest = run.peakKilobytes;
      largestName = path.substr(path.rfind('/') + 1);
    }
  }
  std::printf("%zu files (%zu of them made here): %d valid maps, %zu errors; longest %.2f s (%s), "
              "most memory %ld MB (%s)\n",
              paths.size(), made, valid, paths.size() - std::size_t(valid), slowest, slowestName.c_str(),
              largest / 1024, largestName.c_str());
}

// Every prefix of a file is an error or has the whole file's posts: what is cut off is never made up.
TEST(HardCase, BadDemPrefixes) {
  if (!haveGdal())
    GTEST_SKIP() << "no GDAL";
  const TeTestFolder folder;
  const TeTestRaster ramp = TeTestRaster::ramp(7, 5);
  TeTestTiff geographic;
  geographic.geographic = 4326;
  geographic.step = 0.01;
  geographic.noData = "-9999";
  const struct {
    std::string name, bytes;
    std::size_t step;
  } files[] = {{"a.tif", teTiff(ramp, geographic), 1},
               {"a.asc", teAsciiGrid(ramp, 30, "-9999"), 1},
               {"a.bt", teBinaryTerrain(ramp, 400000, 3800000, 30), 1},
               {"a.png", tePng16(ramp), 1},
               {"a.nc", teNetCdf(ramp, 10, 50, 0.01, "m", -1, 1), 1},
               {"a.dem", teUsgsDem(ramp, 399990, 3799980, 30, 7), 61}};
  for (const auto& f : files) {
    const auto whole = posts(folder.write(f.name, f.bytes));
    ASSERT_TRUE(whole) << f.name;
    int errors = 0;
    int same = 0;
    int lastCut = 0;
    for (std::size_t length = 0; length < f.bytes.size(); length += f.step) {
      const auto cut = posts(folder.write(f.name, f.bytes.substr(0, length)));
      if (!cut) {
        ++errors;
        continue;
      }
      ASSERT_EQ(cut->size(), whole->size()) << f.name << " cut to " << length;
      const bool text = f.name == "a.asc" || f.name == "a.dem";
      const std::size_t differing =
          std::size_t(std::mismatch(cut->begin(), cut->end(), whole->begin()).first - cut->begin());
      // A number in text is a number also when its last digits are cut off.
      if (differing == cut->size())
        ++same;
      else if (text && differing + 1 == cut->size())
        ++lastCut;
      else
        ADD_FAILURE() << f.name << " cut to " << length << " of " << f.bytes.size() << ": post " << differing
                      << " is " << (*cut)[differing];
    }
    std::printf("%s: %zu bytes: %d prefixes are errors, %d the whole map, %d with the last number cut\n",
                f.name.c_str(), f.bytes.size(), errors, same, lastCut);
  }
}

// An SRTM tile has no header: only its size tells that it is whole.
TEST(HardCase, BadDemTruncatedHgt) {
  if (!haveGdal())
    GTEST_SKIP() << "no GDAL";
  const TeTestFolder folder;
  const std::string path = folder.write("N46W122.hgt", teHgt(TeTestRaster::ramp(1201, 1201)));
  ASSERT_TRUE(TeElevationFile::open(path));
  std::set<std::int64_t> cuts;
  const std::int64_t row = 2 * 1201;
  for (std::int64_t i = 0; i < 4096; ++i)
    cuts.insert(i);
  for (std::int64_t r = 1; r <= 1201; ++r)
    for (std::int64_t around : {-1, 0, 1})
      cuts.insert(r * row + around);
  cuts.erase(1201 * row);
  cuts.erase(1201 * row + 1);
  TeRandom random(7, 7, {});
  for (int i = 0; i < 1000; ++i)
    cuts.insert(std::int64_t(random.below(std::uint64_t(1201 * row))));
  int refused = 0;
  for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut) {
    ASSERT_EQ(truncate(path.c_str(), *cut), 0);
    const auto file = TeElevationFile::open(path);
    EXPECT_FALSE(file) << *cut;
    refused += !file;
  }
  std::printf("%zu cuts of an SRTM tile, %d refused\n", cuts.size(), refused);
}

// Files with a few wrong bytes: whatever they say, an error or a valid map.
TEST(HardCase, BadDemMutations) {
  if (!haveGdal())
    GTEST_SKIP() << "no GDAL";
  const TeTestFolder folder;
  const TeTestRaster ramp = TeTestRaster::ramp(7, 5);
  TeTestTiff geographic;
  geographic.geographic = 4326;
  geographic.step = 0.01;
  const struct {
    std::string name, bytes;
  } files[] = {{"a.tif", teTiff(ramp, geographic)},
               {"a.asc", teAsciiGrid(ramp, 30, "-9999")},
               {"a.bt", teBinaryTerrain(ramp, 400000, 3800000, 30)},
               {"a.png", tePng16(ramp)},
               {"a.nc", teNetCdf(ramp, 10, 50, 0.01, "m", -1, 1)},
               {"a.dem", teUsgsDem(ramp, 399990, 3799980, 30, 7).substr(0, 3 * 1024)}};
  constexpr int kMutations = 150;
  double slowest = 0;
  long largest = 0;
  for (const auto& f : files) {
    const auto mutate = [&](int from, int to) {
      for (int i = from; i < to; ++i) {
        TeRandom random(std::uint64_t(i), 8, {});
        std::string bytes = f.bytes;
        for (std::uint64_t k = 0; k <= random.below(3); ++k)
          bytes[random.below(bytes.size())] = char(random.below(256));
        if (use(folder.write(f.name, bytes)) == kWrong)
          return int(kWrong);
      }
      return int(kValid);
    };
    const TeChildRun run = TeChildRun::of([&] { return mutate(0, kMutations); }, 60);
    slowest = std::max(slowest, run.seconds);
    largest = std::max(largest, run.peakKilobytes);
    EXPECT_EQ(run.status, kValid) << f.name << ": signal " << run.signal << " after " << run.seconds << " s";
    EXPECT_LT(run.peakKilobytes, kMostKilobytes) << f.name;
  }
  std::printf("%d mutations of each of %zu formats: at most %.1f s together, %ld MB\n", kMutations,
              std::size(files), slowest, largest / 1024);
}
