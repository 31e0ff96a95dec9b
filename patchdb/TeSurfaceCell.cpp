#include "patchdb/TeSurfaceCell.h"

#include "patchdb/TeSurfaceCell.inl"

double TeSurfaceCell::height(double u, double v) const { return teCellHeight(*this, u, v); }

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
