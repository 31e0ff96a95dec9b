#pragma once

#include "patchdb/TeSurfaceCell.h"

// TeSurfaceCell::height() within reach of the optimiser, for sources of this library that ask it for every
// point. The far edges have a formula of their own: a difference of two heights of very different size may be
// rounded, and corners must come out exactly. Inside, which triangle a point lies in cannot be foretold: it
// is an index, not a branch.
inline double teInnerHeight(const TeSurfaceCell& cell, double u, double v) {
  const int south = u >= v ? 1 : 0;
  const float corners[2] = {cell.northWest, cell.southEast};
  const double corner = corners[south];
  const double steps[2] = {cell.northEast - corner, corner - cell.southWest};
  return cell.southWest + u * steps[south] + v * steps[1 - south];
}

inline double teCellHeight(const TeSurfaceCell& cell, double u, double v) {
  if (u == 1 && v == 1)
    return cell.northEast;
  if (u == 1)
    return cell.southEast + v * (double(cell.northEast) - cell.southEast);
  if (v == 1)
    return cell.northWest + u * (double(cell.northEast) - cell.northWest);
  return teInnerHeight(cell, u, v);
}
