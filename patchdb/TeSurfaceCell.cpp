#include "patchdb/TeSurfaceCell.h"

// The far edges have a formula of their own: a difference of two heights of very different size may be
// rounded, and corners must come out exactly.
double TeSurfaceCell::height(double u, double v) const {
  if (u == 1 && v == 1)
    return northEast;
  if (u == 1)
    return southEast + v * (double(northEast) - southEast);
  if (v == 1)
    return northWest + u * (double(northEast) - northWest);
  if (u >= v)
    return southWest + u * (double(southEast) - southWest) + v * (double(northEast) - southEast);
  return southWest + u * (double(northEast) - northWest) + v * (double(northWest) - southWest);
}

glm::dvec3 TeSurfaceCell::normal(double u, double v, double spacing) const {
  const bool south = u >= v;
  const double x = south ? double(southWest) - southEast : double(northWest) - northEast;
  const double y = south ? double(southEast) - northEast : double(southWest) - northWest;
  const double length = std::sqrt(x * x + y * y + spacing * spacing);
  return {x / length, y / length, spacing / length};
}

double TeSurfaceCell::deviation() const {
  return std::fabs((double(southWest) - southEast) + (double(northEast) - northWest)) / 2;
}
