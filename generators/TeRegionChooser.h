#pragma once

#include "generators/TeSourceChooser.h"

#include <vector>

/// Chooses by region of map keys: the source of the last region that holds the key, else the one for
/// everywhere. Where regions meet, four-map blending leads from one landscape to the other, over the width of
/// one source map.
class TeRegionChooser final : public TeSourceChooser {
public:
  /// `everywhere` must not be null, as the sources below.
  explicit TeRegionChooser(TeHeightSourcePtr everywhere);

  /// Maps (x, y) with west ≤ x ≤ east and south ≤ y ≤ north. Error: a rectangle that holds no key.
  TeStatus addRectangle(TeMapKey southWest, TeMapKey northEast, TeHeightSourcePtr source);
  /// Maps whose key is at most `radius` keys from the centre's, 0 to 2^47 (TeLattice::kMaxKey). Error: a
  /// radius or centre outside that range.
  TeStatus addDisc(TeMapKey centre, std::int64_t radius, TeHeightSourcePtr source);
  /// Every second one of squares of `side` × `side` maps, like the black fields of a chess board; the square
  /// with its south-west at key (0, 0) is one of them. Error: a side that is not positive.
  TeStatus addChequers(std::int64_t side, TeHeightSourcePtr source);

  TeHeightSourcePtr choose(const TeMapKey& key) const override;
  /// Only if it can choose one source alone, and that one fits: two fitting sources disagree with each other.
  bool fits() const override;
  bool pointEvaluable() const override;

private:
  enum class Shape { Rectangle, Disc, Chequers };
  struct Region {
    Shape shape;
    TeMapKey a;        ///< south-west corner; centre
    TeMapKey b;        ///< north-east corner
    std::int64_t size; ///< radius; side
    TeHeightSourcePtr source;
    bool holds(const TeMapKey& key) const;
  };

  TeHeightSourcePtr m_everywhere;
  std::vector<Region> m_regions;
};
