#pragma once

#include <functional>
#include <string>

/// Files that terrane-view is given in tests.
struct TeViewInputs {
  using Height = std::function<double(double x, double y)>;

  /// Hills within a square of 0 .. 1: metres, of a terrain of 1000 m.
  static double hills(double x, double y);
  /// Arc ASCII grid of samples × samples posts `step` metres apart; x and y of the heights go from 0 to 1.
  /// NaN is "no data".
  static void writeGrid(const std::string& path, int samples, double step, const Height& height);
  /// Level files NAME_0.raw to NAME_top.raw, in steps of `unit` metres, without a description.
  static void writePyramid(const std::string& name, int top, double unit, const Height& height);
};
