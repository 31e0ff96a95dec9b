#pragma once

#include "engine/paths/TePath.h"

/// "line", "circle", "zigzag", "teleport".
const std::vector<std::string>& tePathNames();

/// A path of that name through `start`, where it begins northwards; it goes on for ever. z is kept, as an
/// altitude or a height above ground.
///
/// line: straight north. circle: to the left, kTeCircleRadius. zigzag: north-east and north-west by turns,
/// with rounded corners. teleport: legs of kTeTeleportLeg north, with jumps to 10^6, 10^9 and 10^11 m east
/// (more than 2^31 patches of 32 m away), as far to the west and south, and back. Error: an unknown name, or
/// a start so far out that the path would leave TePath's range.
TeResult<TePath> teNamedPath(const std::string& name, const glm::dvec3& start, bool aboveGround);

inline constexpr double kTeCircleRadius = 150; ///< metres
inline constexpr double kTeTeleportLeg = 60;
