#include "patchdb/TePatchMesh.h"

#include <cmath>

double teMeshScale(const TeLattice& lattice, int level) {
  int exponent;
  std::frexp(lattice.patchSide(), &exponent); // patchSide in [2^(exponent-1), 2^exponent)
  return std::ldexp(1.0, 24 - exponent - level);
}

double teMeshCoordinate(const TeLattice& lattice, int level, double position) {
  const double scale = teMeshScale(lattice, level);
  return std::nearbyint(position * scale) / scale;
}
