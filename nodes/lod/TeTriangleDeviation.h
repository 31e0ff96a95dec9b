#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/lod/TeLodMesh.h"

/// Largest vertical deviation of the samples that a triangle covers, its rim included, from its plane; in the
/// unit of the samples. Computed in double precision and rounded up, so it is a bound. Corners lie on samples
/// of `heights` and have these heights; the triangle has an area.
///
/// Cost: a pass over the samples, about 1 ns each and some 20 ns a row.
float teTriangleDeviation(const TeHeightMap& heights, const TeLodVertex& a, const TeLodVertex& b,
                          const TeLodVertex& c);
