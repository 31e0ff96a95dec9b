#pragma once

#include <cstddef>
#include <vector>

/// Boxes and errors of the triangles of a mesh, an array for each number, so that all priorities of a frame
/// are one pass of vectors. Boxes of children lie within those of their parents.
struct TeRoamBoxes {
  std::vector<float> x; ///< south-west of the triangle's square, in cells
  std::vector<float> y;
  std::vector<float> size; ///< cells
  std::vector<float> low;  ///< in the unit of the samples
  std::vector<float> high;
  std::vector<float> error; ///< in that unit; negative: there is no triangle

  void resize(std::size_t count) {
    for (std::vector<float>* numbers : {&x, &y, &size, &low, &high})
      numbers->resize(count, 0.0f);
    error.resize(count, -1.0f);
  }
  std::size_t bytes() const { return 6 * x.capacity() * sizeof(float); }
};
