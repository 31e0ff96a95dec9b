#include "nodes/lod/roam/RoamWorld.h"

#include <algorithm>
#include <numeric>

// A pattern that repeats, seen orthographically: nearly all triangles of a level have the same priority. The
// queues give them in one order, however they came in; so a mesh that is made of some of them is the same
// from anywhere.
TEST(HardCase, PriorityTiesRoam) {
  std::mt19937 random(41);
  constexpr int kItems = 2000;
  std::vector<std::int32_t> wanted;
  int orders = 0;
  for (; orders < 20; orders++) {
    std::vector<std::int32_t> items(kItems);
    std::iota(items.begin(), items.end(), 0);
    std::shuffle(items.begin(), items.end(), random);
    TeRoamQueue queue(TeRoamQueue::Order::MostImportantFirst);
    for (const std::int32_t item : items)
      queue.insert(item, std::uint32_t(item), float(item / 500));
    std::vector<std::int32_t> order;
    for (; !queue.empty(); queue.remove(queue.top()))
      order.push_back(queue.top());
    if (orders == 0)
      wanted = order;
    ASSERT_EQ(order, wanted);
  }
  ASSERT_EQ(wanted.size(), std::size_t(kItems));

  const TeLodFieldPtr field = stressTerrain(StressField::Checkerboard, 64, random);
  const auto bounds = TeRoamBounds::create(field, false);
  TeLodView view = viewFrom({32, 32, 100}, 1);
  view.perspective = false;
  TeRoamLod::Settings settings;
  settings.splitOnly = true;
  TeLodAccuracy accuracy;
  accuracy.dial = 1500;
  std::vector<std::uint32_t> mesh;
  std::size_t ties = 0;
  for (int history = 0; history < 20; history++) {
    TeRoamLod lod(bounds, field, settings);
    for (int jump = 0; jump < history; jump++)
      lod.select(anyView(*field, random), accuracy); // nodes lie elsewhere in memory afterwards
    lod.select(view, accuracy);
    if (history == 0) {
      mesh = splitTriangles(lod.mesh());
      for (std::int32_t node = 0; node < std::int32_t(lod.mesh().nodes().size()); node++)
        ties += lod.mesh().splits().contains(node) &&
                lod.mesh().priority(node) == lod.mesh().splits().topPriority();
    }
    ASSERT_EQ(splitTriangles(lod.mesh()), mesh) << history;
  }
  std::printf("%d items in %d orders; a mesh of %zu splits with %zu more as important: always the same\n",
              kItems, orders, mesh.size(), ties);
  EXPECT_GT(ties, 100u);
}
