#include "patchdb/TeMeshBuilder.h"

#include "generators/base/TeRandom.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

namespace {

bool same(const TePatchMesh& a, const TePatchMesh& b) {
  return a.columns == b.columns && a.rows == b.rows && a.origin == b.origin && a.positions == b.positions &&
         a.normals == b.normals && a.strips == b.strips && a.key == b.key;
}

/// A landscape, with holes if wanted.
std::unique_ptr<TePatchDatabase> world(int samples, bool holes) {
  return teSampleWorld(
      [holes](std::int64_t x, std::int64_t y) {
        const std::uint64_t bits = teHashCombine(std::uint64_t(x), std::uint64_t(y));
        return holes && bits % 9 == 0 ? TeHeightMap::missing() : float(bits >> 44);
      },
      samples);
}

} // namespace

TEST(TeMeshBuilder, AnySlicingGivesTheSameMesh) {
  for (bool holes : {false, true})
    for (int samples : {5, 17, 257, 1025}) {
      const auto database = world(samples, holes);
      const TePatchData& patch = **database->build({-3, 2, 0});
      const TePatchMesh whole = *database->patchMesh(patch);
      TeRandom random(6, 7, {samples});
      for (int most : {1, 3}) {
        TeResult<TeMeshBuilder> builder = database->meshBuilder(patch);
        ASSERT_TRUE(builder);
        bool done = false;
        std::int64_t units = 0;
        while (!done) {
          TeAllowance some = TeAllowance::units(std::int64_t(1 + random.below(std::uint64_t(most))));
          done = builder->step(some);
          units += some.unitsSpent();
        }
        const std::int64_t vertices = std::int64_t(whole.columns) * whole.rows;
        EXPECT_GE(units, vertices / TeMeshBuilder::kVerticesPerUnit) << samples;
        EXPECT_LE(units, 2 + 2 * vertices / TeMeshBuilder::kVerticesPerUnit) << samples;
        EXPECT_TRUE(same(builder->take(), whole)) << samples;
      }
    }
}

TEST(TeMeshBuilder, TakesItsMemoryAtOnce) {
  const auto database = world(257, true);
  const TePatchData& patch = **database->build({0, 0, 0});
  const auto made = database->patchMesh(patch);
  const TePatchMesh& mesh = *made;
  // Room for all strips without holes is enough for those with holes.
  EXPECT_EQ(mesh.strips.capacity(), std::size_t(mesh.rows - 1) * (2 * std::size_t(mesh.columns) + 1));
  EXPECT_LT(mesh.strips.size(), mesh.strips.capacity());
}

TEST(TeMeshBuilder, NeedsHeights) {
  const auto database = world(17, false);
  const TePatchData& patch = **database->lookup({0, 0, 0}, TeLookup::Create);
  const auto builder = database->meshBuilder(patch);
  ASSERT_FALSE(builder);
  EXPECT_EQ(builder.error().message, "patch (0, 0) level 0: has no heights yet");
}
