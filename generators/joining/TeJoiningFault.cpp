#include "generators/joining/TeJoiningFault.h"

#include <utility>

TeFaultLine TeJoiningFault::line(int cells, int overlap) const {
  const std::int64_t origin = 256 * std::int64_t(overlap) + 128;
  const std::int64_t side = 256 * std::int64_t(cells);
  std::int64_t x[2] = {0, 0};
  std::int64_t y[2] = {0, 0};
  int ends = 0;
  for (TeMapSide s : {TeMapSide::South, TeMapSide::East, TeMapSide::North, TeMapSide::West}) {
    if (!type.meets(s))
      continue;
    const bool level = s == TeMapSide::South || s == TeMapSide::North;
    x[ends] = level ? on(s) : (s == TeMapSide::East ? side : 0);
    y[ends] = level ? (s == TeMapSide::North ? side : 0) : on(s);
    ++ends;
  }
  // The raised part is to the left of the way from the first end to the second.
  const bool southWestIsLeft = (x[1] - x[0]) * -y[0] - (y[1] - y[0]) * -x[0] > 0;
  if (southWestIsLeft != type.raises(TeMapCorner::SouthWest)) {
    std::swap(x[0], x[1]);
    std::swap(y[0], y[1]);
  }
  return {origin + x[0], origin + y[0], origin + x[1], origin + y[1]};
}
