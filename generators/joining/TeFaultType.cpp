#include "generators/joining/TeFaultType.h"

#include <cassert>

namespace {

constexpr int bit(TeMapCorner corner) { return 1 << int(corner); }

constexpr int kSouthWest = bit(TeMapCorner::SouthWest);
constexpr int kSouthEast = bit(TeMapCorner::SouthEast);
constexpr int kNorthEast = bit(TeMapCorner::NorthEast);
constexpr int kNorthWest = bit(TeMapCorner::NorthWest);
constexpr int kAll = kSouthWest | kSouthEast | kNorthEast | kNorthWest;

/// Corners raised by types 1 to 6; types 7 to 12 raise the others.
constexpr int kRaised[6] = {kNorthWest, kNorthWest | kSouthWest, kAll & ~kSouthEast,
                            kNorthEast, kNorthWest | kNorthEast, kAll & ~kSouthWest};

} // namespace

TeFaultType TeFaultType::numbered(int number) {
  assert(number >= 1 && number <= 12);
  return TeFaultType(number);
}

bool TeFaultType::raises(TeMapCorner corner) const {
  const bool inFirstSix = (kRaised[(m_number - 1) % 6] & bit(corner)) != 0;
  return m_number <= 6 ? inFirstSix : !inFirstSix;
}

bool TeFaultType::meets(TeMapSide side) const { return raises(firstEnd(side)) != raises(secondEnd(side)); }

bool TeFaultType::fits(TeMapSide side, TeFaultType neighbour) const {
  const TeMapSide shared = opposite(side);
  return raises(firstEnd(side)) == neighbour.raises(firstEnd(shared)) &&
         raises(secondEnd(side)) == neighbour.raises(secondEnd(shared));
}

std::vector<TeFaultType> TeFaultType::fitting(TeMapSide side) const {
  std::vector<TeFaultType> types;
  for (int number = 1; number <= 12; ++number)
    if (fits(side, TeFaultType(number)))
      types.push_back(TeFaultType(number));
  return types;
}

TeMapCorner TeFaultType::firstEnd(TeMapSide side) {
  switch (side) {
  case TeMapSide::East:
    return TeMapCorner::SouthEast;
  case TeMapSide::North:
    return TeMapCorner::NorthWest;
  case TeMapSide::South:
  case TeMapSide::West:
    break;
  }
  return TeMapCorner::SouthWest;
}

TeMapCorner TeFaultType::secondEnd(TeMapSide side) {
  switch (side) {
  case TeMapSide::South:
    return TeMapCorner::SouthEast;
  case TeMapSide::West:
    return TeMapCorner::NorthWest;
  case TeMapSide::East:
  case TeMapSide::North:
    break;
  }
  return TeMapCorner::NorthEast;
}

TeMapSide TeFaultType::opposite(TeMapSide side) { return TeMapSide((int(side) + 2) % 4); }
