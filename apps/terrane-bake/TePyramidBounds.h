#pragma once

#include "nodes/seamless/TeSeamlessLayout.h"

#include <functional>
#include <string>

/// Measures the bounds for Seamless Patches on the highest level of a pyramid of heights, in the numbers of
/// its samples, and writes them beside it; returns the file's name. Memory: 8 MB and the bounds. Error: the
/// level cannot be read, or the file not written.
TeResult<std::string> teWritePyramidBounds(const std::string& name, const TeSeamlessLayout& layout,
                                           const std::function<void(double)>& progress);

/// Removes bounds of all layouts beside a pyramid.
void teRemovePyramidBounds(const std::string& name);
