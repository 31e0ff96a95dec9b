#pragma once

#include <cstdint>
#include <functional>

/// Finds how much coarser a mesh has to be to keep a budget.
class TeMeshBudget {
public:
  static constexpr double kUsed = 0.95; ///< of the budget, at least, where it is needed
  static constexpr int kTries = 12;     ///< to come so close

  /// `triangles` makes a mesh that is so many times coarser and returns its triangles, about in inverse
  /// proportion. The last call made the mesh of the result, at least 1: one that keeps the budget, unless
  /// even the coarsest does not. A result is the same as `start` if that uses enough of the budget.
  static double search(std::int64_t budget, double start,
                       const std::function<std::int64_t(double)>& triangles);
};
