#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeRandom.h"
#include "patchdb/TePatchJob.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>

namespace {

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

/// Every registered generator that makes maps of this size with its defaults.
std::vector<TeHeightSourcePtr> registeredSources(int samples, const std::vector<std::string>& filters) {
  std::vector<TeHeightSourcePtr> sources;
  for (const std::string& name : TeGeneratorRegistry::instance().generatorNames()) {
    const auto source = TeGeneratorRegistry::instance().source(name, filters);
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
    checkBlocks(std::make_shared<TeSingleSource>(source), 17, 1000, 1);
    if (HasFatalFailure())
      FAIL() << source->name();
    std::printf("FittingBorders: %s, 1000 keys, 0 bits differ\n", source->name().c_str());
  }
}

TEST(FittingBorders, HeightsAndNormalsAreTheSameBitsForFilteredGenerators) {
  for (const std::string& filter : TeGeneratorRegistry::instance().filterNames())
    for (const TeHeightSourcePtr& source : registeredSources(17, {filter})) {
      checkBlocks(std::make_shared<TeSingleSource>(source), 17, 100, 2);
      if (HasFatalFailure())
        FAIL() << source->name();
    }
}

TEST(FittingBorders, HeightsAndNormalsAreTheSameBitsForMixtures) {
  std::vector<TeHeightSourcePtr> sources = registeredSources(17, {});
  sources.push_back(std::make_shared<TeHashSource>(1, 4000.0f));
  sources.push_back(std::make_shared<TeSampleSource>(
      [](std::int64_t x, std::int64_t) { return x % 7 == 0 ? TeHeightMap::missing() : 0.1f; }));
  checkBlocks(std::make_shared<TeChequeredSources>(sources), 17, 1000, 3);
}

TEST(FittingBorders, PatchesOfFittingSourcesAreTheSourcesOwnHeights) {
  auto database =
      teSampleWorld([](std::int64_t x, std::int64_t y) { return float(x) * 0.1f - float(y) * 1.7e-5f; }, 65);
  const TePatchData& patch = **database->build({-3, 11, 0});
  for (int y = 0; y <= 32; ++y)
    for (int x = 0; x <= 32; ++x)
      ASSERT_EQ(patch.heights().at(x, y), float(-96 + x) * 0.1f - float(352 + y) * 1.7e-5f);
}
