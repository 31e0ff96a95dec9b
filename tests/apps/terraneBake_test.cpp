// terrane-bake: pyramids from every kind of input, what it refuses, interruptions, and synthetic terrain.

#include "apps/TeAppRun.h"
#include "generators/elevation/TeTestFolder.h"
#include "generators/elevation/TeTestRasters.h"
#include "nodes/clipmap/TePyramidFiles.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

namespace fs = std::filesystem;

namespace {

TeTestRaster hills(int columns, int rows, double lowest = 0, double factor = 1) {
  TeTestRaster raster{columns, rows, {}};
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      raster.samples.push_back(lowest + factor * ((x * 37 + y * 101) % 4099 + x + 3 * y));
  return raster;
}

class TerraneBake : public TeAppRun {
protected:
  TerraneBake() : TeAppRun("terrane-bake") {}

  std::string put(const std::string& name, const std::string& bytes) const {
    const std::string path = scratch(name);
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  TeChildResult bake(const std::string& input, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"mipmaps", input,      scratch("out"),
                                          "--quiet", "--report", scratch("report.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  std::string level(int number) const { return tePyramidLevelFile(scratch("out"), number); }
  nlohmann::json json(const std::string& name) const {
    std::ifstream stream(scratch(name));
    return nlohmann::json::parse(stream, nullptr, false);
  }
  int sample(int number, int column, int row) const {
    const std::string bytes = teReadFile(level(number));
    const std::size_t at = 2 * (std::size_t(row) * std::size_t(tePyramidSide(number)) + std::size_t(column));
    return at + 1 < bytes.size()
               ? static_cast<unsigned char>(bytes[at]) + 256 * static_cast<unsigned char>(bytes[at + 1])
               : -1;
  }
  /// Levels 0 .. top are there and are decimations of `samples`, whose side is 2^top + 1.
  void expectLevels(const std::string& samples, int top, int sampleBytes = 2) const {
    const std::size_t side = std::size_t(tePyramidSide(top));
    ASSERT_EQ(samples.size(), side * side * sampleBytes);
    for (int number = 0; number <= top; ++number) {
      const std::size_t step = std::size_t(1) << (top - number);
      std::string wanted;
      for (std::size_t row = 0; row < side; row += step)
        for (std::size_t column = 0; column < side; column += step)
          wanted += samples.substr((row * side + column) * sampleBytes, sampleBytes);
      EXPECT_TRUE(teReadFile(level(number)) == wanted) << level(number);
    }
    EXPECT_FALSE(fs::exists(level(top + 1)));
    EXPECT_FALSE(fs::exists(scratch("out.journal")));
    for (const auto& entry : fs::directory_iterator(scratch("")))
      EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
  void removeOutput() const {
    for (const auto& entry : fs::directory_iterator(scratch("")))
      if (entry.path().filename().string().rfind("out", 0) == 0)
        fs::remove(entry.path());
  }
};

TEST_F(TerraneBake, HelpAndVersionSucceed) {
  const TeChildResult help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* word : {"mipmaps", "synth", "--report", "--quiet", "--seed"})
    EXPECT_NE(help.output.find(word), std::string::npos) << word;
  EXPECT_EQ(help.output.find("--context"), std::string::npos);
  const TeChildResult mipmaps = run({"mipmaps", "--help"});
  EXPECT_EQ(mipmaps.status, 0);
  for (const char* word : {"--force", "--raw-order", "--no-data", "--fill", "--resample", "--no-bounds",
                           "--min-resolution", "--levels", "--posts", "--vertical-unit"})
    EXPECT_NE(mipmaps.output.find(word), std::string::npos) << word;
  const TeChildResult version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.output.rfind("terrane-bake 0.", 0), 0u) << version.output;
}

TEST_F(TerraneBake, BadUsage) {
  expectRefused({}, 2, "subcommand");
  expectRefused({"mipmaps"}, 2, "IN");
  expectRefused({"mipmaps", "a.raw"}, 2, "OUT");
  expectRefused({"mipmaps", "a.raw", ""}, 2, "OUT");
  expectRefused({"synth"}, 2, "OUT");
  expectRefused({"bake", "a.raw", "b"}, 2, "bake");
  expectRefused({"mipmaps", "a.raw", "b", "--no-such"}, 2, "--no-such");
  for (const char* bad : {"0", "-1", "1024", "1026", "nan", "x", "131073", "99999999999999999999"})
    expectRefused({"synth", scratch("a.raw"), "--size", bad}, 2, "--size");
  const std::string raw = put("in.raw", teRaw(hills(33, 33), false));
  for (const char* bad : {"nan", "inf", "x", ""})
    expectRefused({"mipmaps", raw, scratch("out"), "--fill", bad}, 2, "--fill");
  expectRefused({"mipmaps", raw, scratch("out"), "--min-resolution", "15"}, 2, "15");
  expectRefused({"mipmaps", raw, scratch("out"), "--levels", "1"}, 2, "--levels");
  expectRefused({"mipmaps", raw, scratch("out"), "--posts", "-3"}, 2, "--posts");
  expectRefused({"mipmaps", raw, scratch("out"), "--vertical-unit", "furlong"}, 2, "furlong");
  expectRefused({"mipmaps", raw, scratch("out"), "--raw-order", "middle"}, 2, "--raw-order");
  EXPECT_FALSE(fs::exists(level(0)));
}

TEST_F(TerraneBake, RawBecomesItsDecimations) {
  for (int top : {1, 2, 7, 8}) {
    const std::string little = teRaw(hills(tePyramidSide(top), tePyramidSide(top)), false);
    const std::string raw = put("in.raw", little);
    const TeChildResult result = bake(raw);
    ASSERT_EQ(result.status, 0) << result.error;
    EXPECT_EQ(result.output + result.error, "");
    expectLevels(little, top);
    EXPECT_EQ(json("out.json")["levels"], top + 1);
    EXPECT_EQ(json("out.json")["height_unit_m"], 1);
    removeOutput();
  }
}

TEST_F(TerraneBake, RawOfAnotherByteOrderAndSign) {
  const std::string little = teRaw(hills(129, 129), false);
  const std::string big = put("in.bin", teRaw(hills(129, 129), true));
  ASSERT_EQ(bake(big, {"--raw", "--raw-order", "big"}).status, 0);
  expectLevels(little, 7);
  removeOutput();
  // Below sea level: the lowest becomes 0, and the description says where that is.
  const std::string deep = put("in.raw", teRaw(hills(129, 129, -3000), false));
  ASSERT_EQ(bake(deep, {"--raw-samples", "signed"}).status, 0);
  expectLevels(little, 7);
  EXPECT_EQ(json("out.json")["height_offset_m"], -3000);
}

TEST_F(TerraneBake, PngAndGeoTiffAsTheyAre) {
  const TeTestRaster raster = hills(129, 129);
  const std::string wanted = teRaw(raster, false);
  ASSERT_EQ(bake(put("in.png", tePng16(raster)), {"--vertical-unit", "dm", "--posts", "160"}).status, 0);
  expectLevels(wanted, 7);
  EXPECT_DOUBLE_EQ(json("out.json")["height_unit_m"], 0.1);
  EXPECT_DOUBLE_EQ(json("out.json")["spacing_m"], 160);
  removeOutput();
  TeTestTiff tiff;
  tiff.sample = TeTestSample::UInt16;
  tiff.step = 10;
  tiff.projected = 32611;
  ASSERT_EQ(bake(put("in.tif", teTiff(raster, tiff))).status, 0);
  expectLevels(wanted, 7);
  EXPECT_DOUBLE_EQ(json("out.json")["spacing_m"], 10);
  EXPECT_EQ(json("out.json")["kind"], "height");
}

TEST_F(TerraneBake, HeightsThatAreNotWholeAreSpreadOver16Bits) {
  TeTestTiff tiff;
  tiff.sample = TeTestSample::Float32;
  const TeTestRaster raster = hills(33, 33, -100.5, 0.25);
  ASSERT_EQ(bake(put("in.tif", teTiff(raster, tiff))).status, 0);
  const double unit = json("out.json")["height_unit_m"];
  const double offset = json("out.json")["height_offset_m"];
  EXPECT_DOUBLE_EQ(offset, -100.5);
  EXPECT_GT(unit, 0);
  double worst = 0;
  for (int row = 0; row < 33; ++row)
    for (int column = 0; column < 33; ++column)
      worst = std::max(worst, std::fabs(offset + unit * sample(5, column, row) - raster.at(column, row)));
  EXPECT_LE(worst, 0.5001 * unit);
}

TEST_F(TerraneBake, MissingSamplesAreAnErrorOrFilled) {
  TeTestRaster raster = hills(33, 33);
  raster.samples[5 * 33 + 7] = -9999;
  TeTestTiff tiff;
  tiff.noData = "-9999";
  const std::string path = put("in.tif", teTiff(raster, tiff));
  expectRefused({"mipmaps", path, scratch("out")}, 2, "column 7, row 5");
  EXPECT_FALSE(fs::exists(level(5)));
  EXPECT_FALSE(fs::exists(scratch("out.journal")));
  ASSERT_EQ(bake(path, {"--fill", "12"}).status, 0);
  EXPECT_EQ(sample(5, 7, 5), 12);
  EXPECT_EQ(sample(5, 8, 5), int(raster.at(8, 5)));
  const std::string raw = put("in.raw", teRaw(hills(33, 33), false));
  ASSERT_EQ(bake(raw, {"--no-data", "0", "--fill", "5", "--force"}).status, 0);
  EXPECT_EQ(sample(5, 0, 0), 5);
}

TEST_F(TerraneBake, OtherSizesAreRefusedOrResampled) {
  const std::string raw = put("in.raw", teRaw(hills(100, 100), false));
  expectRefused({"mipmaps", raw, scratch("out")}, 2, "100x100");
  // On a plane bilinear interpolation has no error but the rounding.
  TeTestRaster plane{100, 100, {}};
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column)
      plane.samples.push_back(1000 + 50 * column + 20 * row);
  ASSERT_EQ(bake(put("plane.raw", teRaw(plane, false)), {"--resample", "--posts", "30"}).status, 0);
  const double step = 99.0 / 128;
  for (int row = 0; row < 129; row += 16)
    for (int column = 0; column < 129; column += 16)
      EXPECT_NEAR(sample(7, column, row), 1000 + step * (50 * column + 20 * row), 0.5001);
  EXPECT_DOUBLE_EQ(json("out.json")["spacing_m"], 30 * step);
  removeOutput();

  const std::string oblong = put("in.png", tePng16(hills(65, 33)));
  expectRefused({"mipmaps", oblong, scratch("out"), "--resample"}, 2, "--fill");
  ASSERT_EQ(bake(oblong, {"--resample", "--fill", "7"}).status, 0);
  EXPECT_EQ(sample(6, 10, 15), 7);
  EXPECT_EQ(sample(6, 10, 16), int(hills(65, 33).at(10, 0)));
  EXPECT_EQ(sample(6, 10, 48), int(hills(65, 33).at(10, 32)));
  EXPECT_EQ(sample(6, 10, 49), 7);
}

TEST_F(TerraneBake, PicturesBecomePyramidsOfColours) {
  TePicture picture;
  picture.width = picture.height = 65;
  std::string wanted;
  for (int row = 0; row < 65; ++row) // a picture's rows begin in the south
    for (int column = 0; column < 65; ++column)
      for (int byte : {column, 64 - row, (column * row) % 256, 255})
        picture.rgba.push_back(static_cast<unsigned char>(byte));
  ASSERT_TRUE(picture.writePng(scratch("in.png")));
  const TeChildResult result = bake(scratch("in.png"));
  ASSERT_EQ(result.status, 0) << result.error;
  const int bytes = json("out.json")["sample_bytes"];
  ASSERT_TRUE(bytes == 3 || bytes == 4);
  for (int row = 64; row >= 0; --row)
    for (int column = 0; column < 65; ++column)
      for (int byte = 0; byte < bytes; ++byte)
        wanted += char(picture.rgba[std::size_t(row * 65 + column) * 4 + std::size_t(byte)]);
  expectLevels(wanted, 6, bytes);
  EXPECT_EQ(json("out.json")["kind"], "colour");
  EXPECT_FALSE(fs::exists(scratch("out_bounds_16_3.bin")));
}

TEST_F(TerraneBake, BoundsAreWrittenUnlessNotWanted) {
  const std::string raw = put("in.raw", teRaw(hills(129, 129), false));
  ASSERT_EQ(bake(raw).status, 0);
  EXPECT_TRUE(fs::exists(scratch("out_bounds_16_3.bin")));
  ASSERT_EQ(bake(raw, {"--force", "--min-resolution", "8", "--levels", "2"}).status, 0);
  EXPECT_TRUE(fs::exists(scratch("out_bounds_8_2.bin")));
  EXPECT_FALSE(fs::exists(scratch("out_bounds_16_3.bin")));
  ASSERT_EQ(bake(raw, {"--force", "--no-bounds"}).status, 0);
  EXPECT_FALSE(fs::exists(scratch("out_bounds_8_2.bin")));
}

TEST_F(TerraneBake, ExistingPyramidsAreKeptUnlessForced) {
  const std::string first = teRaw(hills(65, 65), false), second = teRaw(hills(33, 33, 9), false);
  ASSERT_EQ(bake(put("a.raw", first)).status, 0);
  const std::string other = put("b.raw", second);
  expectRefused({"mipmaps", other, scratch("out")}, 2, "--force");
  expectLevels(first, 6);
  ASSERT_EQ(bake(other, {"--force"}).status, 0);
  expectLevels(second, 5); // and nothing is left of the sixth level
  fs::remove(level(0));
  expectRefused({"mipmaps", other, scratch("out")}, 2, "--force");
}

TEST_F(TerraneBake, ExistingBoundsAndDescriptionsAreKeptUnlessForced) {
  const std::string raw = put("in.raw", teRaw(hills(33, 33), false));
  for (const char* name : {"out_bounds_8_2.bin", "out_bounds_8_2.bin.part", "out.json"}) {
    put(name, "of something else");
    expectRefused({"mipmaps", raw, scratch("out")}, 2, name);
    EXPECT_EQ(teReadFile(scratch(name)), "of something else");
    ASSERT_EQ(bake(raw, {"--force"}).status, 0);
    EXPECT_NE(teReadFile(scratch(name)), "of something else");
    removeOutput();
  }
}

TEST_F(TerraneBake, TheInputIsNeitherReplacedNorRemoved) {
  const std::string whole = teRaw(hills(33, 33), false);
  for (const char* name : {"out_3.raw", "out_5.raw", "out_7.raw", "out_4.raw.part", "out_bounds_8_2.bin"}) {
    const std::string raw = put(name, whole);
    expectRefused({"mipmaps", raw, scratch("out"), "--raw", "--force"}, 2, name);
    EXPECT_TRUE(teReadFile(raw) == whole) << name;
    fs::remove(raw);
  }
}

TEST_F(TerraneBake, BadInput) {
  expectRefused({"mipmaps", "/no/such.raw", scratch("out")}, 2, "/no/such.raw");
  expectRefused({"mipmaps", "/no/such.tif", scratch("out")}, 2, "/no/such.tif");
  expectRefused({"mipmaps", "/tmp", scratch("out")}, 2, "/tmp");
  expectRefused({"mipmaps", "/dev/zero", scratch("out"), "--raw"}, 2, "/dev/zero");
  const std::string whole = teRaw(hills(33, 33), false);
  for (std::size_t bytes : {std::size_t(0), std::size_t(1), std::size_t(2), std::size_t(7), whole.size() - 1,
                            whole.size() - 2, whole.size() / 2})
    expectRefused({"mipmaps", put("short.raw", whole.substr(0, bytes)), scratch("out")}, 2, "short.raw");
  expectRefused({"mipmaps", put("long.raw", whole + "x"), scratch("out")}, 2, "long.raw");
  expectRefused({"mipmaps", put("text.tif", "no elevation data"), scratch("out")}, 2, "text.tif");
  expectRefused({"mipmaps", put("cut.png", tePng16(hills(33, 33)).substr(0, 700)), scratch("out")}, 2,
                "cut.png");
  put("in.raw.json", "{\"spacing_m\": \"wide\"}");
  expectRefused({"mipmaps", put("in.raw", whole), scratch("out")}, 2, "in.raw.json");
  // 8 TB that are not there.
  const std::string huge = scratch("huge.raw");
  std::ofstream(huge).flush();
  if (truncate(huge.c_str(), off_t(2) * 2097153 * 2097153) == 0) {
    expectRefused({"mipmaps", huge, scratch("out")}, 2, "huge.raw");
  }
  for (const auto& entry : fs::directory_iterator(scratch("")))
    EXPECT_NE(entry.path().filename().string().rfind("out", 0), 0u) << entry.path();
}

TEST_F(TerraneBake, WhatCannotBeWrittenIsAFailure) {
  const std::string raw = put("in.raw", teRaw(hills(33, 33), false));
  expectRefused({"mipmaps", raw, "/no/such/folder/out"}, 1, "/no/such/folder/out");
  fs::create_directories(scratch("out_2.raw.part"));
  expectRefused({"mipmaps", raw, scratch("out")}, 1, "out_2.raw");
  EXPECT_FALSE(fs::exists(level(0)));
  expectRefused({"synth", "/no/such/folder/a.raw", "--size", "33"}, 1, "/no/such/folder/a.raw");
  expectRefused({"mipmaps", raw, scratch("fine"), "--quiet", "--report", "/dev/full"}, 1, "/dev/full");
}

TEST_F(TerraneBake, AFullDiskIsOneErrorAndTheNextRunGoesOn) {
  const int top = 12; // the first checkpoint comes after 16 MB
  ASSERT_EQ(run({"synth", scratch("in.raw"), "--size", "4097", "--quiet"}).status, 0);
  // The limit stands for the disk; the signal would kill the program before it could say a word.
  const std::string command = "trap '' XFSZ; ulimit -f 24576; exec " TERRANE_BIN "/terrane-bake mipmaps " +
                              scratch("in.raw") + " " + scratch("out") + " --quiet";
  const TeChildResult full = teRunChild({"bash", "-c", command});
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.errorLines(), 1) << full.error;
  EXPECT_NE(full.error.find("out_12.raw"), std::string::npos) << full.error;
  EXPECT_FALSE(fs::exists(level(0)));
  expectRefused({"mipmaps", scratch("in.raw"), scratch("out"), "--raw-order", "big"}, 2, "out.journal");
  const TeChildResult again = bake(scratch("in.raw"));
  ASSERT_EQ(again.status, 0) << again.error;
  EXPECT_GT(json("report.json")["resumed_from_row"], 1000);
  expectLevels(teReadFile(scratch("in.raw")), top);
}

TEST_F(TerraneBake, AKilledRunIsFinishedByTheNextWithTheSameBytes) {
  ASSERT_EQ(run({"synth", scratch("in.raw"), "--size", "4097", "--quiet"}).status, 0);
  const std::string in = scratch("in.raw"), out = scratch("out");
  int killed = 0;
  for (std::uintmax_t bytes : {0, 1 << 20, 20 << 20}) {
    const pid_t child = fork();
    if (child == 0) {
      execl(TERRANE_BIN "/terrane-bake", "terrane-bake", "mipmaps", in.c_str(), out.c_str(), "--quiet",
            nullptr);
      _exit(127);
    }
    int status = 0;
    std::error_code none;
    const std::string part = level(12) + ".part";
    while (waitpid(child, &status, WNOHANG) == 0)
      if (fs::exists(part, none) && fs::file_size(part, none) >= bytes && !none) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
        break;
      }
    killed += WIFSIGNALED(status);
    if (WIFSIGNALED(status)) {
      EXPECT_FALSE(fs::exists(scratch("out.json")));
    }
  }
  EXPECT_GT(killed, 0);
  const TeChildResult last =
      bake(in, killed == 3 ? std::vector<std::string>() : std::vector<std::string>{"--force"});
  ASSERT_EQ(last.status, 0) << last.error;
  expectLevels(teReadFile(in), 12);
}

