#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The frames of a program that holds a goal, under a load that changes at known times.
struct TeQualityTrace {
  struct Frame {
    double time = 0;       ///< seconds, at its end
    double load = 1;       ///< factor
    double seconds = 0;    ///< that drawing took
    double pixelError = 0; ///< that was wanted of it
    double bound = 0;      ///< pixels; 0 = not known
    std::int64_t triangles = 0;
  };
  /// A change of the load: from `begin` to `end`, seconds.
  struct Step {
    double begin = 0;
    double end = 0;
    double load = 1;
  };

  std::string name;
  double goal = 0; ///< seconds that drawing is to take
  std::vector<Frame> frames;
  std::vector<Step> steps;

  /// Seconds from the beginning of a step until the median of kMedian frames, of which the last one is the
  /// frame, is within `part` of the goal; none: it was never.
  std::optional<double> returned(const Step& step, double part = 0.1) const;
  /// Median of the cost over the goal, from a second after the step's beginning on; NaN without frames.
  double settledCost(const Step& step) const;
  /// How often the wanted error changed its direction from a second after the step's beginning on.
  int turns(const Step& step) const;
  static constexpr int kMedian = 5;
};
