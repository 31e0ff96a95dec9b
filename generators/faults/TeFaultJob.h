#pragma once

#include "generators/TeHeightSource.h"
#include "generators/faults/TeFaultFormation.h"
#include "generators/faults/TeFaultSweep.h"

/// Makes a map by fault formation: draws the faults, then sweeps strips of columns row by row. A unit is a
/// bounded number of faults drawn, of knots moved and of samples written, whatever the map's size.
class TeFaultJob final : public TeHeightJob {
public:
  TeFaultJob(std::shared_ptr<const TeFaultFormation> source, const TeMapRequest& request);

protected:
  TeProgress unit() override;

private:
  void drawFaults();
  /// Moves some knots into the present row, or writes the row; returns the work done.
  std::int64_t sweep();
  void beginStrip(int first);

  std::shared_ptr<const TeFaultFormation> m_source;
  TeMapRequest m_request;
  TeFaultSweep m_sweep;
  int m_drawn = 0;
  int m_stripFirst = 0;
  int m_stripWidth = 0;
  int m_row = 0;
  std::size_t m_knot = 0; ///< knots that are in the present row
  std::vector<std::int64_t> m_sums;
};
