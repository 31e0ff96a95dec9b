#include "generators/joining/TeJoiningFaultBlock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

TeJoiningFaultBlock block(int columns, int rows, int samples = 33, int overlap = 1, std::uint64_t seed = 7) {
  TeJoiningFaultParameters parameters;
  parameters.columns = columns;
  parameters.rows = rows;
  parameters.samples = samples;
  parameters.overlap = overlap;
  parameters.worldSeed = seed;
  TeJoiningFaultBlock made = std::move(*TeJoiningFaultBlock::create(parameters));
  made.finish();
  return made;
}

/// A visible sample's height from the map's own faults alone, before overlaps are taken.
double ownHeight(const TeJoiningFaultBlock& b, int i, int j, int column, int row) {
  const int cells = b.parameters().samples - 1;
  std::int64_t sum = 0;
  for (int k = 0; k < b.formation().faults(); ++k) {
    const TeFaultLine line = b.fault(i, j, k).line(cells, 0);
    const std::int64_t cross = (line.bx - line.ax) * (256 * std::int64_t(row) + 128 - line.ay) -
                               (line.by - line.ay) * (256 * std::int64_t(column) + 128 - line.ax);
    sum += cross > 0 ? b.formation().amplitude(k) : 0;
  }
  return double(sum) * b.formation().unit();
}

/// Normal (not scaled) of a visible sample by central differences.
std::pair<float, float> slopes(const TeJoiningFaultBlock& b, int i, int j, int column, int row) {
  const int o = b.parameters().overlap;
  const TeHeightMap& map = b.map(i, j);
  const int x = column + o, y = row + o;
  return {map.at(x + 1, y) - map.at(x - 1, y), map.at(x, y + 1) - map.at(x, y - 1)};
}

} // namespace

TEST(TeJoiningFaultBlock, NeighboursHaveTheSameHeightsAndNormalsOnTheirBorder) {
  const TeJoiningFaultBlock b = block(4, 3);
  const int last = b.parameters().samples - 1;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i)
      for (int t = 0; t <= last; ++t) {
        if (i + 1 < 4) {
          EXPECT_EQ(b.map(i, j).at(last + 1, t + 1), b.map(i + 1, j).at(1, t + 1));
          EXPECT_EQ(slopes(b, i, j, last, t), slopes(b, i + 1, j, 0, t));
        }
        if (j + 1 < 3) {
          EXPECT_EQ(b.map(i, j).at(t + 1, last + 1), b.map(i, j + 1).at(t + 1, 1));
          EXPECT_EQ(slopes(b, i, j, t, last), slopes(b, i, j + 1, t, 0));
        }
      }
}

TEST(TeJoiningFaultBlock, AllSamplesThatTwoMapsShareAreTheSame) {
  for (int overlap : {1, 2, 5}) {
    const TeJoiningFaultBlock b = block(3, 3, 17, overlap);
    const int cells = 16, side = 17 + 2 * overlap;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di) {
            if (i + di < 0 || i + di > 2 || j + dj < 0 || j + dj > 2)
              continue;
            for (int y = std::max(0, dj * cells); y < std::min(side, side + dj * cells); ++y)
              for (int x = std::max(0, di * cells); x < std::min(side, side + di * cells); ++x)
                ASSERT_EQ(b.map(i, j).at(x, y), b.map(i + di, j + dj).at(x - di * cells, y - dj * cells));
          }
  }
}

// Joining is by the faults themselves, not by overwriting the border: each map's own faults give the
// neighbour's heights on the common side.
TEST(TeJoiningFaultBlock, FaultsGoOnInTheNeighbour) {
  const TeJoiningFaultBlock b = block(3, 3);
  const int last = b.parameters().samples - 1;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      for (int t = 0; t <= last; ++t) {
        if (i + 1 < 3) {
          EXPECT_EQ(ownHeight(b, i, j, last, t), ownHeight(b, i + 1, j, 0, t));
        }
        if (j + 1 < 3) {
          EXPECT_EQ(ownHeight(b, i, j, t, last), ownHeight(b, i, j + 1, t, 0));
        }
      }
}

TEST(TeJoiningFaultBlock, InsideTheOverlapsAMapHasTheHeightsOfItsOwnFaults) {
  const TeJoiningFaultBlock b = block(2, 2);
  const double level = ownHeight(b, 0, 0, 0, 0) - b.map(0, 0).at(1, 1);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i)
      for (int y = 2; y < 33; ++y)
        for (int x = 2; x < 33; ++x)
          EXPECT_NEAR(b.map(i, j).at(x + 1, y + 1), ownHeight(b, i, j, x, y) - level, 1e-4);
}

TEST(TeJoiningFaultBlock, AnySlicingGivesTheSameBits) {
  const TeJoiningFaultBlock whole = block(3, 2);
  TeJoiningFaultBlock sliced = std::move(*TeJoiningFaultBlock::create(whole.parameters()));
  int slices = 0;
  for (bool done = false; !done; ++slices) {
    TeAllowance one = TeAllowance::units(1);
    done = sliced.step(one);
  }
  EXPECT_GE(slices, 12);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(sliced.map(i, j), whole.map(i, j));
}

// Contract: a block is made from its south-west, so a part of it from there is the same whatever its size.
TEST(TeJoiningFaultBlock, ALargerBlockBeginsWithTheSmallerOne) {
  const TeJoiningFaultBlock small = block(2, 2);
  const TeJoiningFaultBlock large = block(3, 4);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ(small.map(i, j), large.map(i, j));
}

TEST(TeJoiningFaultBlock, UsesAllTwelveTypes) {
  const TeJoiningFaultBlock b = block(5, 5);
  int used[13] = {};
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i)
      for (int k = 0; k < b.formation().faults(); ++k)
        ++used[b.fault(i, j, k).type.number()];
  for (int number = 1; number <= 12; ++number)
    EXPECT_GT(used[number], 25 * 150 / 100) << number;
}

TEST(TeJoiningFaultBlock, RefusesWhatCannotBeMade) {
  const auto refused = [](auto change) {
    TeJoiningFaultParameters parameters;
    change(parameters);
    return !TeJoiningFaultBlock::create(parameters).ok();
  };
  using P = TeJoiningFaultParameters;
  EXPECT_FALSE(refused([](P&) {}));
  EXPECT_TRUE(refused([](P& p) { p.columns = 0; }));
  EXPECT_TRUE(refused([](P& p) { p.rows = -1; }));
  EXPECT_TRUE(refused([](P& p) { p.columns = p.rows = 2000000000; }));
  EXPECT_TRUE(refused([](P& p) { p.samples = 2; }));
  EXPECT_TRUE(refused([](P& p) { p.samples = 16386; }));
  EXPECT_TRUE(refused([](P& p) { p.overlap = 0; }));
  EXPECT_TRUE(refused([](P& p) { p.overlap = 65; }));
  EXPECT_TRUE(refused([](P& p) { p.faults.profile = "smooth"; }));
  EXPECT_TRUE(refused([](P& p) { p.faults.first = NAN; }));
  EXPECT_TRUE(refused([](P& p) {
    p.faults.faults = 100000;
    p.columns = p.rows = 100;
    p.samples = 3;
  }));
}
