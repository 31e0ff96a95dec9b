#include "engine/jobs/TePatchTestJob.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeRandom.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

namespace {

TeHeightSourcePtr sourceOf(const std::string& specification) {
  const auto generator = TeGeneratorRegistry::instance().chain(specification, {});
  EXPECT_TRUE(generator) << specification;
  EXPECT_TRUE((*generator)->updateParams());
  return (*generator)->source();
}

std::uint64_t hashOf(const TePatchMesh& mesh) {
  std::uint64_t hash = teHashBytes(mesh.positions.data(), mesh.positions.size() * sizeof(mesh.positions[0]));
  hash = teHashBytes(mesh.normals.data(), mesh.normals.size() * sizeof(mesh.normals[0]), hash);
  return teHashBytes(mesh.strips.data(), mesh.strips.size() * sizeof(mesh.strips[0]), hash);
}

/// Hash of the heights, arrays and seams of all patches of a block that is made within allowances.
std::uint64_t hashOfBlock(const std::shared_ptr<const TeSourceChooser>& sources, int workers, bool fixedJoin,
                          const std::function<TeAllowance()>& allowance) {
  constexpr int kRadius = 2;
  TePatchWorkshop shop(teTestDatabase(sources, 33));
  EXPECT_TRUE(shop.maker.setWorkers(workers));
  shop.maker.setFixedJoin(fixedJoin);
  // Hashes are added up, since patches end in any order.
  std::uint64_t sum = 0;
  shop.queue.setFinished([&](TeJob& job, TeProgress progress) {
    ASSERT_EQ(progress, TeProgress::Done) << job.error().message;
    auto& patch = static_cast<TePatchTestJob&>(job);
    const TeHeightMap& heights = shop.database->find(patch.key())->heights();
    sum += teHashBytes(heights.data(), heights.bytes(), TePatchKeyHash()(patch.key()));
    sum += hashOf(patch.takeMesh());
  });
  shop.addBlock(kRadius);
  while (!shop.queue.empty())
    shop.tick(allowance());
  for (int y = -kRadius; y < kRadius; ++y)
    for (int x = -kRadius; x < kRadius; ++x)
      for (TeDirection direction : {TeDirection::East, TeDirection::North, TeDirection::NorthEast})
        sum += hashOf(**shop.database->seam(*shop.database->find({x, y, 0}), direction));
  EXPECT_EQ(shop.maker.mapsMade(), (2 * kRadius + 2) * (2 * kRadius + 2));
  return sum;
}

} // namespace

// A block of patches of three landscapes has the same bits with any number of workers, whether they are
// waited for or not, and with slices of any length, by units and by time.
TEST(HardCase, SummationOrderEngine) {
  const auto sources = std::make_shared<TeChequeredSources>(std::vector<TeHeightSourcePtr>{
      sourceOf("noise"), sourceOf("faults"), std::make_shared<TeHashSource>(3)});
  const std::uint64_t expected = hashOfBlock(sources, 0, false, TeAllowance::unlimited);
  int runs = 1;
  for (int workers : {0, 1, 2, 4, 8})
    for (bool fixedJoin : {false, true}) {
      TeRandom random(11, 12, {workers});
      const std::function<TeAllowance()> allowances[] = {
          [] { return TeAllowance::units(1); },
          [] { return TeAllowance::units(64); },
          [&] { return TeAllowance::units(std::int64_t(1 + random.below(40))); },
          [] { return TeAllowance::seconds(0.0002); },
      };
      for (const auto& allowance : allowances) {
        ASSERT_EQ(hashOfBlock(sources, workers, fixedJoin, allowance), expected)
            << workers << " workers, run " << runs;
        ++runs;
      }
    }
  std::printf("SummationOrderEngine: %d runs with 0 to 8 workers and slices of 1 to 64 units and 0.2 ms, "
              "25 patches and 48 seams each, 0 bits differ\n",
              runs);
}
