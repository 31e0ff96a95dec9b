#pragma once

#include "generators/TeHeightSource.h"
#include "generators/circles/TeCircles.h"

/// Makes a map by the circles algorithm: adds circle after circle to the map, each in its bounding box alone.
/// A unit is a bounded number of circles and samples.
class TeCirclesJob final : public TeHeightJob {
public:
  TeCirclesJob(std::shared_ptr<const TeCircles> source, const TeMapRequest& request);

protected:
  TeProgress unit() override;

private:
  void nextCircle();
  /// Adds the present circle to a row; returns the number of samples.
  int addRow(int row);

  std::shared_ptr<const TeCircles> m_source;
  TeMapRequest m_request;
  TeRandom m_random;
  int m_index = 0; ///< of the next circle
  TeCircle m_circle;
  int m_row = 0; ///< next row of the present circle
  int m_endRow = 0;
};
