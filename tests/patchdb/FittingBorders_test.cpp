#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeRandom.h"
#include "patchdb/TeFourMapBlend.h"
#include "patchdb/TePatchJob.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace {

// Sanitizers look for other faults than differing bits, and take their time.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kKeys = 100;
#else
constexpr int kKeys = 1000;
#endif

template <class T> bool sameBits(const T& a, const T& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Builds 2×2 patches at random keys and compares everything that they share, bit for bit: border heights,
/// seams seen from either side, normals where a patch's inside meets its seams and seams meet the corner.
/// Every fourth key is near the origin, where data from files lies.
void checkBlocks(const std::shared_ptr<const TeSourceChooser>& sources, int samples, int keys,
                 std::uint64_t seed) {
  TeRandom random(seed, 77, {});
  const int n = (samples - 1) / 2;
  for (int i = 0; i < keys; ++i) {
    const std::uint64_t range = i % 4 == 0 ? 64 : std::uint64_t(1) << 41;
    const std::int64_t x = std::int64_t(random.below(range)) - std::int64_t(range / 2);
    const std::int64_t y = std::int64_t(random.below(range)) - std::int64_t(range / 2);
    auto database = teTestDatabase(sources, samples);
    TePatchData* patches[4];
    for (int p = 0; p < 4; ++p) {
      const auto built = database->build({x + p % 2, y + p / 2, 0});
      ASSERT_TRUE(built) << built.error().message;
      patches[p] = *built;
    }
    for (int k = 0; k <= n; ++k)
      for (int side = 0; side < 2; ++side) {
        ASSERT_TRUE(
            sameBits(patches[2 * side]->heights().at(n, k), patches[2 * side + 1]->heights().at(0, k)));
        ASSERT_TRUE(sameBits(patches[side]->heights().at(k, n), patches[side + 2]->heights().at(k, 0)));
      }
    const TePatchMesh corner = *database->seamMesh(*patches[0], TeDirection::NorthEast);
    for (int side = 0; side < 2; ++side) {
      const TePatchMesh vertical = *database->seamMesh(*patches[2 * side], TeDirection::East);
      const TePatchMesh other = *database->seamMesh(*patches[2 * side + 1], TeDirection::West);
      ASSERT_EQ(std::memcmp(vertical.normals.data(), other.normals.data(),
                            other.normals.size() * sizeof(glm::vec3)),
                0);
      for (int across = 0; across < 2; ++across) {
        const TePatchMesh inside = *database->patchMesh(*patches[2 * side + across]);
        for (int k = 0; k < n - 1; ++k)
          ASSERT_TRUE(sameBits(vertical.normals[std::size_t(3 * k + 2 * across)],
                               inside.normals[std::size_t(k * (n - 1) + (across ? 0 : n - 2))]));
      }
      // The seam's end at the corner square.
      const std::size_t row = side == 0 ? std::size_t(n - 2) : 0;
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_TRUE(sameBits(vertical.normals[3 * row + c], corner.normals[std::size_t(6 * side) + c]));
    }
  }
}

/// A generator's specification: its name; for elevation data, with a file if there is one.
std::string specification(const std::string& name) {
  if (name != "elevation")
    return name;
  const char* folder = std::getenv("TERRANE_DATA");
  const std::string file =
      (folder ? std::string(folder) : TERRANE_SOURCE_DIR "/../shared/data") + "/geotiff/mt_rainier_90m.tif";
  return std::filesystem::exists(file) ? "elevation:file=\"" + file + "\"" : name;
}

/// Every registered generator that makes maps of this size with its defaults.
std::vector<TeHeightSourcePtr> registeredSources(int samples, const std::vector<std::string>& filters) {
  std::vector<TeHeightSourcePtr> sources;
  for (const std::string& name : TeGeneratorRegistry::instance().generatorNames()) {
    const auto source = TeGeneratorRegistry::instance().source(specification(name), filters);
    if (source && (*source)->accepts(samples, samples))
      sources.push_back(*source);
    else
      std::printf("FittingBorders: %s left out: %s\n", name.c_str(),
                  source ? (*source)->accepts(samples, samples).error().message.c_str()
                         : source.error().message.c_str());
  }
  return sources;
}

} // namespace