TEST_F(TerraneBake, MemoryDoesNotGrowWithTheTerrain) {
  std::vector<double> synth, mipmaps;
  for (const char* side : {"1025", "4097"}) {
    ASSERT_EQ(
        run({"synth", scratch("in.raw"), "--size", side, "--force", "--quiet", "--report", scratch("s.json")})
            .status,
        0);
    synth.push_back(json("s.json")["memory_peak_bytes"].get<double>() / (1 << 20));
    ASSERT_EQ(bake(scratch("in.raw"), {"--force"}).status, 0);
    mipmaps.push_back(json("report.json")["memory_peak_bytes"].get<double>() / (1 << 20));
  }
  std::printf("peak memory, MB, 1025 and 4097 samples a side: synth %.1f and %.1f, mipmaps %.1f and %.1f\n",
              synth[0], synth[1], mipmaps[0], mipmaps[1]);
  for (const std::vector<double>& peak : {synth, mipmaps}) {
    EXPECT_LE(peak[1], 64);
    EXPECT_LE(peak[1], peak[0] + 12);
  }
}

TEST_F(TerraneBake, SyntheticTerrainRepeatsToTheByte) {
  for (const char* name : {"a.raw", "b.raw"})
    ASSERT_EQ(run({"synth", scratch(name), "--size", "513", "--seed", "5", "--quiet"}).status, 0);
  const std::string bytes = teReadFile(scratch("a.raw"));
  EXPECT_EQ(bytes.size(), 2u * 513 * 513);
  EXPECT_TRUE(bytes == teReadFile(scratch("b.raw")));
  EXPECT_DOUBLE_EQ(json("a.raw.json")["spacing_m"], 320);
  EXPECT_DOUBLE_EQ(json("a.raw.json")["height_unit_m"], 0.1);
  expectRefused({"synth", scratch("a.raw"), "--size", "513"}, 2, "--force");
  ASSERT_EQ(run({"synth", scratch("a.raw"), "--size", "513", "--seed", "6", "--quiet", "--force"}).status, 0);
  EXPECT_FALSE(bytes == teReadFile(scratch("a.raw")));

  // On other machines, too.
  ASSERT_EQ(run({"synth", scratch("c.raw"), "--size", "257", "--seed", "1", "--quiet", "--report",
                 scratch("c.json")})
                .status,
            0);
  EXPECT_EQ(json("c.json")["hash"], "4d9975945b95b500");

  // It has a flat sea and mountains.
  int sea = 0, highest = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const int height = static_cast<unsigned char>(bytes[i]) + 256 * static_cast<unsigned char>(bytes[i + 1]);
    sea += height == 0;
    highest = std::max(highest, height);
  }
  EXPECT_GT(sea, 513 * 513 / 20);
  EXPECT_LT(sea, 513 * 513 * 3 / 4);
  EXPECT_GT(highest, 10000);
  // The description is taken over.
  ASSERT_EQ(bake(scratch("b.raw")).status, 0);
  EXPECT_DOUBLE_EQ(json("out.json")["spacing_m"], 320);
  EXPECT_DOUBLE_EQ(json("out.json")["height_unit_m"], 0.1);
}

