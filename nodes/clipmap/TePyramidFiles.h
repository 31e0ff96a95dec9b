#pragma once

#include <string>

/// A pyramid on disk: level i has 2^i + 1 samples a side, in `NAME_i.raw`: headerless, row by row from the
/// north, columns from the west, heights in 16 bits without sign (low byte first), colours in 3 or 4 bytes.
/// Level i is every second sample of every second row of level i + 1.
inline constexpr int kTeHighestPyramidLevel = 16;

/// The file of a level, 0 .. kTeHighestPyramidLevel.
std::string tePyramidLevelFile(const std::string& name, int level);

/// Samples a side of a level.
inline int tePyramidSide(int level) { return (1 << level) + 1; }

/// The level with so many samples a side, at least 1; -1 if there is none.
int tePyramidLevelOfSide(long long side);
