#pragma once

#include "generators/base/TeResult.h"

#include <array>

/// How many seconds the next tick may spend.
///
/// Without a wanted frame rate: a fixed budget. With one: what a frame leaves after drawing and all else,
/// less a margin, within kLeast and half a frame. The budget falls within a few frames and rises in tens, so
/// that one slow frame changes nothing and noise makes it no wave. A frame that took about as long as wanted
/// may have been waited out by the display; how much of it was free is then found by letting the budget creep
/// up (by kCreep a frame) until frames come late.
class TeFrameBudget {
public:
  static constexpr double kDefault = 0.004;
  static constexpr double kLeast = 0.0005; ///< with a frame rate; more than the smallest unit
  static constexpr double kMost = 1;
  static constexpr double kLowestRate = 1; ///< frames a second
  static constexpr double kHighestRate = 1000;
  static constexpr double kMargin = 0.1; ///< of a frame
  static constexpr double kCreep = 0.001;

  /// Seconds, more than 0 and at most kMost. Error otherwise, and nothing changed.
  TeStatus setBudget(double seconds);
  /// Frames a second, kLowestRate .. kHighestRate, or 0 for a fixed budget. Error otherwise, and nothing
  /// changed.
  TeStatus setFrameRate(double framesPerSecond);
  double frameRate() const { return m_rate; }

  /// Seconds of the next tick in all.
  double budget() const { return m_rate > 0 ? m_adapted : m_fixed; }
  /// What slices may spend of it: less the longest recent unit, which may be begun at the last moment, but
  /// not less than an eighth.
  double allowance() const;
  double reserve() const { return m_reserve; }

  /// A tick has ended: its seconds in all, and those of its longest unit.
  void tickDone(double tickSeconds, double longestUnit);
  /// A frame was drawn: seconds of the wall clock since the frame before, and those for drawing it. Values
  /// that are negative or not finite are ignored.
  void frameDrawn(double frameSeconds, double drawSeconds);

private:
  double frame() const { return 1 / m_rate; }

  double m_fixed = kDefault;
  double m_rate = 0;
  double m_adapted = kDefault;
  double m_reserve = 0.00025;
  double m_tick = 0;
  double m_draw = 0; ///< drawing and the rest of a frame, rather too long than too short
  double m_rest = 0;
  std::array<double, 3> m_lastRests{}; ///< of the last frames
  std::size_t m_frames = 0;
};
