#include "patchdb/TeSurface.h"

#include "generators/base/TeRandom.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <thread>
#include <vector>

namespace {

void buildBlock(TePatchDatabase& database, int from, int to) {
  for (int y = from; y <= to; ++y)
    for (int x = from; x <= to; ++x)
      ASSERT_TRUE(database.build({x, y, 0}));
}

} // namespace

TEST(TeSurface, HeightAtSamplesIsExactlyTheirFloat) {
  for (double spacing : {1.0, 0.1, 27.3}) {
    auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17, spacing);
    buildBlock(*database, -1, 1);
    const TeLattice& lattice = database->lattice();
    // Every sample of the block, those on its rim included.
    for (int y = -8; y <= 16; ++y)
      for (int x = -8; x <= 16; ++x) {
        const TePatchKey key{std::min(1, int(std::floor(x / 8.0))), std::min(1, int(std::floor(y / 8.0))), 0};
        const float sample = database->find(key)->heights().at(int(x - key.x * 8), int(y - key.y * 8));
        ASSERT_EQ(*database->heightAt({lattice.position(x), lattice.position(y)}), double(sample))
            << x << ", " << y;
      }
  }
}

TEST(TeSurface, HeightsOfManyPointsAreThoseOfEach) {
  // A hole in one cell, a coarse patch in the west, nothing known farther on.
  auto database = teSampleWorld(
      [](std::int64_t x, std::int64_t y) {
        return x == 4 && y == 4 ? TeHeightMap::missing() : float(x * x % 7 + y);
      },
      17);
  buildBlock(*database, -2, 2);
  TeHeightMap coarse = *TeHeightMap::create(9, 9);
  for (int y = 0; y <= 8; ++y)
    for (int x = 0; x <= 8; ++x)
      coarse.at(x, y) = float(x * y);
  (*database->lookup({-1, 0, 2}, TeLookup::Create))->setHeights(std::move(coarse), 1);
  TeRandom random(9, 4, {});
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 1001; ++i)
    points.emplace_back(random.uniform(-40, 30), random.uniform(-30, 30));
  for (double x = -22; x <= 22; ++x) // samples and grid lines, rims among them
    for (double y : {-20.0, -4.0, 3.5, 4.0, 20.0})
      points.emplace_back(x, y);
  for (double bad : {double(NAN), double(INFINITY), -1e300, 1e300})
    points.emplace_back(bad, 1);
  std::vector<double> heights(points.size(), -1);
  database->heightsAt(points.data(), points.size(), heights.data());
  std::size_t known = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<double> height = database->heightAt(points[i]);
    known += height ? 1 : 0;
    if (height)
      ASSERT_EQ(heights[i], *height) << points[i].x << ", " << points[i].y;
    else
      ASSERT_TRUE(std::isnan(heights[i])) << points[i].x << ", " << points[i].y;
  }
  EXPECT_GT(known, points.size() / 4);
  EXPECT_LT(known, points.size() - 8);
  database->heightsAt(nullptr, 0, nullptr);
}

TEST(TeSurface, CellsAreSplitFromSouthWestToNorthEast) {
  auto database = teSampleWorld(
      [](std::int64_t x, std::int64_t y) {
        return x == 3 && y == 5 ? 10.0f : x == 4 && y == 4 ? 6.0f : 0.0f;
      },
      17);
  buildBlock(*database, 0, 0);
  const double west = database->lattice().position(3);
  const double south = database->lattice().position(4);
  EXPECT_EQ(*database->heightAt({west + 0.5, south + 0.5}), 0.0);   // the diagonal is level
  EXPECT_EQ(*database->heightAt({west + 0.25, south + 0.75}), 5.0); // towards the north-west corner
  EXPECT_EQ(*database->heightAt({west + 0.75, south + 0.25}), 3.0); // towards the south-east corner
  const glm::dvec3 upper = *database->normalAt({west + 0.25, south + 0.75});
  const glm::dvec3 expected = glm::dvec3(10, -10, 1) / std::sqrt(201.0);
  EXPECT_NEAR(upper.x, expected.x, 1e-15);
  EXPECT_NEAR(upper.y, expected.y, 1e-15);
  EXPECT_NEAR(upper.z, expected.z, 1e-15);
}