TEST(FittingBorders, HeightsAndNormalsAreTheSameBitsForEveryGenerator) {
  for (const TeHeightSourcePtr& source : registeredSources(17, {})) {
    checkBlocks(std::make_shared<TeSingleSource>(source), 17, kKeys, 1);
    if (HasFatalFailure())
      FAIL() << source->name();
    std::printf("FittingBorders: %s, %d keys, 0 bits differ\n", source->name().c_str(), kKeys);
  }
}

TEST(FittingBorders, HeightsAndNormalsAreTheSameBitsForFilteredGenerators) {
  for (const std::string& filter : TeGeneratorRegistry::instance().filterNames())
    for (const TeHeightSourcePtr& source : registeredSources(17, {filter})) {
      checkBlocks(std::make_shared<TeSingleSource>(source), 17, kKeys / 10, 2);
      if (HasFatalFailure())
        FAIL() << source->name();
    }
}

TEST(FittingBorders, HeightsAndNormalsAreTheSameBitsForMixtures) {
  std::vector<TeHeightSourcePtr> sources = registeredSources(17, {});
  sources.push_back(std::make_shared<TeHashSource>(1, 4000.0f));
  sources.push_back(std::make_shared<TeSampleSource>(
      [](std::int64_t x, std::int64_t) { return x % 7 == 0 ? TeHeightMap::missing() : 0.1f; }));
  checkBlocks(std::make_shared<TeChequeredSources>(sources), 17, kKeys, 3);
}

// Land that fits by itself needs a quarter of the maps, and its heights are those that blending would give.
TEST(FittingBorders, PatchesOfFittingSourcesAreTheSourcesOwnHeights) {
  for (int samples : {5, 65}) {
    const int n = (samples - 1) / 2;
    const auto function = [](std::int64_t x, std::int64_t y) {
      return x == 7 ? TeHeightMap::missing() : float(x) * 0.1f - float(y) * 1.7e-5f;
    };
    auto database = teSampleWorld(function, samples);
    for (int j = -3; j <= 2; ++j)
      for (int i = -3; i <= 2; ++i) {
        const TePatchData& patch = **database->build({i, j, 0});
        ASSERT_TRUE(patch.hasMaps());
        TeHeightMap maps[4], blended = *TeHeightMap::create(n + 1, n + 1);
        for (int corner = 0; corner < 4; ++corner)
          maps[corner] = *database->mapSource({i, j})->get()->generate(
              TeMapRequest::sourceMap(database->lattice(), 7, teMapKey(patch.key(), corner)));
        TeFourMapBlend(database->blendWeights(), maps[0], maps[1], maps[2], maps[3], blended).finish();
        ASSERT_TRUE(patch.heights() == blended);
        for (int y = 0; y <= n; ++y)
          for (int x = 0; x <= n; ++x)
            ASSERT_TRUE(sameBits(patch.heights().at(x, y), function(i * n + x, j * n + y)));
      }
    EXPECT_EQ(database->maps().residentMaps(), 9u); // of 49
  }
}

// Where the world's sources change, land that was copied from one map meets land that is blended.
TEST(FittingBorders, CopiedAndBlendedPatchesMeet) {
  auto database = teSampleWorld([](std::int64_t x, std::int64_t y) { return float(x * x - 3 * y); }, 17);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i)
      ASSERT_TRUE(database->build({i, j, 0}));
  ASSERT_TRUE(database->setSources(std::make_shared<TeSingleSource>(std::make_shared<TeHashSource>())));
  for (TePatchKey key : {TePatchKey{2, 0, 0}, {2, 1, 0}, {-1, 0, 0}, {-1, 1, 0}})
    ASSERT_TRUE(database->build(key));
  for (int j = 0; j < 2; ++j)
    for (int y = 0; y <= 8; ++y) {
      const auto height = [&](int i, int x) { return database->find({i, j, 0})->heights().at(x, y); };
      ASSERT_EQ(height(1, 8), height(2, 0));
      ASSERT_EQ(height(0, 0), height(-1, 8));
    }
}
