#pragma once

#include "nodes/lod/TeLodField.h"
#include "nodes/lod/TeLodView.h"
#include "nodes/lod/roam/TeRoamBoxes.h"

#include <cstddef>

/// A view of a terrain, made ready to give many triangles their priorities: the screen error in pixels that a
/// triangle may have, error · focal length / distance to its box, rounded up; the largest number of a float
/// for one that has no bound (the eye is in the box); -1 if the box is not in view.
///
/// Priorities never rise from a triangle to its children: errors and boxes are nested, and all arithmetic is
/// monotone. The same bits for any number of triangles at a time.
class TeRoamScreen {
public:
  /// `least`: of triangles in view, whatever their error.
  TeRoamScreen(const TeLodField& field, const TeLodView& view, float least);

  /// Of entries first .. first + count - 1. Cost: about 2 ns each.
  void priorities(const TeRoamBoxes& boxes, std::size_t first, std::size_t count, float* result) const;

  /// A plane that bounds what is seen: the farthest point of a box is inside if
  /// x·(x + size·east) + y·(y + size·north) + low·low + high·high + w is not negative.
  struct Plane {
    double x = 0, east = 0, y = 0, north = 0, low = 0, high = 0, w = 0;
  };
  /// All in cells and units of samples, relative to the terrain's corner.
  struct Numbers {
    double eye[3] = {0, 0, 0};
    double scale[3] = {1, 1, 1}; ///< metres a cell and unit
    double slack = 0;            ///< metres
    double focal = 0;            ///< pixels of a unit of height at one metre
    double perspective = 1;      ///< 0: orthographic
    double least = 0;
    Plane planes[6];
    int planeCount = 0;
  };

private:
  Numbers m_numbers;
};
