#pragma once

#include <vector>

enum class TeMapSide { South, East, North, West };
enum class TeMapCorner { SouthWest, SouthEast, NorthEast, NorthWest };

/// One of the 12 ways in which a fault can cut a map (document 002, figure 4.2): which two sides its line
/// meets, and which part rises.
///
///      1  west-north     2  north-south    3  east-south
///      4  north-east     5  west-east      6  west-south
///
/// raise the northern part (2: the western one); type n + 6 is the same line with the other part raised.
///
/// A type is the same thing as which of the map's corners rise: one, all but one, or two of one side; the
/// line meets the sides whose ends differ. So a type fits a neighbour's if the two corners that they share
/// agree, and a fault crossing the side between them then goes on on the other side, its raised part too.
/// (The document's figure with the numbers is lost; these are consistent with its one example: type 9 below
/// allows 1, 4 or 5 above.)
class TeFaultType {
public:
  /// 1 .. 12.
  static TeFaultType numbered(int number);

  int number() const { return m_number; }
  bool raises(TeMapCorner corner) const;
  /// The line meets the side, between its ends; true for two sides.
  bool meets(TeMapSide side) const;
  /// The neighbour that lies beyond one's side may have such a fault where this map has this one.
  bool fits(TeMapSide side, TeFaultType neighbour) const;
  /// All types that fit beyond a side, in the order of their numbers: three.
  std::vector<TeFaultType> fitting(TeMapSide side) const;

  /// The ends of a side, the southern or western one first.
  static TeMapCorner firstEnd(TeMapSide side);
  static TeMapCorner secondEnd(TeMapSide side);
  static TeMapSide opposite(TeMapSide side);

  friend bool operator==(TeFaultType a, TeFaultType b) { return a.m_number == b.m_number; }

private:
  explicit TeFaultType(int number) : m_number(number) {}

  int m_number;
};
