#pragma once

#include "generators/TeHeightSource.h"
#include "generators/circles/TeCircles.h"
#include "generators/faults/TeFaultFormation.h"
#include "generators/midpoint/TeMidpointDisplacement.h"

#include <vector>

/// The generators' formulas once more, in double precision throughout and as plainly as they are written
/// down: what single precision, fixed point and polynomials of the real ones are measured against. By rows,
/// row 0 in the south; metres.
using TeDoubleHeights = std::vector<double>;

/// Step profile only: a side test for each sample and fault, amplitudes that are not rounded.
TeDoubleHeights tePlainFaults(const TeFaultFormation& source, const TeMapRequest& request);
/// A cosine of the C library for each sample of each circle.
TeDoubleHeights tePlainCircles(const TeCircles& source, const TeMapRequest& request);
/// No rounding between the levels.
TeDoubleHeights tePlainMidpoint(const TeMidpointDisplacement& source, const TeMapRequest& request);
/// `passes` passes of the band filter in place.
void tePlainBand(TeDoubleHeights& heights, int columns, int rows, double k, int passes);

TeDoubleHeights teInDouble(const TeHeightMap& map);
