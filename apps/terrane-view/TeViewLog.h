#pragma once

#include "apps/terrane-view/TeLodNodes.h"

#include <nlohmann/json.hpp>

#include <vector>

/// What the frames of a run were like, for the report.
class TeViewLog {
public:
  /// `seconds` to draw it, OpenGL included.
  void add(double seconds, const TeSeamlessStatistics& figures);
  int frames() const { return int(m_frames.size()); }
  double meanSeconds() const;
  double longestSeconds() const;

  /// Median, mean and worst of each figure over all frames, and sums. The figures of LOD shapes, or those
  /// that only Seamless Patches have, are left out where there is none.
  void describe(bool shapes, bool seamless, nlohmann::ordered_json& report) const;

private:
  struct Frame {
    double seconds = 0;
    TeSeamlessStatistics figures;
  };
  std::vector<Frame> m_frames;
};
