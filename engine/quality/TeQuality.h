#pragma once

#include "generators/base/TeResult.h"

#include <array>

/// Holds a goal for what drawing a frame takes by choosing the pixel error of the level of detail.
///
/// No clock and no OpenGL: it is told what each frame cost and says which error the next one is to be drawn
/// with. In logarithms a frame's cost falls with the error, by an *elasticity* between 0 and about 2 that
/// nobody knows beforehand (fixed costs make it small): the controller measures at one error, goes to the
/// error that the elasticity makes of the cost's distance from the goal, and learns the elasticity from what
/// came of it.
///
/// * Monotone: in the same state, a dearer frame never leads to a smaller error than a cheaper one.
/// * Hysteresis: nothing changes while the cost is within kDeadBand of the goal, or within what the frames'
///   own noise explains, nor before a change has lasted for a moment. A single odd frame changes nothing.
/// * No oscillation: if less error proved too dear, it is tried once more, half as far, and then not again
///   until frames are cheaper by kNews, or kPatience seconds have passed, each time in vain four times as
///   many. So where neither load nor noise of the scene explains it, the error changes its direction four
///   times and then twice in 1, 4, 16 … times kPatience; and where load or noise did, it is not held for
///   true for ever. kPatience counts in frames that take as long as the goal.
/// * Smooth: the error grows by no more than a factor of 2, and falls by no more than the root of 2, in
///   kDoubling seconds or in a frame, whichever is less.
///
/// Frames may be late by kLatency: their cost may be that of an error chosen so many frames before.
/// Cost: about a microsecond a frame. One thread at a time.
class TeQuality {
public:
  static constexpr double kLeastGoal = 1e-4; ///< seconds
  static constexpr double kMostGoal = 10;
  static constexpr double kFinest = 0.5; ///< pixels, by default
  static constexpr double kCoarsest = 32;
  static constexpr double kMostPixels = 1024;
  static constexpr double kDeadBand = 0.05; ///< of the cost, as its logarithm
  static constexpr double kNews = 0.1;
  static constexpr double kDoubling = 0.1; ///< seconds
  static constexpr double kPatience = 1;   ///< seconds
  static constexpr int kLatency = 1;       ///< frames

  TeQuality();

  /// Seconds that a frame is to cost, kLeastGoal to kMostGoal, or 0: the error stays as it is. Error
  /// otherwise, and nothing changed.
  TeStatus setGoal(double seconds);
  /// 0 = none.
  double goal() const { return m_goal; }
  bool governs() const { return m_goal > 0; }
  /// Pixels, 0 < finest <= coarsest <= kMostPixels. Error otherwise, and nothing changed.
  TeStatus setRange(double finest, double coarsest);
  double finest() const;
  double coarsest() const;

  /// What the next frame is to be drawn with, pixels, within the range. At first 1 pixel or what of the range
  /// is nearest to it.
  double pixelError() const;
  /// A frame was drawn and cost so many seconds. Values that are not more than 0 or not finite are ignored.
  void frameDrawn(double seconds);
  /// True while the error is on its way to another value.
  bool moving() const { return m_error != m_target; }

private:
  static constexpr int kWindow = 32; ///< frames at one error that are looked at
  static constexpr int kScales = 5;  ///< 1, 2, … 16 frames

  void restart();
  void slew(double seconds, double cost);
  void measure(double cost);
  void decide();
  double estimate(int frames) const;
  bool mayFall(double cost) const;
  double band(int scale) const;
  void rise(double cost);
  void fall(double cost);
  void move(double target, double cost);
  void learn(double cost);
  void followNoise(double cost);
  double meanOf(int frames, int back) const;

  double m_goal = 0;
  // Logarithms: of pixels, and of cost over goal.
  double m_least;
  double m_most;
  double m_error = 0;
  double m_target = 0;
  std::array<double, kWindow> m_costs{}; ///< of the last frames at this error; a ring
  int m_frames = 0;
  int m_blind = 0;                     ///< frames that may still be those of another error
  double m_lastCost = 0;               ///< of the frame before
  std::array<double, kScales> m_noise; ///< standard deviations of the mean of 1, 2, … frames
  double m_elasticity = 1;
  int m_direction = 0; ///< of the last move
  bool m_learns = false;
  double m_errorBefore = 0; ///< of the last move
  double m_costBefore = 0;
  int m_failures = 0;       ///< less error proved too dear so many times
  double m_dearError = 0;   ///< the last time
  double m_safeError = 0;   ///< from where that was tried
  bool m_restKnown = false; ///< m_restCost is
  double m_restCost = 0;    ///< where it came to rest after that
};
