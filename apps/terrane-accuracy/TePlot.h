#pragma once

#include "generators/base/TeResult.h"

#include <string>
#include <vector>

/// A diagram of curves, drawn by the program gnuplot where it is installed.
struct TePlot {
  struct Curve {
    std::string name;
    std::vector<double> x;
    std::vector<double> y; ///< as many; points that are not finite are left out
  };

  std::string title;
  std::string xLabel; ///< with unit
  std::string yLabel;
  bool logX = true; ///< points that are not positive are left out
  bool logY = true;
  std::vector<Curve> curves;
  bool markers = true; ///< at the points
  /// A vertical line at x, for what has no y to show.
  struct Line {
    std::string name;
    double x = 0;
  };
  std::vector<Line> lines{};

  /// The text that gnuplot reads, with its data in itself. `terminal`: "svg" or "png".
  std::string script(const std::string& terminal, const std::string& output) const;
  /// Writes FILE.gp, FILE.svg and FILE.png. Error: a file that cannot be written, gnuplot is missing or
  /// fails.
  TeStatus write(const std::string& file) const;

  static bool available();
};
