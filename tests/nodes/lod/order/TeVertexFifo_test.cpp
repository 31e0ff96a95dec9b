#include "nodes/lod/order/TeVertexFifo.h"

#include "nodes/lod/order/orderMeshes.h"

#include <gtest/gtest.h>

#include <deque>

TEST(TeVertexFifo, ForgetsTheVertexThatCameFirst) {
  TeVertexFifo cache(10, 3);
  EXPECT_FALSE(cache.use(1));
  EXPECT_FALSE(cache.use(2));
  EXPECT_FALSE(cache.use(3));
  EXPECT_TRUE(cache.use(1)); // a use does not keep it
  EXPECT_FALSE(cache.use(4));
  EXPECT_FALSE(cache.contains(1));
  EXPECT_TRUE(cache.use(2));
  EXPECT_TRUE(cache.use(3));
  EXPECT_TRUE(cache.use(4));
  EXPECT_EQ(cache.misses(), 4U);
}

TEST(TeVertexFifo, DoesWhatAQueueDoes) {
  std::mt19937 random(2);
  for (const int size : {3, 8, 32}) {
    TeVertexFifo cache(60, size);
    std::deque<std::uint32_t> queue;
    for (int i = 0; i < 5000; i++) {
      const std::uint32_t vertex = std::uint32_t(random() % 60);
      const bool isThere = std::find(queue.begin(), queue.end(), vertex) != queue.end();
      ASSERT_EQ(cache.use(vertex), isThere);
      if (isThere)
        continue;
      queue.push_back(vertex);
      if (queue.size() > std::size_t(size))
        queue.pop_front();
    }
  }
}

// A grid row by row: two rows of vertices fit the cache, or each vertex is transformed for the row below and
// again for the row above.
TEST(TeVertexFifo, KnowsWhatAGridCosts) {
  const int cells = 64;
  const TeLodMesh grid = gridOf(cells);
  const auto misses = [&](int size) {
    return TeVertexFifo::missesPerTriangle(grid.indices, grid.vertices.size(), size);
  };
  const double once = double(grid.vertices.size()) / double(grid.triangles());
  EXPECT_DOUBLE_EQ(misses(2 * (cells + 1) + 2), once);
  EXPECT_DOUBLE_EQ(misses(8), 2.0 * (cells + 1) / (2.0 * cells));
  EXPECT_EQ(TeVertexFifo::missesPerTriangle({}, 0, 8), 0);
}
