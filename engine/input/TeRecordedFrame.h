#pragma once

#include "engine/input/TeKeyEvent.h"

#include <cstdint>
#include <optional>
#include <vector>

/// What happened in a frame of a run.
struct TeRecordedFrame {
  double dt = 0;                ///< seconds, ≥ 0
  std::vector<TeKeyEvent> keys; ///< posted before the frame's tick, in order
  /// TeEngine::stateHash() after the tick, of runs that repeat to the bit.
  std::optional<std::uint64_t> stateHash;

  friend bool operator==(const TeRecordedFrame& a, const TeRecordedFrame& b) {
    return a.dt == b.dt && a.keys == b.keys && a.stateHash == b.stateHash;
  }
};