TEST(TeSurface, AnotherDiagonalDiffersByAtMostTheStatedBound) {
  TeRandom random(4, 4, {});
  for (int i = 0; i < 2000; ++i) {
    const TeSurfaceCell cell{float(random.uniform(-9, 9)), float(random.uniform(-9, 9)),
                             float(random.uniform(-9, 9)), float(random.uniform(-9, 9))};
    // The same cell seen in a mirror has the other diagonal.
    const TeSurfaceCell mirrored{cell.southEast, cell.southWest, cell.northEast, cell.northWest};
    double worst = 0;
    for (double v = 0; v <= 1; v += 0.125)
      for (double u = 0; u <= 1; u += 0.125) {
        worst = std::max(worst, std::fabs(cell.height(u, v) - mirrored.height(1 - u, v)));
        const double bilinear = (1 - v) * ((1 - u) * cell.southWest + u * cell.southEast) +
                                v * ((1 - u) * cell.northWest + u * cell.northEast);
        ASSERT_LE(std::fabs(cell.height(u, v) - bilinear), cell.deviation() + 1e-12);
      }
    ASSERT_LE(worst, cell.deviation() + 1e-12);
    ASSERT_NEAR(worst, cell.deviation(), 1e-12); // it is reached in the middle
  }
}

TEST(TeSurface, NothingIsAnsweredWhereNothingIsKnown) {
  auto database = teSampleWorld(
      [](std::int64_t x, std::int64_t y) { return x == 4 && y == 4 ? TeHeightMap::missing() : 1.0f; }, 17);
  EXPECT_FALSE(database->heightAt({0, 0}));
  EXPECT_FALSE(database->intersect({0, 0, 10}, {0, 0, -1}, 100));
  buildBlock(*database, 0, 0);
  EXPECT_FALSE(database->heightAt({0.5, 0.5})); // the hole
  EXPECT_FALSE(database->normalAt({0.5, 0.5}));
  EXPECT_TRUE(database->heightAt({1, 0})); // its rim belongs to the cells around
  EXPECT_TRUE(database->heightAt({4, 4})); // so does the rim of the known
  EXPECT_FALSE(database->heightAt({4.01, 0}));
  EXPECT_FALSE(database->heightAt({-4.01, 0}));
  for (double bad : {double(NAN), double(INFINITY), -double(INFINITY), 1e300, -1e300}) {
    EXPECT_FALSE(database->heightAt({bad, 0}));
    EXPECT_FALSE(database->normalAt({0, bad}));
    EXPECT_FALSE(database->surfaceAt({bad, bad}));
    EXPECT_FALSE(database->intersect({bad, 0, 0}, {1, 0, 0}, 10));
    if (!std::isfinite(bad)) {
      EXPECT_FALSE(database->intersect({2, 2, bad}, {0, 0, 1}, INFINITY));
      EXPECT_FALSE(database->intersect({2, 2, bad}, {0, 0, -1}, INFINITY));
      EXPECT_FALSE(database->intersect({2, 2, 10}, {0, 0, bad}, INFINITY));
    }
    EXPECT_FALSE(database->intersect({0, 0, 10}, {0, 0, -1}, -1));
  }
  EXPECT_FALSE(database->intersect({2, 2, 10}, {0, NAN, -1}, 100));
  EXPECT_FALSE(database->intersect({2, 2, 10}, {0, 0, 0}, 100));
  EXPECT_FALSE(database->intersect({2, 2, 10}, {0, 0, -1}, NAN));
  EXPECT_FALSE(database->intersect({2, 2, 10}, {0, 1, -1}, NAN));
  EXPECT_TRUE(database->intersect({2, 2, 10}, {0, 0, -1}, INFINITY));
}

TEST(TeSurface, AnswersFollowWhatIsBuiltAndRemoved) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(database->heightAt({0, 0}));
    ASSERT_TRUE(database->build({0, 0, 0}));
    EXPECT_TRUE(database->heightAt({0, 0}));
    database->find({0, 0, 0})->dropHeights();
    EXPECT_FALSE(database->heightAt({0, 0}));
    ASSERT_TRUE(database->build({0, 0, 0}));
    EXPECT_TRUE(database->heightAt({0, 0}));
    database->remove({0, 0, 0});
  }
}

