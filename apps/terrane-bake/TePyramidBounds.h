#pragma once

#include "nodes/seamless/TeSeamlessLayout.h"

#include <functional>
#include <string>
#include <vector>

/// Measures the bounds for Seamless Patches on the highest level of a pyramid of heights, in the numbers of
/// its samples, and writes them beside it; returns the file's name. Memory: 8 MB and the bounds. Error: the
/// level cannot be read, or the file not written.
TeResult<std::string> teWritePyramidBounds(const std::string& name, const TeSeamlessLayout& layout,
                                           const std::function<void(double)>& progress);

/// The files of bounds that there are beside a pyramid, whatever their layouts, unfinished ones too.
std::vector<std::string> tePyramidBoundsBeside(const std::string& name);
