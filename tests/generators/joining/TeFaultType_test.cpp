#include "generators/joining/TeFaultType.h"

#include "generators/base/TeRandom.h"
#include "generators/joining/TeJoiningFault.h"

#include <gtest/gtest.h>

#include <set>

namespace {

constexpr TeMapSide kSides[] = {TeMapSide::South, TeMapSide::East, TeMapSide::North, TeMapSide::West};
constexpr int kCells = 8;

std::set<int> numbers(const std::vector<TeFaultType>& types) {
  std::set<int> set;
  for (TeFaultType type : types)
    set.insert(type.number());
  return set;
}

TeJoiningFault randomFault(TeFaultType type, TeRandom& random) {
  TeJoiningFault fault;
  fault.type = type;
  for (TeMapSide side : kSides)
    fault.on(side) = std::int32_t(256 * random.below(kCells) + 1 + random.below(255));
  if (fault.on(TeMapSide::West) == fault.on(TeMapSide::East))
    fault.on(TeMapSide::East) ^= 2;
  return fault;
}

bool raised(const TeJoiningFault& fault, int column, int row) {
  const TeFaultPlane plane = TeFaultPlane::step(fault.line(kCells, 0), 1);
  return plane.stepHeight(plane.value(column, row)) + plane.base > 0;
}

/// Which of the samples along a side rise, from its southern or western end.
std::vector<bool> along(const TeJoiningFault& fault, TeMapSide side) {
  std::vector<bool> pattern;
  for (int t = 0; t <= kCells; ++t)
    switch (side) {
    case TeMapSide::South:
      pattern.push_back(raised(fault, t, 0));
      break;
    case TeMapSide::East:
      pattern.push_back(raised(fault, kCells, t));
      break;
    case TeMapSide::North:
      pattern.push_back(raised(fault, t, kCells));
      break;
    case TeMapSide::West:
      pattern.push_back(raised(fault, 0, t));
      break;
    }
  return pattern;
}

} // namespace

TEST(TeFaultType, TypeNineBelowAllowsOneFourAndFiveAbove) {
  EXPECT_EQ(numbers(TeFaultType::numbered(9).fitting(TeMapSide::North)), (std::set<int>{1, 4, 5}));
}

TEST(TeFaultType, TwelveDifferentTypesEachMeetingTwoSides) {
  std::set<int> patterns;
  for (int number = 1; number <= 12; ++number) {
    const TeFaultType type = TeFaultType::numbered(number);
    int met = 0;
    int pattern = 0;
    for (TeMapSide side : kSides) {
      met += type.meets(side) ? 1 : 0;
      pattern = 2 * pattern + (type.raises(TeMapCorner(int(side))) ? 1 : 0);
    }
    EXPECT_EQ(met, 2) << number;
    patterns.insert(pattern);
  }
  EXPECT_EQ(patterns.size(), 12u);
}

// The table against geometry: a line of the type, drawn with random ends, raises exactly the type's corners,
// and changes along exactly the sides that it meets.
TEST(TeFaultType, LinesCutTheMapAsTheirTypeSays) {
  TeRandom random(1, 2, {});
  for (int number = 1; number <= 12; ++number)
    for (int repeat = 0; repeat < 50; ++repeat) {
      const TeJoiningFault fault = randomFault(TeFaultType::numbered(number), random);
      EXPECT_EQ(raised(fault, 0, 0), fault.type.raises(TeMapCorner::SouthWest)) << number;
      EXPECT_EQ(raised(fault, kCells, 0), fault.type.raises(TeMapCorner::SouthEast)) << number;
      EXPECT_EQ(raised(fault, kCells, kCells), fault.type.raises(TeMapCorner::NorthEast)) << number;
      EXPECT_EQ(raised(fault, 0, kCells), fault.type.raises(TeMapCorner::NorthWest)) << number;
    }
}

// The compatibility of all 12·4·12 pairs, decided from samples along the common side: two faults fit exactly
// if they raise the same ones, given the same coordinate where both meet the side.
TEST(TeFaultType, TypesFitExactlyIfTheyRaiseTheSamePartOfTheCommonSide) {
  TeRandom random(3, 4, {});
  for (int a = 1; a <= 12; ++a)
    for (TeMapSide side : kSides) {
      int fitting = 0;
      for (int b = 1; b <= 12; ++b) {
        const TeMapSide shared = TeFaultType::opposite(side);
        const TeJoiningFault one = randomFault(TeFaultType::numbered(a), random);
        TeJoiningFault other = randomFault(TeFaultType::numbered(b), random);
        other.on(shared) = one.on(side);
        if (other.on(side) == other.on(shared))
          other.on(side) ^= 2;
        const bool same = along(one, side) == along(other, shared);
        EXPECT_EQ(one.type.fits(side, other.type), same) << a << " " << b << " side " << int(side);
        fitting += same ? 1 : 0;
      }
      EXPECT_EQ(fitting, 3);
      EXPECT_EQ(TeFaultType::numbered(a).fitting(side).size(), 3u);
    }
}
