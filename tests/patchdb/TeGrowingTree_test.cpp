#include "patchdb/TeGrowingTree.h"

#include "generators/base/TeRandom.h"
#include "patchdb/TePatchData.h"

#include <gtest/gtest.h>

#include <map>

namespace {

TePatchData& insert(TeGrowingTree& tree, std::int64_t x, std::int64_t y) {
  return tree.insert(x, y, std::make_unique<TePatchData>(TePatchKey{x, y, 0}));
}

/// The root as document 002 describes it: side and centre for patches of side 64, centred on their keys.
struct Root {
  double side, centreX, centreY;
  bool operator==(const Root& o) const {
    return side == o.side && centreX == o.centreX && centreY == o.centreY;
  }
};

Root rootOf(const TeGrowingTree& tree) {
  const TeGrowingTree::Bounds b = tree.bounds();
  return {64.0 * double(b.span), 64.0 * (double(b.x) + 0.5 * double(b.span - 1)),
          64.0 * (double(b.y) + 0.5 * double(b.span - 1))};
}

std::ostream& operator<<(std::ostream& out, const Root& root) {
  return out << "side " << root.side << " centred (" << root.centreX << ", " << root.centreY << ")";
}

} // namespace

TEST(TeGrowingTree, GrowsAsInTheDocumentsExample) {
  TeGrowingTree tree;
  insert(tree, -1, 0); // the leaf centred (-64, 0)
  EXPECT_EQ(rootOf(tree), (Root{64, -64, 0}));
  insert(tree, -1, 1); // (-64, 64)
  EXPECT_EQ(rootOf(tree), (Root{128, -32, 32}));
  insert(tree, 0, 0); // inside
  EXPECT_EQ(rootOf(tree), (Root{128, -32, 32}));
  insert(tree, -2, 0); // (-128, 0)
  EXPECT_EQ(rootOf(tree), (Root{256, -96, 96}));
  insert(tree, -1, -1); // (-64, -64)
  EXPECT_EQ(rootOf(tree), (Root{512, 32, -32}));
  EXPECT_EQ(tree.size(), 5u);
  for (auto [x, y] : {std::pair(-1, 0), {-1, 1}, {0, 0}, {-2, 0}, {-1, -1}})
    EXPECT_EQ(tree.find(x, y)->key(), (TePatchKey{x, y, 0}));
  EXPECT_EQ(tree.find(1, 1), nullptr);
  EXPECT_EQ(tree.find(400, -1), nullptr);
}

TEST(TeGrowingTree, FindsWhatAMapFindsThroughInsertionsAndRemovals) {
  TeRandom random(5, 2, {});
  TeGrowingTree tree;
  std::map<std::pair<std::int64_t, std::int64_t>, TePatchData*> expected;
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t x = std::int64_t(random.below(41)) - 20;
    const std::int64_t y = std::int64_t(random.below(41)) - 20;
    const auto known = expected.find({x, y});
    ASSERT_EQ(tree.find(x, y), known == expected.end() ? nullptr : known->second);
    if (known == expected.end()) {
      expected[{x, y}] = &insert(tree, x, y);
    } else {
      const std::unique_ptr<TePatchData> removed = tree.remove(x, y);
      ASSERT_EQ(removed.get(), known->second);
      expected.erase(known);
    }
    ASSERT_EQ(tree.size(), expected.size());
  }
}

TEST(TeGrowingTree, InnerNodesGoWithTheirLastLeaf) {
  TeGrowingTree tree;
  insert(tree, 0, 0);
  EXPECT_EQ(tree.nodes(), 0u);
  insert(tree, 1023, 0);
  const std::size_t two = tree.nodes();
  EXPECT_EQ(two, 19u); // ten levels above each leaf, the root common
  insert(tree, 512, 512);
  EXPECT_GT(tree.nodes(), two);
  EXPECT_TRUE(tree.remove(512, 512));
  EXPECT_EQ(tree.nodes(), two);
  EXPECT_FALSE(tree.remove(512, 512));
  EXPECT_TRUE(tree.remove(0, 0));
  EXPECT_EQ(tree.nodes(), 10u);
  EXPECT_TRUE(tree.remove(1023, 0));
  EXPECT_EQ(tree.nodes(), 0u);
  EXPECT_EQ(tree.bounds().span, 0);
  EXPECT_EQ(tree.bytes(), 0u);
}

TEST(TeGrowingTree, FarCellsNeedBoundedDepth) {
  TeGrowingTree tree;
  const std::int64_t far = TeLattice::kMaxKey;
  for (std::int64_t y : {-far, std::int64_t(0), far - 1})
    for (std::int64_t x : {-far, std::int64_t(-1), far - 1})
      insert(tree, x, y);
  EXPECT_LE(tree.bounds().span, std::int64_t(1) << 49);
  EXPECT_LE(tree.nodes(), 9u * 49u);
  for (std::int64_t y : {-far, std::int64_t(0), far - 1})
    for (std::int64_t x : {-far, std::int64_t(-1), far - 1})
      ASSERT_EQ(tree.find(x, y)->key(), (TePatchKey{x, y, 0}));
}

TEST(TeGrowingTree, TraversesInTheOrderOfRanksAndStops) {
  TeGrowingTree tree;
  for (int y = -3; y < 3; ++y)
    for (int x = -3; x < 3; ++x)
      insert(tree, x, y);
  // By the west side of boxes: columns come from west to east within each node; east of 0 is skipped.
  int visited = 0;
  EXPECT_TRUE(
      tree.traverse([](const TeGrowingTree::Bounds& b) { return b.x >= 0 ? -1.0 : double(b.x + 100); },
                    [&](const TePatchData& patch) {
                      EXPECT_LT(patch.key().x, 0);
                      ++visited;
                      return true;
                    }));
  EXPECT_EQ(visited, 18);
  visited = 0;
  EXPECT_FALSE(tree.traverse([](const TeGrowingTree::Bounds&) { return 0.0; },
                             [&](const TePatchData&) { return ++visited < 4; }));
  EXPECT_EQ(visited, 4);
}
