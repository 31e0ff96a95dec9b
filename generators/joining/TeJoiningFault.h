#pragma once

#include "generators/faults/TeFaultPlane.h"
#include "generators/joining/TeFaultType.h"

#include <cstdint>

/// One fault of a joining map: its type, and where its line meets the two sides. Coordinates are 1/256 of a
/// sample from the side's southern or western end, between the ends and never at a sample.
struct TeJoiningFault {
  TeFaultType type = TeFaultType::numbered(1);
  std::int32_t at[4] = {0, 0, 0, 0}; ///< by TeMapSide; only of sides that the line meets

  std::int32_t& on(TeMapSide side) { return at[int(side)]; }
  std::int32_t on(TeMapSide side) const { return at[int(side)]; }

  /// The line in a map whose side is `cells` cells and that goes on for `overlap` samples beyond each side.
  TeFaultLine line(int cells, int overlap) const;
};
