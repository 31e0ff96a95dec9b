#pragma once

#include "patchdb/TePatchMesh.h"

#include <cmath>
#include <functional>

/// A mesh of columns × rows vertices from a global sample on, with heights from a function of the world
/// position and level normals.
inline TePatchMesh gridMesh(const TeLattice& lattice, std::int64_t firstX, std::int64_t firstY, int columns,
                            int rows, const std::function<float(double, double)>& height) {
  TePatchMesh mesh;
  mesh.columns = columns;
  mesh.rows = rows;
  const auto place = [&](std::int64_t sample) {
    return teMeshCoordinate(lattice, 0, lattice.position(sample));
  };
  mesh.origin = {place(firstX), place(firstY), 0};
  for (int row = 0; row < rows; row++) {
    for (int column = 0; column < columns; column++) {
      const double x = place(firstX + column);
      const double y = place(firstY + row);
      mesh.positions.emplace_back(x - mesh.origin.x, y - mesh.origin.y, height(x, y));
      mesh.normals.emplace_back(0, 0, 1);
    }
  }
  for (int row = 0; row + 1 < rows; row++) {
    for (int column = 0; column < columns; column++) {
      mesh.strips.push_back((row + 1) * columns + column);
      mesh.strips.push_back(row * columns + column);
    }
    mesh.strips.push_back(-1);
  }
  return mesh;
}