TEST(TeSurface, CoarserPatchesAnswerWithTheirDeviation) {
  auto database = teSampleWorld([](std::int64_t x, std::int64_t) { return float(x); }, 17);
  TeHeightMap heights = *TeHeightMap::create(9, 9);
  for (int y = 0; y <= 8; ++y)
    for (int x = 0; x <= 8; ++x)
      heights.at(x, y) = float(4 * x);
  (*database->lookup({0, 0, 2}, TeLookup::Create))->setHeights(std::move(heights), 0.75f);
  const auto coarse = database->surfaceAt({9.5, 3.25});
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->key, (TePatchKey{0, 0, 2}));
  EXPECT_EQ(coarse->deviation, 0.75);
  EXPECT_EQ(coarse->height, 13.5);
  // Rays meet base patches only, however they are directed.
  EXPECT_FALSE(database->intersect({9.5, 3.25, 100}, {0, 0, -1}, 1000));
  EXPECT_FALSE(database->intersect({9.5, 3.25, 100}, {0.001, 0, -1}, 1000));
  ASSERT_TRUE(database->build({1, 0, 0}));
  EXPECT_TRUE(database->intersect({9.5, 3.25, 100}, {0, 0, -1}, 1000));
  const auto fine = database->surfaceAt({9.5, 3.25});
  EXPECT_EQ(fine->key, (TePatchKey{1, 0, 0}));
  EXPECT_EQ(fine->deviation, 0.0);
  EXPECT_EQ(fine->height, 13.5);
  EXPECT_EQ(*database->heightAt({27.99999, 27.99999}), *database->heightAt({27.99999, 0}));
  EXPECT_EQ(*database->heightAt({28, 28}), 32.0); // the rim of the coarse patch
}

TEST(TeSurface, RaysHitWhereTheHeightsSay) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(1, 3.0f), 17, 0.7);
  buildBlock(*database, -2, 2);
  TeRandom random(1, 9, {});
  const double reach = 2.45 * database->lattice().patchSide();
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 from(random.uniform(-reach, reach), random.uniform(-reach, reach),
                          random.uniform(-5, 5));
    const glm::dvec3 to(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-5, 5));
    const bool above = from.z > *database->heightAt({from.x, from.y});
    const bool ends = to.z > *database->heightAt({to.x, to.y});
    const auto hit = database->intersect(from, to - from, 1);
    if (above != ends) {
      ASSERT_TRUE(hit) << i;
    }
    // By small steps: no change of side before the hit.
    const double until = hit ? hit->distance : 1;
    for (int step = 1; step < 400; ++step) {
      const glm::dvec3 p = from + (to - from) * (until * step / 400);
      const double clearance = p.z - *database->heightAt({p.x, p.y});
      ASSERT_TRUE(above ? clearance > -1e-9 : clearance < 1e-9) << i << " " << step;
    }
    if (hit) {
      ++hits;
      ASSERT_NEAR(hit->position.z, *database->heightAt({hit->position.x, hit->position.y}), 1e-9);
      const glm::dvec3 p = from + (to - from) * hit->distance;
      ASSERT_NEAR(p.z, hit->position.z, 1e-9);
      ASSERT_GT(hit->normal.z, 0);
    }
  }
  EXPECT_GT(hits, 2000);
}

/// The same ray from cell to cell of a small lattice, whose patches have no blocks to pass over, and of large
/// patches.
TEST(TeSurface, RaysHitTheSameWhateverThePatchesSize) {
  const auto function = [](std::int64_t x, std::int64_t y) {
    if (x == 37 && y == -20)
      return TeHeightMap::missing();
    return float(30 * std::sin(double(x) / 25) * std::cos(double(y) / 31) +
                 std::sin(double(x * y)) * (x > 0 ? 3 : 0.1));
  };
  // With samples at the same places: half a patch of either size is a whole number of cells.
  auto small = teSampleWorld([&](std::int64_t x, std::int64_t y) { return function(x - 4, y - 4); }, 17);
  auto large = teSampleWorld([&](std::int64_t x, std::int64_t y) { return function(x - 36, y - 36); }, 145);
  buildBlock(*small, -13, 13);
  buildBlock(*large, -1, 1);
  TeRandom random(3, 9, {});
  int hits = 0;
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec3 from(random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-40, 60));
    const glm::dvec3 to(random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-60, 40));
    const auto a = small->intersect(from, to - from, 1);
    const auto b = large->intersect(from, to - from, 1);
    ASSERT_EQ(a.has_value(), b.has_value()) << i;
    if (!a)
      continue;
    ++hits;
    ASSERT_NEAR(a->distance, b->distance, 1e-12);
    ASSERT_NEAR(a->position.z, b->position.z, 1e-9);
  }
  EXPECT_GT(hits, 3000);
}