TEST_F(TerraneBake, SyntheticTerrainFollowsAFile) {
  TeTestRaster island{33, 33, {}};
  for (int row = 0; row < 33; ++row)
    for (int column = 0; column < 33; ++column)
      island.samples.push_back(std::max(0.0, 20000 - 2000 * std::hypot(column - 16, row - 16)));
  const std::string from = put("island.png", tePng16(island));
  ASSERT_EQ(run({"synth", scratch("a.raw"), "--size", "513", "--from", from, "--quiet"}).status, 0);
  const std::string bytes = teReadFile(scratch("a.raw"));
  const auto height = [&](int column, int row) {
    const std::size_t at = 2 * (std::size_t(row) * 513 + std::size_t(column));
    return static_cast<unsigned char>(bytes[at]) + 256 * static_cast<unsigned char>(bytes[at + 1]);
  };
  int differing = 0;
  for (int row = 0; row < 33; ++row)
    for (int column = 0; column < 33; ++column) {
      const double wanted = island.at(column, row);
      EXPECT_NEAR(height(16 * column, 16 * row), wanted, 1500) << column << ", " << row;
      differing += std::fabs(height(16 * column, 16 * row) - wanted) > 10;
      if (std::hypot(column - 16, row - 16) > 13) { // the sea stays flat
        EXPECT_EQ(height(16 * column, 16 * row), 0);
      }
    }
  EXPECT_GT(differing, 100); // there is detail
  expectRefused({"synth", scratch("b.raw"), "--from", "/no/such.png"}, 2, "/no/such.png");
  expectRefused({"synth", scratch("b.raw"), "--from", put("wide.png", tePng16(hills(33, 17)))}, 2, "33x17");
}

TEST_F(TerraneBake, RealData) {
  const std::string puget = data("png16/ps_height_1k.png");
  if (puget.empty())
    GTEST_SKIP() << "no png16/ps_height_1k.png";
  ASSERT_EQ(bake(puget, {"--posts", "160", "--vertical-unit", "0.1"}).status, 0);
  EXPECT_EQ(fs::file_size(level(10)), 2u * 1025 * 1025);
  EXPECT_LE(json("report.json")["memory_peak_bytes"], 64 << 20);
  const std::string tile = data("geotiff/elev16_wgs84_512x512.tif");
  if (!tile.empty()) {
    ASSERT_EQ(bake(tile, {"--resample", "--force"}).status, 0);
  }
}

} // namespace
