#include "nodes/lod/roam/TeRoamMesh.h"

#include "nodes/lod/roam/RoamCheck.h"

namespace {

TeLodAccuracy anyAccuracy(std::mt19937& random) {
  TeLodAccuracy accuracy;
  if (random() % 2)
    accuracy.dial = 2 + double(random() % 1500);
  else
    accuracy.pixelError = std::exp(double(random() % 100) / 12 - 2);
  if (random() % 4 == 0)
    accuracy.maxTriangles = 1 + std::int64_t(random() % 800);
  return accuracy;
}

} // namespace

TEST(TeRoamMesh, anyOrderOfSplitsAndMergesKeepsItsPromises) {
  std::mt19937 random(21);
  const TeLodFieldPtr field = stressTerrain(StressField::Rough, 32, random);
  TeRoamMesh mesh(TeRoamBounds::create(field, false), TeRoamMetric::ScreenError, true);
  mesh.setView(viewFrom({10, 10, 100}), 0);
  int splits = 0, merges = 0;
  for (int step = 0; step < 3000; step++) {
    const auto node = std::int32_t(random() % mesh.nodes().size());
    if (mesh.splits().contains(node))
      splits += mesh.split(node);
    else if (random() % 2 && mesh.merges().contains(node)) {
      mesh.merge(node);
      merges++;
    }
    if (step % 10 == 0) {
      ASSERT_EQ(RoamCheck(mesh).fault(), "") << step;
    }
  }
  EXPECT_GT(splits, 300);
  EXPECT_GT(merges, 100);
  EXPECT_EQ(mesh.nodes().live(), 2 + 4 * (splits - merges));
}

TEST(TeRoamMesh, growthIsNeverLessThanWhatASplitAdds) {
  std::mt19937 random(22);
  const TeLodFieldPtr field = stressTerrain(StressField::Rough, 64, random);
  TeRoamMesh mesh(TeRoamBounds::create(field, false), TeRoamMetric::ScreenError, true);
  mesh.setView(viewFrom({10, 10, 100}), 0);
  int forced = 0;
  for (int step = 0; step < 2000; step++) {
    const auto node = std::int32_t(random() % mesh.nodes().size());
    if (!mesh.splits().contains(node))
      continue;
    const std::int64_t before = mesh.drawn(), growth = mesh.growth(node);
    const int splits = mesh.split(node);
    forced += splits > 1;
    ASSERT_EQ(growth, 6 * splits);
    ASSERT_LE(mesh.drawn() - before, growth);
  }
  EXPECT_GT(forced, 20);
}

TEST(TeRoamMesh, withoutTheMergeQueueSplitsAreTheSame) {
  std::mt19937 random(23);
  const TeLodFieldPtr field = stressTerrain(StressField::Rough, 32, random);
  const auto bounds = TeRoamBounds::create(field, false);
  TeRoamMesh both(bounds, TeRoamMetric::ScreenError, true), only(bounds, TeRoamMetric::ScreenError, false);
  const TeLodView view = viewFrom({10, 10, 30});
  both.setView(view, 0);
  only.setView(view, 0);
  for (int i = 0; i < 200; i++) {
    ASSERT_EQ(both.nodes()[both.splits().top()].number, only.nodes()[only.splits().top()].number);
    both.split(both.splits().top());
    only.split(only.splits().top());
  }
  EXPECT_TRUE(only.merges().empty());
  EXPECT_EQ(splitTriangles(both), splitTriangles(only));
}

// From anywhere to anywhere, any accuracy, now and then stopped half-way.
TEST(TeRoamMesh, queuesAndLinksHoldAfterTenThousandRandomJumps) {
  std::mt19937 random(24);
  std::int64_t splits = 0, merges = 0, jumps = 0;
  for (const StressField stress : {StressField::Rough, StressField::Rough, StressField::Checkerboard,
                                   StressField::Plateau, StressField::Spike}) {
    const TeLodFieldPtr field = stressTerrain(stress, 32, random);
    const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
    for (int jump = 0; jump < 2000; jump++, jumps++) {
      TeAllowance some = TeAllowance::units(std::int64_t(random() % 200));
      TeAllowance all = TeAllowance::unlimited();
      lod->select(anyView(*field, random), anyAccuracy(random), random() % 4 == 0 ? some : all);
      splits += lod->selection().splits;
      merges += lod->selection().merges;
      ASSERT_EQ(RoamCheck(lod->mesh()).fault(), "") << "jump " << jump;
    }
  }
  std::printf(
      "%lld jumps, %lld splits, %lld merges: queues, links, levels and vertices are right after each\n",
      static_cast<long long>(jumps), static_cast<long long>(splits), static_cast<long long>(merges));
  EXPECT_EQ(jumps, 10000);
  EXPECT_GT(splits, 200000);
}

TEST(TeRoamMesh, verticesAreSharedAndNoneIsLost) {
  std::mt19937 random(25);
  const TeLodFieldPtr field = stressTerrain(StressField::Rough, 32, random);
  TeRoamMesh mesh(TeRoamBounds::create(field, false), TeRoamMetric::ScreenError, true);
  mesh.setView(viewFrom({10, 10, 100}), 0);
  while (!mesh.splits().empty())
    mesh.split(mesh.splits().top());
  EXPECT_EQ(mesh.nodes().vertices().size(), 33u * 33u);
  EXPECT_EQ(mesh.drawn(), 2 * 32 * 32);
  while (!mesh.merges().empty())
    mesh.merge(mesh.merges().top());
  EXPECT_EQ(mesh.nodes().live(), 2);
  EXPECT_EQ(mesh.drawn(), 2);
  while (!mesh.splits().empty())
    mesh.split(mesh.splits().top());
  EXPECT_EQ(mesh.nodes().vertices().size(), 33u * 33u); // all were used again
}

TEST(TeRoamMesh, movesTogetherAfterMuchWasMerged) {
  std::mt19937 random(26);
  const TeLodFieldPtr field = stressTerrain(StressField::Rough, 64, random);
  for (const TeRoamMetric metric : {TeRoamMetric::ScreenError, TeRoamMetric::Variance}) {
    TeRoamMesh mesh(TeRoamBounds::create(field, true), metric, true);
    mesh.setView(viewFrom({10, 10, 100}), 0);
    while (!mesh.splits().empty())
      mesh.split(mesh.splits().top());
    const std::size_t most = mesh.nodes().size();
    while (mesh.nodes().live() > 500)
      mesh.merge(mesh.merges().top());
    const std::vector<std::uint32_t> split = splitTriangles(mesh);
    const std::int64_t live = mesh.nodes().live();
    EXPECT_EQ(mesh.nodes().size(), most);
    const std::uint64_t version = mesh.version();
    mesh.setView(viewFrom({40, 10, 100}), 0);
    EXPECT_EQ(RoamCheck(mesh).fault(), "");
    EXPECT_EQ(splitTriangles(mesh), split);
    EXPECT_EQ(mesh.nodes().live(), live);
    EXPECT_LE(mesh.nodes().size(), std::size_t(live) + 2); // the base has four places
    EXPECT_NE(mesh.version(), version);                    // vertices are numbered anew
  }
}