TEST(TeSurface, RaysMeetTheSurfaceOfTheLevelAskedFor) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(2, 4.0f), 17, 0.7);
  buildBlock(*database, 0, 3);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x)
      ASSERT_TRUE(database->buildCoarse({x, y, 1}));
  TeRandom random(1, 10, {});
  const double side = database->lattice().patchSide();
  int hits = 0, differ = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto anywhere = [&](double z) {
      return glm::dvec3(random.uniform(-0.45, 3.45) * side, random.uniform(-0.45, 3.45) * side, z);
    };
    const glm::dvec3 from = anywhere(random.uniform(-5, 15)), to = anywhere(random.uniform(-15, 5));
    const auto hit = database->intersect(from, to - from, 1, 1);
    const bool above = from.z > database->surfaceAt({from.x, from.y}, 1)->height;
    const bool ends = to.z > database->surfaceAt({to.x, to.y}, 1)->height;
    if (above != ends) {
      ASSERT_TRUE(hit) << i;
    }
    if (!hit)
      continue;
    ++hits;
    EXPECT_EQ(hit->key.level, 1);
    ASSERT_NEAR(hit->position.z, database->surfaceAt({hit->position.x, hit->position.y}, 1)->height, 1e-9);
    differ += std::fabs(hit->position.z - *database->heightAt({hit->position.x, hit->position.y})) > 1e-3;
    const auto down = database->intersect({hit->position.x, hit->position.y, 100}, {0, 0, -1}, INFINITY, 1);
    ASSERT_TRUE(down);
    ASSERT_NEAR(down->position.z, hit->position.z, 1e-9);
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(differ, 1000);
  EXPECT_FALSE(database->intersect({0, 0, 100}, {1, 0, -1}, INFINITY, 2));
  EXPECT_FALSE(database->intersect({0, 0, 100}, {1, 0, -1}, INFINITY, -1));
  EXPECT_FALSE(database->surfaceAt({0, 0}, 2));
  EXPECT_FALSE(database->surfaceAt({0, 0}, -1));
}

TEST(TeSurface, RaysOverUnknownLandCostNothing) {
  auto database = teSampleWorld([](std::int64_t, std::int64_t) { return 100.0f; }, 17);
  const std::int64_t far = 1 << 30;
  ASSERT_TRUE(database->build({0, 0, 0}));
  ASSERT_TRUE(database->build({far, 0, 0}));
  ASSERT_TRUE(database->build({far, far, 0}));
  const glm::dvec2 target = tePatchCentre(database->lattice(), {far, far, 0});
  const glm::dvec3 from(target.x - 6e9, target.y - 5e9, 100 + 1e9);
  const auto hit = database->intersect(from, {6, 5, -1}, std::numeric_limits<double>::infinity());
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->key, (TePatchKey{far, far, 0}));
  EXPECT_NEAR(hit->position.x, target.x, 1e-5);
  EXPECT_NEAR(hit->distance, 1e9, 1e-5);
  EXPECT_FALSE(database->intersect(from, {6, 5, -1}, 0.99e9));
  EXPECT_FALSE(database->intersect(from, {-6, -5, -1}, std::numeric_limits<double>::infinity()));
}

TEST(TeSurface, RaysStartOnTheSurfaceAndOnlyPointForward) {
  auto database = teSampleWorld([](std::int64_t, std::int64_t) { return 5.0f; }, 17);
  buildBlock(*database, 0, 0);
  EXPECT_EQ(database->intersect({1, 1, 5}, {1, 0, 0}, 1)->distance, 0);
  EXPECT_EQ(database->intersect({1, 1, 5}, {0, 0, 1}, 1)->distance, 0);
  EXPECT_FALSE(database->intersect({1, 1, 5.5}, {1, 0, 1}, 100));
  EXPECT_FALSE(database->intersect({1, 1, 5.5}, {0, 0, 1}, 100));
  EXPECT_EQ(database->intersect({1, 1, 4}, {0, 0, 2}, 100)->distance, 0.5);
  EXPECT_EQ(database->intersect({1, 1, 4}, {0.5, 0, 2}, 100)->distance, 0.5);
  EXPECT_FALSE(database->intersect({1, 1, 4}, {0.5, 0, 2}, 0.49));
  EXPECT_TRUE(database->intersect({1, 1, 4}, {1e-320, 0, 2}, 100));
  EXPECT_TRUE(database->intersect({1, 1, 4}, {0.5e300, 0, 2e300}, 100));
}

TEST(TeSurface, QueriesRunOnSeveralThreads) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17);
  buildBlock(*database, -2, 2);
  const auto sum = [&](std::uint64_t seed) {
    TeRandom random(seed, 3, {});
    double total = 0;
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec2 point(random.uniform(-19, 19), random.uniform(-19, 19));
      const auto hit = database->intersect({point, 300}, {0.1, -0.2, -30}, 100);
      total += *database->heightAt(point) + (hit ? hit->distance : 0);
    }
    return total;
  };
  const double expected[4] = {sum(0), sum(1), sum(2), sum(3)};
  double found[4] = {};
  std::vector<std::thread> threads;
  for (std::uint64_t t = 0; t < 4; ++t)
    threads.emplace_back([&, t] { found[t] = sum(t); });
  for (std::thread& thread : threads)
    thread.join();
  for (int t = 0; t < 4; ++t)
    EXPECT_EQ(found[t], expected[t]);
}
