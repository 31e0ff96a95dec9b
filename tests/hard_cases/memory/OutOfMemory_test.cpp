#include "hard_cases/memory/TeFailingMemory.h"

#include "engine/jobs/TePatchTestJob.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace {

constexpr TePatchKey kEarlier{0, 0, 0};
constexpr TePatchKey kWanted{1, 0, 0};

std::shared_ptr<const TeSourceChooser> sources() {
  return std::make_shared<TeSingleSource>(std::make_shared<TeHashSource>());
}

struct Outcome {
  std::int64_t allocations = 0;
  bool done = false;
};

/// Makes the wanted patch: maps, blending, arrays, and the seam to the earlier one.
Outcome makePatch(TePatchWorkshop& shop, std::int64_t failing, TeFailingMemory::Mode mode) {
  Outcome outcome;
  shop.queue.setFinished([&](TeJob&, TeProgress progress) { outcome.done = progress == TeProgress::Done; });
  shop.queue.add(std::make_unique<TePatchTestJob>(*shop.database, shop.maker, TeJobKind::Block, kWanted));
  const TeFailingMemory memory(failing, mode);
  while (!shop.queue.empty()) {
    shop.maker.joinAll();
    TeAllowance some = TeAllowance::units(3);
    shop.queue.run(some);
  }
  if (outcome.done)
    outcome.done = shop.database->seam(*shop.database->find(kEarlier), TeDirection::East).ok();
  outcome.allocations = memory.allocations();
  return outcome;
}

/// Fails each allocation in turn, and says how many there were.
std::int64_t failEach(int workers, TeFailingMemory::Mode mode) {
  const auto reference = teTestDatabase(sources(), 17);
  EXPECT_TRUE(reference->build(kEarlier));
  EXPECT_TRUE(reference->build(kWanted));
  const TePatchMeshPtr seam = *reference->seam(*reference->find(kEarlier), TeDirection::East);
  const glm::dvec2 ground{0.3, 0.7};
  for (std::int64_t failing = 0;; ++failing) {
    const std::int64_t before = TeFailingMemory::blocksInUse();
    bool past = false;
    {
      TePatchWorkshop shop(teTestDatabase(sources(), 17));
      EXPECT_TRUE(shop.maker.setWorkers(workers));
      EXPECT_TRUE(shop.database->build(kEarlier));
      const Outcome outcome = makePatch(shop, failing, mode);
      past = outcome.allocations <= failing;
      EXPECT_TRUE(past || !outcome.done || mode == TeFailingMemory::Mode::One) << failing;
      EXPECT_TRUE(!past || outcome.done) << failing;
      // What was there before survives, and the patch can be made once there is memory again.
      EXPECT_EQ(shop.database->heightAt(ground), reference->heightAt(ground)) << failing;
      EXPECT_EQ(shop.maker.requested(), 0u) << failing;
      if (!outcome.done) {
        shop.database->remove(kWanted);
        EXPECT_TRUE(makePatch(shop, -1, mode).done) << failing;
      }
      EXPECT_EQ(shop.database->find(kWanted)->heights(), reference->find(kWanted)->heights()) << failing;
      const TePatchMeshPtr again = *shop.database->seam(*shop.database->find(kEarlier), TeDirection::East);
      EXPECT_TRUE(again->positions == seam->positions && again->normals == seam->normals) << failing;
    }
    EXPECT_EQ(TeFailingMemory::blocksInUse(), before) << failing;
    if (past || ::testing::Test::HasFailure())
      return failing;
  }
}

} // namespace

// Every allocation of a patch fails in turn, alone and with all after it: an error, the earlier terrain
// stays, nothing leaks, and the patch comes out right afterwards.
TEST(HardCase, OutOfMemoryEngine) {
  failEach(0, TeFailingMemory::Mode::One); // allocates what is allocated once in a program
  if (HasFailure())
    return;
  std::int64_t failed = 0;
  for (int workers : {0, 2})
    for (auto mode : {TeFailingMemory::Mode::One, TeFailingMemory::Mode::AllFromThere})
      failed += failEach(workers, mode);
  std::printf("OutOfMemoryEngine: %lld failures of allocations in maps, blending, arrays and seams, with and "
              "without workers, 0 crashes, 0 blocks lost\n",
              (long long)failed);
}
